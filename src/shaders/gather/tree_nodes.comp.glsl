// Inner nodes of the tree from their children.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_TREELETS 0
#include "lib/treelets.glsl"

layout(std430, set = 0, binding = 4) coherent buffer Nodes { TreeNode nodes[]; };
layout(std430, set = 0, binding = 5) coherent buffer Boxes { NodeBox boxes[]; };

layout(push_constant) uniform Push {
  uint firstTreelet;
  uint treeletCount;
};

void fitNode(uint node, uint link) {
  uint end = afterNode(node, link);

  vec3 flux = vec3(0.0);
  mat3 weighted = mat3(0.0);
  vec3 middles = vec3(0.0);
  float children = 0.0;
  for (uint child = node + 1u; child < end; child = afterNode(child, links[child])) {
    TreeNode below = nodes[child];
    vec3 f = below.flux;
    mat3 centroids = centroidsOf(below);
    flux += f;
    for (int c = 0; c < 3; ++c) weighted[c] += f[c] * centroids[c];
    middles += below.red;  // the same for all channels where there is no flux
    children += 1.0;
  }
  float all = flux.r + flux.g + flux.b;
  vec3 middle = all > 0.0 ? (weighted[0] + weighted[1] + weighted[2]) / all : middles / children;
  mat3 centroids;
  for (int c = 0; c < 3; ++c) centroids[c] = flux[c] > 0.0 ? weighted[c] / flux[c] : middle;

  // No source lies further than the furthest of any child may, nor further than the box's furthest corner.
  float radius = 0.0;
  vec3 low = boxes[node + 1u].low.xyz;
  vec3 high = boxes[node + 1u].high.xyz;
  mat3 moments = mat3(0.0);
  for (uint child = node + 1u; child < end; child = afterNode(child, links[child])) {
    TreeNode below = nodes[child];
    vec3 f = below.flux;
    moments += (f.r + f.g + f.b) * momentsOf(below);
    low = min(low, boxes[child].low.xyz);
    high = max(high, boxes[child].high.xyz);
    mat3 theirs = centroidsOf(below);
    for (int c = 0; c < 3; ++c) {
      vec3 offset = theirs[c] - centroids[c];
      moments += f[c] * outerProduct(offset, offset);
      radius = max(radius, length(offset) + below.radius);
    }
  }
  float toCorner = 0.0;
  for (int c = 0; c < 3; ++c)
    toCorner = max(toCorner, length(max(high - centroids[c], centroids[c] - low)));
  radius = min(radius, toCorner);
  boxes[node] = NodeBox(vec4(low, 0.0), vec4(high, 0.0));
  if (all > 0.0) moments /= all;
  nodes[node] = makeNode(centroids, radius, link, flux, moments);
}

void main() {
  fitTreelets(firstTreelet, treeletCount);
}
