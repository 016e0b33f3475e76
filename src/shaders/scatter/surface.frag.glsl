// What the camera sees, one fragment a pixel: the sum that follows is spent on nothing hidden.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/octahedron.glsl"
#include "lib/unit.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 exitance;
layout(location = 3) flat in uint object;
layout(location = 4) flat in float side;  // -1 where the triangle is mirrored

layout(location = 0) out vec4 positionObject;  // mm; object + 1
layout(location = 1) out vec4 unitNormal;      // towards the side that is seen; -1: the inside
layout(location = 2) out vec4 vertexExitance;  // interpolated
layout(location = 3) out vec2 facet;           // unit, at right angles to the triangle, to either side

void main() {
  vec3 n = unitOr(normal, vec3(0.0, 1.0, 0.0));
  positionObject = vec4(position, float(object + 1u));
  float seen = gl_FrontFacing == (side > 0.0) ? 1.0 : -1.0;
  unitNormal = vec4(seen * n, seen);
  vertexExitance = exitance;
  vec3 right = dFdx(position);
  vec3 down = dFdy(position);
  facet = toOctahedron(unitOr(cross(unitOr(right, vec3(0.0)), unitOr(down, vec3(0.0))), n));
}
