// The leaves of the tree from the sources of their surfels.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/linear.glsl"
#include "lib/texels.glsl"
#include "lib/tree_node.glsl"

layout(std430, set = 0, binding = 0) readonly buffer Links { uint links[]; };
layout(std430, set = 0, binding = 1) readonly buffer LeafNodes { uint leafNodes[]; };
TEXELS(2, sources);  // Source
layout(std430, set = 0, binding = 3) writeonly buffer Nodes { TreeNode nodes[]; };

layout(std430, set = 0, binding = 4) writeonly buffer Boxes { NodeBox boxes[]; };

layout(push_constant) uniform Push {
  uint leafCount;
};

void main() {
  uint i = linearIndex();
  if (i >= leafCount) return;
  uint node = leafNodes[i];
  uint link = links[node];
  uint from = sourcesPerSurfel * firstSurfelOf(link);
  uint to = from + sourcesPerSurfel * surfelCountOf(link);

  vec3 flux = vec3(0.0);
  float area = 0.0;
  mat3 weighted = mat3(0.0);
  vec3 byArea = vec3(0.0);
  for (uint s = from; s < to; ++s) {
    vec4 place = texelOf(sources, 2 * int(s));
    vec3 f = texelOf(sources, 2 * int(s) + 1).rgb;
    flux += f;
    area += place.w;
    byArea += place.w * place.xyz;
    weighted += outerProduct(place.xyz, f);
  }
  float all = flux.r + flux.g + flux.b;
  vec3 middle = all > 0.0    ? (weighted[0] + weighted[1] + weighted[2]) / all
                : area > 0.0 ? byArea / area
                             : texelOf(sources, 2 * int(from)).xyz;
  mat3 centroids;
  for (int c = 0; c < 3; ++c) centroids[c] = flux[c] > 0.0 ? weighted[c] / flux[c] : middle;

  float radius = 0.0;
  vec3 low = middle;
  vec3 high = middle;
  mat3 moments = mat3(0.0);
  for (uint s = from; s < to; ++s) {
    vec4 place = texelOf(sources, 2 * int(s));
    vec3 f = texelOf(sources, 2 * int(s) + 1).rgb;
    low = min(low, place.xyz);
    high = max(high, place.xyz);
    for (int c = 0; c < 3; ++c) {
      vec3 offset = place.xyz - centroids[c];
      moments += f[c] * outerProduct(offset, offset);
      radius = max(radius, length(offset));
    }
  }
  if (all > 0.0) moments /= all;
  boxes[node] = NodeBox(vec4(low, 0.0), vec4(high, 0.0));
  nodes[node] = makeNode(centroids, radius, link, flux, moments);
}
