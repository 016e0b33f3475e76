// What lib/cutout.glsl reads of a vertex. Needs, before it, BINDING_VERTEX_ATTRIBUTES, the first of two
// bindings.
#ifndef OPALINE_LIB_CUTOUT_VERTEX
#define OPALINE_LIB_CUTOUT_VERTEX
#include "shared/opaque.h"

layout(std430, set = 0, binding = BINDING_VERTEX_ATTRIBUTES) readonly buffer VertexAttributesOf { VertexAttributes vertexAttributes[]; };
layout(std430, set = 0, binding = BINDING_VERTEX_ATTRIBUTES + 1) readonly buffer ObjectOf { uint objectOf[]; };

layout(location = 0) flat out uint object;
layout(location = 1) out vec4 coordinates;
layout(location = 2) out float alpha;

void passOn(uint vertex) {
  object = objectOf[vertex];
  coordinates = vertexAttributes[vertex].coordinates;
  alpha = vertexAttributes[vertex].color.a;
}

#endif
