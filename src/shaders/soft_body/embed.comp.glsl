// Where a soft body's vertices are. Quadratic B-splines over the cage's grid move them; their slope
// is continuous, so that no cell shows.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/linear.glsl"
#include "lib/texels.glsl"

layout(std430, set = 0, binding = 0) readonly buffer Rest { float rest[]; };  // three per vertex, mm
TEXELS(1, grid);
layout(std430, set = 0, binding = 2) writeonly buffer Positions { float positions[]; };

layout(push_constant) uniform Push {
  vec4 origin;  // xyz: of the grid, mm; w: edge of a cell, mm
  uvec4 size;   // xyz: of the grid; w: vertices
};

void main() {
  uint v = linearIndex();
  if (v >= size.w) return;
  vec3 at = vec3(rest[3u * v], rest[3u * v + 1u], rest[3u * v + 2u]);
  vec3 place = (at - origin.xyz) / origin.w;
  vec3 middle = floor(place + 0.5);
  if (all(greaterThanEqual(middle, vec3(1.0))) && all(lessThan(middle, vec3(size.xyz) - 1.0))) {
    vec3 t = place - middle;
    vec3 weights[3] = vec3[3](0.5 * (0.5 - t) * (0.5 - t), 0.75 - t * t, 0.5 * (0.5 + t) * (0.5 + t));
    uvec3 first = uvec3(middle) - 1u;
    vec3 shift = vec3(0.0);
    for (uint z = 0u; z < 3u; ++z)
      for (uint y = 0u; y < 3u; ++y) {
        int row = int(first.x + size.x * (first.y + y + size.y * (first.z + z)));
        vec3 sum = vec3(0.0);
        for (int x = 0; x < 3; ++x) sum += weights[x].x * texelOf(grid, row + x).xyz;
        shift += weights[y].y * weights[z].z * sum;
      }
    at += origin.w * shift;
  }
  for (uint axis = 0u; axis < 3u; ++axis) positions[3u * v + axis] = at[axis];
}
