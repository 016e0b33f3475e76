// Fits the inner nodes of a tree, children before parents: a work group has a treelet (surfels/treelets.h),
// and its invocations share the nodes of a level. Needs BINDING_TREELETS, the first of four bindings,
// and fitNode() after it; what nodes are written to has to be coherent.
#ifndef OPALINE_LIB_TREELETS
#define OPALINE_LIB_TREELETS
#include "lib/tree_node.glsl"
#include "lib/work_group.glsl"

layout(std430, set = 0, binding = BINDING_TREELETS) readonly buffer Links { uint links[]; };
layout(std430, set = 0, binding = BINDING_TREELETS + 1) readonly buffer TreeletNodes {
  uint treeletNodes[];
};
layout(std430, set = 0, binding = BINDING_TREELETS + 2) readonly buffer FirstOfLevel {
  uint firstOfLevel[];  // into treeletNodes
};
layout(std430, set = 0, binding = BINDING_TREELETS + 3) readonly buffer LevelOfTreelet {
  uint levelOfTreelet[];  // the first of each treelet, into firstOfLevel
};

void fitNode(uint node, uint link);

void fitTreelet(uint treelet) {
  uint endLevel = levelOfTreelet[treelet + 1u];
  for (uint level = levelOfTreelet[treelet]; level < endLevel; ++level) {
    uint end = firstOfLevel[level + 1u];
    for (uint at = firstOfLevel[level] + gl_LocalInvocationIndex; at < end; at += gl_WorkGroupSize.x)
      fitNode(treeletNodes[at], links[treeletNodes[at]]);
    memoryBarrierBuffer();
    barrier();
  }
}

void fitTreelets(uint first, uint count) {
  uint i = groupIndex();
  if (i < count) fitTreelet(first + i);
}

#endif
