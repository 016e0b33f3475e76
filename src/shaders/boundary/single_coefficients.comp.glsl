// What is kept for the sums of boundary/single.comp.glsl; see boundary/source_coefficients.comp.glsl.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#define CONSTANT_SEVERAL_MEDIA 1
#include "lib/beam_coefficients.glsl"
#include "lib/single_points.glsl"

void putPoints(uint cluster) {
  addPoints(cluster, vec3(1.0));
}

void putNode(BeamNode node, vec3 power) {
  addNodeOf(node, power);
}

// It depends on a cluster's normal, so has no expansion.
void putPointsApart(uint cluster, vec3 middle) {
  putPoints(cluster);
}

void putNodeApart(BeamNode node, vec3 power, vec3 middle) {
  putNode(node, power);
}

void main() {
  if (!enterTile(tileCount)) return;
  takeSurface();
  takeWayOfTile();
  light = 0u;
  keepList(aroundTile(), 0.0);
}
