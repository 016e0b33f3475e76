// Makes a node of the tree (shared/surfels.h) and takes it apart.
#ifndef OPALINE_LIB_TREE_NODE
#define OPALINE_LIB_TREE_NODE
#include "shared/surfels.h"

// The node of a walk that has nothing more to do.
const uint noNode = 0xffffffffu;

bool isLeaf(uint link) {
  return (link & leafBit) != 0u;
}

uint firstSurfelOf(uint link) {
  return bitfieldExtract(link, 0, int(leafCountShift));
}

uint surfelCountOf(uint link) {
  return bitfieldExtract(link, int(leafCountShift), 29 - int(leafCountShift)) + 1u;
}

// The node after `node` and all that are below it.
uint afterNode(uint node, uint link) {
  return isLeaf(link) ? node + 1u : link & (setBit - 1u);
}

mat3 momentsOf(TreeNode node) {
  return mat3(node.momentXx, node.moments.y, node.moments.z,  //
              node.moments.y, node.momentYy, node.moments.w,  //
              node.moments.z, node.moments.w, node.moments.x);
}

// The trace of its moments, mm².
float meanSquareOf(TreeNode node) {
  return node.momentXx + node.momentYy + node.moments.x;
}

// The columns are the centroids of the channels' flux.
mat3 centroidsOf(TreeNode node) {
  return mat3(node.red, node.green, node.blue);
}

TreeNode makeNode(mat3 centroids, float radius, uint link, vec3 flux, mat3 moments) {
  return TreeNode(centroids[0], radius, centroids[1], link, centroids[2], moments[0][0], flux,
                  moments[1][1],
                  vec4(moments[2][2], moments[0][1], moments[0][2], moments[1][2]));
}

#endif
