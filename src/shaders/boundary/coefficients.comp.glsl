// The coefficients of the operator of the boundary's equation, for each node of a tile's list and each of the
// tile's clusters. Every step of the solver takes a product with them; see boundary/product.comp.glsl.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#extension GL_KHR_shader_subgroup_basic : require
#define BINDING_OBJECTS 0
#define BINDING_MEDIA 1
#define BINDING_TILES 2
#define BINDING_CLUSTER_NODES 4
#define BINDING_NODE_OBJECTS 5
#define CONSTANT_SEVERAL_MEDIA 0
#include "lib/cluster_action.glsl"
#include "lib/halves.glsl"

layout(std430, set = 0, binding = 6) readonly buffer Lists { uint lists[]; };
layout(std430, set = 0, binding = 7) writeonly buffer Coefficients { vec4 coefficients[]; };

layout(push_constant) uniform Push {
  uint tileCount;
  float openingAngle;
  uint roomOfList;
  uint roomOfCoefficients;  // in nodes
};

void put(uint first, ActingNode node) {
  vec3 weightS = singleLayerWeight(medium);
  float numbers[4u * texelsOfActions];
  [[unroll]] for (uint t = 0u; t < maxClustersOfTile; ++t) {
    Action action = actionOn(t, node, weightS, openingAngle);
    [[unroll]] for (uint c = 0u; c < 3u; ++c) numbers[3u * t + c] = packed(action.ofDensity[c], action.ofDipole[c]);
  }
  [[unroll]] for (uint i = 0u; i < texelsOfActions; ++i)
    coefficients[first + i] = vec4(numbers[4u * i], numbers[4u * i + 1u], numbers[4u * i + 2u], numbers[4u * i + 3u]);
}

void main() {
  if (!enterTile(tileCount)) return;
  takeWayOfTile();
  uint list = tileIndex * roomOfList;
  uint count = lists[list];
  if (count >= roomOfList) return;  // there is no list
  uint kept = min(count, roomOfCoefficients);
  for (uint k = gl_LocalInvocationIndex; k < kept; k += invocationsOfTile)
    put((tileIndex * roomOfCoefficients + k) * texelsOfActions, actingNode(lists[list + 1u + k]));
}
