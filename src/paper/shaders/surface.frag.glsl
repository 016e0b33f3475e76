// What the camera sees, as scatter/surface.frag.glsl has it, and where that lies in the map.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/unit.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 place;
layout(location = 3) in vec4 exitance;
layout(location = 4) flat in uint object;
layout(location = 5) flat in float side;  // -1 where the triangle is mirrored

layout(location = 0) out vec4 positionObject;  // mm; object + 1
layout(location = 1) out vec4 unitNormal;      // towards the side that is seen; -1: the inside
layout(location = 2) out vec2 placeNearby;     // among the neighbourhoods
layout(location = 3) out vec4 vertexExitance;  // interpolated

void main() {
  positionObject = vec4(position, float(object + 1u));
  float seen = gl_FrontFacing == (side > 0.0) ? 1.0 : -1.0;
  unitNormal = vec4(seen * unitOr(normal, vec3(0.0, 1.0, 0.0)), seen);
  placeNearby = place;
  vertexExitance = exitance;
}
