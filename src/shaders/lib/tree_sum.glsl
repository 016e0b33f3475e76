// The sum of sources (Eq. 8) over the tree of surfels. Needs, before it, BINDING_NODES and
// what lib/surfel_sum.glsl needs.
//
// A node stands for its surfels up to their second moments: for flux F about a centroid at the
// offset o, with s = o·o and mean moments M, F (f + f' tr M + 2 f'' oᵀM o), where f(s) is the
// profile. What is left out decides whether the node is taken or opened.
#ifndef OPALINE_LIB_TREE_SUM
#define OPALINE_LIB_TREE_SUM
#include "lib/multipole.glsl"
#include "lib/surfel_sum.glsl"
#include "lib/tree_node.glsl"

layout(set = 0, binding = BINDING_NODES) uniform samplerBuffer nodes;  // TreeNode

// A node is opened nearer than this many of its radii, squared: there the series would not converge.
const float nearestInRadii2 = 2.0;

// The first term left out that does not cancel in a node whose surfels lie evenly about its
// centroid is of fourth order, F g⁴ f⁗/24 with the mean square g²; of that, this much.
const float neglectedPart = 1.0;

Derivatives profileDerivatives(Profile profile, vec3 squaredMm2) {
  return transport == 0u ? dipoleDerivatives(profile, squaredMm2)
                         : betterDipoleDerivatives(profile, squaredMm2);
}

TreeNode readNode(uint index) {
  int first = 5 * int(index);
  vec4 red = texelFetch(nodes, first);
  vec4 green = texelFetch(nodes, first + 1);
  vec4 blue = texelFetch(nodes, first + 2);
  vec4 flux = texelFetch(nodes, first + 3);
  return TreeNode(red.xyz, red.w, green.xyz, floatBitsToUint(green.w), blue.xyz, blue.w, flux.xyz,
                  flux.w, texelFetch(nodes, first + 4));
}

// Squared distances to the centroids of the three channels' flux.
vec3 squaredDistances(TreeNode node, vec3 position) {
  vec3 red = node.red - position;
  vec3 green = node.green - position;
  vec3 blue = node.blue - position;
  return vec3(dot(red, red), dot(green, green), dot(blue, blue));
}

// Adds a node to the sum and says so, or does not where that could be off by more than tolerated.
bool takeNode(TreeNode node, vec3 position, Profile profile, vec3 tolerated, inout vec4 sum) {
  vec3 squared = squaredDistances(node, position);
  if (min(min(squared.r, squared.g), squared.b) <= nearestInRadii2 * node.radius * node.radius)
    return false;

  Derivatives f = profileDerivatives(profile, squared);
  float meanSquare = meanSquareOf(node);
  vec3 x = profile.sigmaTr * sqrt(squared);
  vec3 neglected = neglectedPart * meanSquare * meanSquare * f.second * (4.0 + x) * (6.0 + x);
  if (any(greaterThan(node.flux * neglected, tolerated))) return false;
  vec3 offset = (node.red + node.green + node.blue) / 3.0 - position;
  float along = dot(offset, momentsOf(node) * offset);
  sum += vec4(node.flux * (f.value + f.first * meanSquare + 2.0 * f.second * along), 1.0);
  return true;
}

// The invocations of a subgroup go through the tree in step, each taking part in the nodes it has
// itself to look at: what one finds does not depend on its neighbours. Those with nothing to sum
// call it with noNode as root. `tolerated` is of each node. The fourth component counts evaluations
// of the profile.
vec4 treeSum(vec3 position, uint root, uint end, Profile profile, vec3 tolerated) {
  vec4 sum = vec4(0.0);
  uint next = root;
  while (true) {
    uint at = subgroupMin(next);
    if (at == noNode) break;
    if (next == at) {
      TreeNode node = readNode(at);
      bool dark = node.flux == vec3(0.0);
      bool taken = dark || takeNode(node, position, profile, tolerated, sum);
      if (!taken && isLeaf(node.link)) {
        uint first = firstSurfelOf(node.link);
        uint count = surfelCountOf(node.link);
        sum += vec4(surfelSum(position, profile, first, first + count), float(sourcesPerSurfel * count));
        taken = true;
      }
      next = taken ? afterNode(at, node.link) : at + 1u;
      if (next >= end) next = noNode;
    }
  }
  return sum;
}

// About how bright a place is, by some thirty evaluations: nodes outside their radius and leaves
// count as if all their flux lay as far away as it does in the mean square.
vec3 roughSum(vec3 position, uint root, uint end, Profile profile) {
  vec3 sum = vec3(0.0);
  uint next = root;
  while (true) {
    uint at = subgroupMin(next);
    if (at == noNode) break;
    if (next == at) {
      TreeNode node = readNode(at);
      vec3 squared = squaredDistances(node, position);
      bool taken = isLeaf(node.link) || node.flux == vec3(0.0) ||
                   squared.g > node.radius * node.radius;
      if (taken) sum += node.flux * reflectanceProfile(profile, squared + meanSquareOf(node));
      next = taken ? afterNode(at, node.link) : at + 1u;
      if (next >= end) next = noNode;
    }
  }
  return sum;
}

#endif
