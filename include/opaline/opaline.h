#pragma once

/// All of the C++ interface. Each subject has a header of its own, which is its reference.

#include "opaline/error.h"
#include "opaline/export.h"
#include "opaline/exposure.h"
#include "opaline/image.h"
#include "opaline/log.h"
#include "opaline/material.h"
#include "opaline/medium.h"
#include "opaline/motion.h"
#include "opaline/render_options.h"
#include "opaline/renderer.h"
#include "opaline/scene.h"
#include "opaline/sequence.h"
#include "opaline/soft_body.h"
#include "opaline/types.h"
#include "opaline/version.h"
#include "opaline/view.h"
#include "opaline/vulkan.h"
