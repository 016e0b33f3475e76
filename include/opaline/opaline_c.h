#pragma once

/// The C interface, C11. Handles are opaque, no exception leaves a call, and structs keep their
/// layout: a struct begins with its own size, so that later versions can add members at its end.
///
/// Fill a struct that has defaults in this way, and then change what you like:
///
///     OpalineRenderOptions options = {.size = sizeof options};
///     opalineDefaultRenderOptions(&options);
///
/// Every call that can fail returns a status. After a failure opalineLastError() has the reason,
/// and what the call was to fill is unchanged. A handle is made by one call and destroyed by
/// another, which also takes NULL. A handle that was destroyed, or is of another kind, is refused
/// with OpalineBadUse as long as no new handle has taken its place in memory. Unless said
/// otherwise, pointers are needed only during the call, texts are UTF-8 and end with a zero byte,
/// and lengths are in millimetres. Calls with different renderers may come from different threads.
/// Calls with one renderer and its views must come from one thread at a time, as must those with
/// one scene.

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
