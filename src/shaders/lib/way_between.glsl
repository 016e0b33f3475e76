// The medium between a tile and a node that acts on it, where bodies may be of several media: the mean of
// the media at either end. Needs, before it, BINDING_NODE_OBJECTS, the constant's number
// CONSTANT_SEVERAL_MEDIA, and what lib/cluster_tile.glsl needs.
#ifndef OPALINE_LIB_WAY_BETWEEN
#define OPALINE_LIB_WAY_BETWEEN
#include "lib/cluster_tile.glsl"

layout(constant_id = CONSTANT_SEVERAL_MEDIA) const uint withSeveralMedia = 0u;

layout(std430, set = 0, binding = BINDING_NODE_OBJECTS) readonly buffer NodeObjects { uint objectOfNode[]; };

struct WayBetween {
  vec3 sigma;          // 1/mm
  vec3 extinction;     // 1/mm
  vec3 overDiffusion;  // D of the tile's medium over that in between
};

WayBetween way;

void takeWayOfTile() {
  way = WayBetween(medium.sigma.rgb, medium.collision.rgb, vec3(1.0));
}

void takeWayFrom(uint node) {
  if (withSeveralMedia == 0u) return;
  BoundaryMedium there = insideOf(objects[objectOfNode[node]]);
  way.sigma = 0.5 * (medium.sigma.rgb + there.sigma.rgb);
  way.extinction = 0.5 * (medium.collision.rgb + there.collision.rgb);
  way.overDiffusion = 2.0 * medium.diffusion.rgb / (medium.diffusion.rgb + there.diffusion.rgb);
}

// e^{-σr} / r at a squared distance.
vec3 kernel(vec3 squared) {
  vec3 over = inversesqrt(squared);
  return exp(-way.sigma * (squared * over)) * over;
}

#endif
