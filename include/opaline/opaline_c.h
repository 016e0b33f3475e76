#pragma once

/// The C interface, C11. Handles are opaque, no exception leaves a call, and structs keep their
/// layout: a struct begins with its own size, so that later versions can add members at its end.
///
/// Fill a struct that has defaults in this way, and then change what you like:
///
///     OpalineRenderOptions options = {.size = sizeof options};
///     opalineDefaultRenderOptions(&options);
///
/// Every call that can fail returns a status; opalineLastError() has the reason, and what the call
/// was to fill stays as it was. A handle is made by one call and destroyed by another, which takes
/// NULL too. One that was destroyed, or is of another kind, is refused as OpalineBadUse as long as
/// no new handle has taken its place in memory. Unless said otherwise pointers are
/// needed only during the call, texts are UTF-8 and end with a zero byte, and lengths are
/// millimetres. Calls with different renderers may come from different threads; those with one
/// renderer, or a view of it, come from one thread at a time, as do those with one scene.

#include "opaline/c/lights.h"
#include "opaline/c/log.h"
#include "opaline/c/materials.h"
#include "opaline/c/media.h"
#include "opaline/c/motion.h"
#include "opaline/c/pictures.h"
#include "opaline/c/rendering.h"
#include "opaline/c/reports.h"
#include "opaline/c/scenes.h"
#include "opaline/c/soft_body.h"
#include "opaline/c/status.h"
#include "opaline/c/vulkan.h"
