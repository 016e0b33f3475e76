// The nearest hit of each ray in a list, or the number of its hits.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_PIECE_CORNERS 0
#define BINDING_RAYS 1
#include "lib/linear.glsl"
#include "lib/rays.glsl"

struct TestRay {
  vec4 originFrom;   // w: least distance
  vec4 directionTo;  // w: greatest
};

struct TestHit {
  vec4 normalDistance;
  uvec4 found;  // piece or number of hits, object, whether anything is in the way
};

layout(std430, set = 0, binding = 2) readonly buffer Rays { TestRay rays[]; };
layout(std430, set = 0, binding = 3) writeonly buffer Hits { TestHit hits[]; };

layout(std430, set = 0, binding = 4) readonly buffer FirstPieces { uint firstPieces[]; };

layout(push_constant) uniform Push {
  uint count;
  uint firstNode;
  uint endNode;
  uint object;  // or everyObject
  float apart;  // minimum distance of counted hits, mm; 0: find the nearest hit
};

uint firstPieceOf(uint object) {
  return firstPieces[object];
}

void main() {
  uint i = linearIndex();
  if (i >= count) return;
  RayTarget target = RayTarget(firstNode, endNode, object);
  TestRay ray = rays[i];
  RayHit hit = nearestHit(ray.originFrom.xyz, ray.directionTo.xyz, ray.originFrom.w,
                          ray.directionTo.w, target);
  uint met = hit.piece;
  if (apart > 0.0) {
    for (met = 0u; hit.piece != noPiece && met < 1000u; ++met)
      hit = nearestHit(ray.originFrom.xyz, ray.directionTo.xyz, hit.distance + apart,
                       ray.directionTo.w, target);
  }
  bool hitOne = apart == 0.0 && hit.piece != noPiece;
  bool blocked = occluded(ray.originFrom.xyz, ray.directionTo.xyz, ray.originFrom.w,
                          ray.directionTo.w, target);
  hits[i] = TestHit(vec4(hitOne ? facetNormal(hit.piece) : vec3(0.0), hit.distance),
                    uvec4(met, hitOne ? objectOfPiece(hit.piece) : 0u, uint(blocked), 0u));
}
