// Where a list of rays meets a surface, nearest; or how often each meets it at all.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#define BINDING_PIECE_CORNERS 0
#define BINDING_RAY_BOXES 1
#include "lib/linear.glsl"
#include "lib/rays.glsl"

struct TestRay {
  vec4 originFrom;   // w: least distance
  vec4 directionTo;  // w: greatest
};

layout(std430, set = 0, binding = 2) readonly buffer Rays { TestRay rays[]; };
layout(std430, set = 0, binding = 3) writeonly buffer Hits { uvec2 hits[]; };  // distance, piece

layout(push_constant) uniform Push {
  uint count;
  uint firstNode;
  uint endNode;
  float apart;  // of hits that are to be counted, mm; 0: the nearest is wanted
};

void main() {
  uint i = linearIndex();
  if (i >= count) return;
  TestRay ray = rays[i];
  RayHit hit = nearestHit(ray.originFrom.xyz, ray.directionTo.xyz, ray.originFrom.w,
                          ray.directionTo.w, firstNode, endNode);
  uint met = hit.piece;
  if (apart > 0.0) {
    for (met = 0u; hit.piece != noPiece && met < 1000u; ++met)
      hit = nearestHit(ray.originFrom.xyz, ray.directionTo.xyz, hit.distance + apart,
                       ray.directionTo.w, firstNode, endNode);
  }
  hits[i] = uvec2(floatBitsToUint(hit.distance), met);
}
