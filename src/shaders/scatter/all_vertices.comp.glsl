// A range of all sources, added to the exitance of every vertex.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 4
#define BINDING_MEDIA 5
#define BINDING_SOURCES 6
#include "lib/scatter.glsl"
#include "shared/mesh.h"
#include "lib/linear.glsl"

layout(std430, set = 0, binding = 1) readonly buffer Positions { vec4 positions[]; };
layout(std430, set = 0, binding = 2) readonly buffer Corners { AtlasCorner corners[]; };  // one a vertex
layout(std430, set = 0, binding = 3) buffer Exitance { vec4 exitances[]; };

layout(push_constant) uniform Push {
  uint vertexCount;
  uint firstSource;
  uint lastSource;
};

void main() {
  uint i = linearIndex();
  if (i >= vertexCount) return;
  vec4 value = firstSource == 0u ? vec4(0.0, 0.0, 0.0, 1.0) : exitances[i];
  value.rgb += sourceSum(positions[i].xyz, corners[i].object, firstSource, lastSource);
  exitances[i] = value;
}
