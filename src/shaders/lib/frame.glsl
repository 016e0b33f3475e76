// The frame's uniform block, at binding 0 of every shader that includes this.
#ifndef OPALINE_LIB_FRAME
#define OPALINE_LIB_FRAME
#include "shared/frame.h"

layout(std140, set = 0, binding = 0) uniform Frame { FrameData frame; };

// From a place to the camera, of any length.
vec3 toCameraFrom(vec3 place) {
  return frame.cameraPosition.xyz - frame.cameraPosition.w * place;
}

#endif
