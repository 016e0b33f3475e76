// Parts of clusters, each of a few surfels: where they are in this frame.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_SOURCES 1
#include "lib/linear.glsl"
#include "lib/surfel_area.glsl"
#include "shared/boundary.h"

layout(std430, set = 0, binding = 0) readonly buffer Ranges { ClusterRange ranges[]; };
layout(std430, set = 0, binding = 2) readonly buffer Places { vec4 places[]; };  // of surfels
layout(std430, set = 0, binding = 3) writeonly buffer Patches { vec4 patches[]; };

layout(push_constant) uniform Push {
  uint clusterCount;
};

void main() {
  uint i = linearIndex();
  if (i >= clusterCount) return;
  ClusterRange range = ranges[i];
  for (uint k = 0u; k < patchesOf(range); ++k) {
    uint first = range.firstSurfel + k * surfelsOfPatch;
    vec3 sum = vec3(0.0);
    float all = 0.0;
    for (uint surfel = first; surfel < min(first + surfelsOfPatch, range.endSurfel); ++surfel) {
      float area = areaOfSurfel(surfel);
      sum += area * places[surfel].xyz;
      all += area;
    }
    patches[range.firstPatch + k] = vec4(all > 0.0 ? sum / all : places[first].xyz, all);
  }
}
