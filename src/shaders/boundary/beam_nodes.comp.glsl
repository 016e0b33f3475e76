// Points of light in the body on the nodes of the tree of clusters: at leaves, one per cluster, or at inner nodes.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 0
#define BINDING_MEDIA 1
#define BINDING_POINTS 2
#define BINDING_STRENGTHS 3
#define BINDING_TREELETS 4
#include "lib/beam.glsl"
#include "lib/beam_trees.glsl"
#include "lib/treelets.glsl"

layout(constant_id = 0) const uint ofLeaves = 1u;

layout(std430, set = 0, binding = 8) readonly buffer Ranges { ClusterRange ranges[]; };
layout(std430, set = 0, binding = 9) readonly buffer Clusters { Cluster clusters[]; };
layout(std430, set = 0, binding = 10) coherent buffer Nodes { BeamNode nodes[]; };

layout(push_constant) uniform Push {
  uint firstTreelet;
  uint count;         // of treelets, or of clusters
  uint firstTree;
  uint trees;
  uint kinds;  // of trees
  uint lights;
  uint clusterCount;
  uint nodeCount;  // of a tree
};

BeamTree tree;
uint root;  // of the tree

// How large points are felt to be by light that scatters once, which falls off steeply, in roots of
// their mean square distance. Fluence takes their spread into account, so that clusters of points
// feel smaller to it; but second collisions lie all around, among those of the clusters beside.
const float feltOnce = 1.4;
const float feltInARow = 1.0;
const float feltAllAround = 1.0;
const float feltOfRadius = 0.7;  // at most, of the distance of the furthest point
const float feltOfDisc = 0.25;   // at least, of the cluster's radius: next to it light is that of a disc

mat3 placesOf(BeamPoint point) {
  return mat3(point.red.xyz, point.green.xyz, point.blue.xyz);
}

mat3 centroidsOf(BeamNode node) {
  return mat3(node.redPower.xyz, node.greenLink.xyz, node.bluePower.xyz);
}

// The squares of an offset in each pair of directions, as a node has them.
struct Squares {
  vec3 same;    // xx, yy, zz
  vec3 across;  // xy, xz, yz; of light that scatters once, how it arrives
};

void add(inout Squares squares, float weight, vec3 offset) {
  squares.same += weight * offset * offset;
  if (!tree.scattersOnce) squares.across += weight * offset.xxy * offset.yzz;
}

vec3 powerOf(BeamNode node) {
  return vec3(node.redPower.w, node.extent.w, node.bluePower.w);
}

// `square` is the part that the power does not include yet.
void put(uint node, mat3 centroids, float radius, Squares squares, float square, vec3 power) {
  float apart = max(distance(centroids[0], centroids[1]), distance(centroids[2], centroids[1]));
  float size = sqrt(squares.same.x + squares.same.y + squares.same.z);
  bool dark = power == vec3(0.0);
  nodes[root + node] = BeamNode(vec4(centroids[1], uintBitsToFloat(links[node])),
                         vec4(dark ? -1.0 : radius, apart, size, power.g), vec4(centroids[0], power.r),
                         vec4(centroids[2], power.b), vec4(squares.same, square), vec4(squares.across, 0.0));
}

mat3 meansOf(mat3 weighted, vec3 power, vec3 otherwise) {
  float all = power.r + power.g + power.b;
  vec3 middle = all > 0.0 ? (weighted[0] + weighted[1] + weighted[2]) / all : otherwise;
  mat3 means;
  for (int c = 0; c < 3; ++c) means[c] = power[c] > 0.0 ? weighted[c] / power[c] : middle;
  return means;
}

void gatherLeaf(uint i) {
  Cluster cluster = clusters[i];
  uint beam = tree.light * clusterCount + i;
  BoundaryMedium medium = insideOf(objects[ranges[i].object]);
  vec4 strength = strengthOf(beam);
  float entering = cluster.centroidArea.w * largestOf(1.0 - shareAtSurface(cluster.start.w, medium));
  if (tree.ofShape) strength.rgb = vec3(entering);
  uvec2 counts = unpackPointCounts(strength.w);
  vec3 shares[2] = vec3[2](shareOfFirst(cluster), shareOfSecond(cluster, medium));
  if (tree.scattersOnce) {
    shares[0] = cluster.second.rgb;
    counts[1] = 0u;
  }

  vec3 power = vec3(0.0);
  mat3 weighted = mat3(0.0);
  for (uint order = 0u; order < 2u; ++order) {
    for (uint p = 0u; p < counts[order]; ++p) {
      BeamPoint point = readPoint(beam, order * maxFirstPoints + p);
      vec3 f = strength.rgb * shares[order] * shareOf(point);
      mat3 places = placesOf(point);
      power += f;
      for (int c = 0; c < 3; ++c) weighted[c] += f[c] * places[c];
    }
  }
  mat3 centroids = meansOf(weighted, power, cluster.centroidArea.xyz);
  float radius = 0.0;
  Squares squares = Squares(vec3(0.0), vec3(0.0));
  vec3 ofChannels = vec3(0.0);
  for (uint order = 0u; order < 2u; ++order) {
    for (uint p = 0u; p < counts[order]; ++p) {
      BeamPoint point = readPoint(beam, order * maxFirstPoints + p);
      vec3 f = strength.rgb * shares[order] * shareOf(point);
      mat3 places = placesOf(point);
      for (int c = 0; c < 3; ++c) {
        vec3 offset = places[c] - centroids[c];
        if (f[c] > 0.0) radius = max(radius, length(offset));
        add(squares, f[c], offset);
        ofChannels[c] += f[c] * dot(offset, offset);
      }
      if (tree.scattersOnce && medium.collision.w != 0.0) squares.across += (f.r + f.g + f.b) * arrivalAt(beam, p);
    }
  }
  float all = max(power.r + power.g + power.b, 1e-30);
  squares = Squares(squares.same / all, squares.across / all);
  float square = squares.same.x + squares.same.y + squares.same.z;
  float felt = tree.scattersOnce
                   ? feltOnce
                   : mix(feltInARow, feltAllAround, largestOf(cluster.second.rgb));
  float spread = felt * sqrt(square);
  if (!tree.scattersOnce) {
    // Red goes several times as far as blue, so each channel's spread enters its power here, where it is known.
    power += medium.sigma.rgb * medium.sigma.rgb / 6.0 * ofChannels;
    square = 0.0;
  }
  put(ranges[i].node, centroids, max(min(feltOfRadius * radius, spread), feltOfDisc * cluster.normal.w),
      squares, square, power);
  if (tree.ofShape) nodes[root + ranges[i].node].across.w = entering;
}

void fitNode(uint node, uint link) {
  uint end = afterNode(node, link);
  vec3 power = vec3(0.0);
  mat3 weighted = mat3(0.0);
  for (uint child = node + 1u; child < end; child = afterNode(child, links[child])) {
    vec3 f = powerOf(nodes[root + child]);
    mat3 places = centroidsOf(nodes[root + child]);
    power += f;
    for (int c = 0; c < 3; ++c) weighted[c] += f[c] * places[c];
  }
  mat3 centroids = meansOf(weighted, power, nodes[root + node + 1u].redPower.xyz);
  float felt = tree.scattersOnce ? feltOnce : feltInARow;
  float felt2 = 0.0;
  float square = 0.0;
  Squares squares = Squares(vec3(0.0), vec3(0.0));
  for (uint child = node + 1u; child < end; child = afterNode(child, links[child])) {
    vec3 f = powerOf(nodes[root + child]);
    mat3 places = centroidsOf(nodes[root + child]);
    for (int c = 0; c < 3; ++c) {
      vec3 offset = places[c] - centroids[c];
      float away2 = dot(offset, offset);
      felt2 += f[c] * (felt * felt * away2 +
                       nodes[root + child].extent.x * nodes[root + child].extent.x);
      add(squares, f[c], offset);
      square += f[c] * (away2 + nodes[root + child].square.w);
    }
    float all = f.r + f.g + f.b;
    squares.same += all * nodes[root + child].square.xyz;
    squares.across += all * nodes[root + child].across.xyz;
  }
  float all = max(power.r + power.g + power.b, 1e-30);
  squares = Squares(squares.same / all, squares.across / all);
  put(node, centroids, sqrt(felt2 / all), squares, square / all, power);
}

// Enters a tree that is fitted.
bool enterTree(uint which) {
  tree = beamTree(firstTree + which, kinds, lights);
  root = (firstTree + which) * nodeCount;
  return which < trees;
}

void main() {
  if (ofLeaves == 0u) {
    if (enterTree(groupIndex() / count)) fitTreelet(firstTreelet + groupIndex() % count);
    return;
  }
  uint first = groupIndex() * nodesOfGroup;
  for (uint i = first + gl_LocalInvocationIndex; i < first + nodesOfGroup; i += gl_WorkGroupSize.x)
    if (enterTree(i / count)) gatherLeaf(i % count);
}
