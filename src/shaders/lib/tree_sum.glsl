// The sum of sources (Eq. 8) over the tree of surfels. Needs, before it, BINDING_NODES and
// what lib/surfel_sum.glsl needs.
//
// A node stands for its surfels up to their second moments. For flux F about a centroid at the
// offset o, with s = o·o, mean moments M and the profile f(s), it gives F (f + f' tr M + 2 f'' oᵀM
// o). What is left out decides whether the node is taken or opened.
#ifndef OPALINE_LIB_TREE_SUM
#define OPALINE_LIB_TREE_SUM
#include "lib/darkest.glsl"
#include "lib/lesser.glsl"
#include "lib/multipole.glsl"
#include "lib/surfel_sum.glsl"
#include "lib/pi.glsl"
#include "lib/tree_node.glsl"
#include "shared/nearby.h"

// Whether there is an estimate of the sum, by which nodes are tolerated. Without one a node is taken wherever its series
// converges.
layout(constant_id = 1) const uint estimated = 0u;
// Whether there are coarse sources (shared/nearby.h).
layout(constant_id = 2) const uint withCoarse = 0u;

// A node is opened nearer than this many of its radii, squared, because the series would not converge there.
const float nearestInRadii2 = 2.0;

// In a node whose surfels lie evenly about its centroid, the first term left out that does not cancel
// is of fourth order, F g⁴ f⁗/24 with the mean square g². This much of it counts as the error.
const float neglectedPart = 1.0;

Derivatives profileDerivatives(Profile profile, vec3 squaredMm2) {
  return transport == 0u ? dipoleDerivatives(profile, squaredMm2)
                         : betterDipoleDerivatives(profile, squaredMm2);
}

TreeNode readNode(uint index) {
  int first = 5 * int(index);
  vec4 red = texelOf(nodes, first);
  vec4 green = texelOf(nodes, first + 1);
  vec4 blue = texelOf(nodes, first + 2);
  vec4 flux = texelOf(nodes, first + 3);
  return TreeNode(red.xyz, red.w, green.xyz, floatBitsToUint(green.w), blue.xyz, blue.w, flux.xyz,
                  flux.w, texelOf(nodes, first + 4));
}

// Squared distances to the centroids of the three channels' flux.
vec3 squaredDistances(TreeNode node, vec3 position) {
  vec3 red = node.red - position;
  vec3 green = node.green - position;
  vec3 blue = node.blue - position;
  return vec3(dot(red, red), dot(green, green), dot(blue, blue));
}

// What is below a node and no nearer than the reach counts for nothing where it is at most this
// part of what is tolerated.
const float negligiblePart = 0.1;

// No source below a node is nearer than this squared distance, mm².
float nearestSquare(vec3 squared, float radius) {
  float nearest = max(sqrt(leastOf(squared)) - radius, 0.0);
  return nearest * nearest;
}

// No node is opened to find what nobody could see beyond the reach of coarse sources.
bool isNegligible(TreeNode node, vec3 squared, Profile profile, float reach, vec3 tolerated) {
  float nearest = max(nearestSquare(squared, node.radius), reach * reach);
  vec3 most = node.flux * reflectanceProfile(profile, vec3(nearest));
  return all(lessThanEqual(most, negligiblePart * tolerated));
}

// Adds a node to the sum and returns true, or returns false where that could be off by more than tolerated.
bool takeNode(TreeNode node, vec3 position, Profile profile, float reach, vec3 tolerated,
              inout vec4 sum) {
  vec3 squared = squaredDistances(node, position);
  if (withCoarse != 0u && reach > 0.0 && isNegligible(node, squared, profile, reach, tolerated)) {
    sum.a += 1.0;
    return true;
  }
  if (leastOf(squared) <= nearestInRadii2 * node.radius * node.radius ||
      nearestSquare(squared, node.radius) <= reach * reach)
    return false;

  Derivatives f = profileDerivatives(profile, squared);
  float meanSquare = meanSquareOf(node);
  if (estimated != 0u) {
    vec3 x = profile.sigmaTr * sqrt(squared);
    vec3 neglected = neglectedPart * meanSquare * meanSquare * f.second * (4.0 + x) * (6.0 + x);
    if (any(greaterThan(node.flux * neglected, tolerated))) return false;
  }
  vec3 offset = (node.red + node.green + node.blue) / 3.0 - position;
  float along = dot(offset, momentsOf(node) * offset);
  sum += vec4(node.flux * (f.value + f.first * meanSquare + 2.0 * f.second * along), 1.0);
  return true;
}

// The invocations of a subgroup go through the tree in step, but each takes part only in the nodes
// it has itself to look at, so that what it finds does not depend on its neighbours. Those with
// nothing to sum call it with noNode as root. `tolerated` is per node. The fourth component counts
// evaluations of the profile. Leaves are opened outside the walk, because a device that executes
// both sides of every branch would evaluate a source at each node.
vec4 treeSum(vec3 position, uint root, uint end, Profile profile, float reach, vec3 tolerated) {
  vec4 sum = vec4(0.0);
  uint next = root;
  while (true) {
    uint at;
    uint opened = 0u;  // link of a leaf, which is not 0
    do {
      at = subgroupMin(next);
      if (next == at && at != noNode) {
        TreeNode node = readNode(at);
        bool taken = node.flux == vec3(0.0) || takeNode(node, position, profile, reach, tolerated, sum);
        if (!taken && isLeaf(node.link)) opened = node.link;
        next = taken ? afterNode(at, node.link) : at + 1u;
        if (next >= end) next = noNode;
      }
    } while (at != noNode && subgroupMax(opened) == 0u);
    if (at == noNode) break;
    if (opened != 0u) {
      uint first = firstSurfelOf(opened);
      sum += surfelSum(position, profile, reach, first, first + surfelCountOf(opened));
    }
  }
  return max(sum, vec4(0.0));  // a series may end below 0 where next to nothing arrives
}

// The profile for a rough sum, in which what coarse sources lack is spread over their reach.
vec3 roughProfile(ObjectData body, Profile profile, float squared) {
  float reach2 = max(body.darkest.w * body.darkest.w, 1e-30);
  vec3 lacking = body.nearbyDisc.rgb + body.nearbyInner.rgb + body.nearbyOuter.rgb;
  return reflectanceProfile(profile, vec3(smoothedSquare(squared, reach2))) +
         lacking * exp(-squared / reach2) / (pi * reach2);
}

// A node further across than this, in the longest diffusion lengths, does not count as if it all
// lay in its middle.
const float widestInLengths = 2.0;

bool isWide(TreeNode node, ObjectData body, Profile profile) {
  float least = leastOf(profile.sigmaTr);
  return node.radius * least > widestInLengths ||
         body.darkest.w > 0.0 && node.radius > body.darkest.w;
}

// About how bright a place is, by some thirty evaluations. Leaves, and nodes seen from outside
// their radius, count as if all their flux lay at its mean square distance. Wide nodes must be
// opened, because most of what they give comes from their nearest end.
vec3 roughSum(vec3 position, ObjectData body, uint root, Profile profile) {
  vec3 sum = vec3(0.0);
  vec3 darkest = darkestOf(body, root);
  uint next = root;
  while (true) {
    uint at = subgroupMin(next);
    if (at == noNode) break;
    if (next == at) {
      TreeNode node = readNode(at);
      vec3 squared = squaredDistances(node, position);
      bool taken = isLeaf(node.link) || node.flux == vec3(0.0) ||
                   squared.g > node.radius * node.radius;
      if (taken && !isLeaf(node.link) && isWide(node, body, profile)) {
        vec3 most = node.flux * roughProfile(body, profile, nearestSquare(squared, node.radius));
        taken = all(lessThanEqual(most, max(darkest, negligiblePart * sum)));
      }
      if (taken) sum += node.flux * roughProfile(body, profile, squared.g + meanSquareOf(node));
      next = taken ? afterNode(at, node.link) : at + 1u;
      if (next >= body.tree.y) next = noNode;
    }
  }
  return sum;
}

#endif
