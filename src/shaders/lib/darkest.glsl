// The exitance below which differences do not count. Needs, before it, BINDING_NODES and what lib/bodies.glsl needs.
#ifndef OPALINE_LIB_DARKEST
#define OPALINE_LIB_DARKEST
#include "lib/bodies.glsl"
#include "lib/texels.glsl"
#include "lib/tree_node.glsl"

TEXELS(BINDING_NODES, nodes);  // TreeNode

// For a body whose tree has that root.
vec3 darkestOf(ObjectData body, uint root) {
  return root == noNode ? vec3(0.0) : body.darkest.rgb * texelOf(nodes, 5 * int(root) + 3).rgb;
}

#endif
