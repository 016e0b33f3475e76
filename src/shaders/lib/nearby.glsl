// What coarse surfels leave out nearby. Where they are further apart than the profile is wide, what
// lies around a place is taken as evenly lit as the place itself, and the profile integrated over
// it in place of the sum (singularity subtraction). Needs, before it, BINDING_NODES,
// BINDING_SURFEL_NORMALS and what lib/surfel_sum.glsl needs.
#ifndef OPALINE_LIB_NEARBY
#define OPALINE_LIB_NEARBY
#include "lib/surfel_sum.glsl"
#include "lib/pi.glsl"
#include "lib/tree_node.glsl"

layout(set = 0, binding = BINDING_NODES) uniform samplerBuffer nodes;  // TreeNode
layout(std430, set = 0, binding = BINDING_SURFEL_NORMALS) readonly buffer SurfelNormals {
  vec4 surfelNormals[];
};

// Cosine of the normals below which a surfel is taken for the other side of a thin part.
const float otherSide = -0.3;

// Part of a disc's area that must be there to take it for a whole one: surfels count by their
// middles. What is less lies at a border.
const float wholeDisc = 0.85;

// By how much the sum falls short of the integral for unit irradiance.
vec3 missingNearby(vec3 position, vec3 normal, ObjectData body) {
  Profile profile = media[body.table.x].profile;
  float reach = body.nearby.x;
  vec3 summed = vec3(0.0);
  float area = 0.0;
  uint node = body.tree.x;
  while (node < body.tree.y) {
    vec4 green = texelFetch(nodes, 5 * int(node) + 1);
    float radius = texelFetch(nodes, 5 * int(node)).w;
    uint link = floatBitsToUint(green.w);
    bool apart = distance(green.xyz, position) > reach + radius;
    if (!apart && isLeaf(link)) {
      uint first = sourcesPerSurfel * firstSurfelOf(link);
      uint end = first + sourcesPerSurfel * surfelCountOf(link);
      for (uint i = first; i < end; ++i) {
        vec4 place = positionAreaOf(i);
        vec3 offset = place.xyz - position;
        float squared = dot(offset, offset);
        if (squared > reach * reach ||
            dot(surfelNormals[i / sourcesPerSurfel].xyz, normal) < otherSide)
          continue;
        summed += place.w * reflectanceProfile(profile, vec3(squared));
        area += place.w;
      }
    }
    node = apart ? afterNode(node, link) : node + 1u;
  }
  float present = min(area / (wholeDisc * pi * reach * reach), 1.0);
  return body.nearby.yzw * present - summed;
}

#endif
