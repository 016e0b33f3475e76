// What opaque clusters give back: first of all that comes from lights and the sky, then of what other
// clusters send them. What surfaces find for themselves (lib/opaque.glsl) is not kept for them.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 1
#define BINDING_MEDIA 2
#include "lib/frame.glsl"
#include "lib/light.glsl"
#include "lib/linear.glsl"
#include "lib/material.glsl"
#include "shared/boundary.h"

layout(std430, set = 0, binding = 3) readonly buffer Ranges { ClusterRange ranges[]; };
layout(std430, set = 0, binding = 4) readonly buffer Clusters { Cluster clusters[]; };
layout(std430, set = 0, binding = 5) readonly buffer Entries { Entry entries[]; };
layout(std430, set = 0, binding = 6) readonly buffer SkyShares { vec4 skyShares[]; };
layout(std430, set = 0, binding = 7) readonly buffer Entered { vec4 entered[]; };
layout(std430, set = 0, binding = 8) writeonly buffer Latest { vec4 latest[]; };
layout(std430, set = 0, binding = 9) writeonly buffer EnteredBefore { vec4 enteredBefore[]; };
layout(std430, set = 0, binding = 10) buffer Exitances { vec4 exitances[]; };

layout(push_constant) uniform Push {
  uint clusterCount;
  uint again;  // 1: of what other clusters send
};

void main() {
  uint i = linearIndex();
  if (i >= clusterCount || ranges[i].kind != opaqueBody) return;
  vec3 place = clusters[i].centroidArea.xyz;
  vec3 share = mediumAt(objects[ranges[i].object], place).opaque.rgb;
  vec3 known = vec3(0.0);
  vec3 other = vec3(0.0);
  if (again != 0u) {
    other = entered[i].rgb;
  } else {
    for (uint k = 0u; k < allLightsAt(place); ++k) {
      vec3 falls = entries[k * clusterCount + i].irradiance.rgb;
      if (k < firstAreaLight())
        known += falls;
      else
        other += falls;
    }
    other += skyShares[i].rgb * entries[frame.counts.w * clusterCount + i].irradiance.rgb;
  }
  latest[i] = vec4(share * (known + other), 0.0);
  enteredBefore[i] = vec4(0.0);
  exitances[i] = vec4((again != 0u ? exitances[i].rgb : vec3(0.0)) + share * other, 0.0);
}
