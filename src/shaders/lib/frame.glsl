// The frame's uniform block, at binding 0 of every shader that includes this.
#ifndef OPALINE_LIB_FRAME
#define OPALINE_LIB_FRAME
#include "shared/frame.h"

layout(std140, set = 0, binding = 0) uniform Frame { FrameData frame; };

#endif
