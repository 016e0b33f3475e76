// What is kept for the sums of boundary/source.comp.glsl over light from everywhere. Frames take several such sums,
// of the sky's light and of light that enters again.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#define CONSTANT_SEVERAL_MEDIA 0
#include "lib/beam_coefficients.glsl"
#include "lib/fluence_points.glsl"

void clearExpansion() {
  [[unroll]] for (uint t = 0u; t < termsOfExpansion; ++t) expansion[t] = vec3(0.0);
}

void putExpansion(vec3 middle) {
  [[unroll]] for (uint t = 0u; t < maxClustersOfTile; ++t) tileLight[t] = expandedAt(targets[t].xyz - middle);
}

void putPoints(uint cluster) {
  addPoints(senderOf(cluster, vec3(1.0)));
}

void putPointsApart(uint cluster, vec3 middle) {
  clearExpansion();
  expandPoints(senderOf(cluster, vec3(1.0)), middle);
  putExpansion(middle);
}

void putNode(BeamNode node, vec3 power) {
  addNodeOf(node, power);
}

void putNodeApart(BeamNode node, vec3 power, vec3 middle) {
  clearExpansion();
  expandNodeOf(node, power, middle);
  putExpansion(middle);
}

void main() {
  if (!enterTile(tileCount)) return;
  takeWayOfTile();
  light = 0u;
  keepList(aroundTile(), leastSigma);
}
