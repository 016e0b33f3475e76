// Light at vertices: first at all of them, then, where some bodies have a back, at the other side of all. Needs
// lib/bodies.glsl.
#ifndef OPALINE_LIB_VERTEX_SIDE
#define OPALINE_LIB_VERTEX_SIDE

struct VertexSide {
  uint vertex;
  bool back;
};

VertexSide vertexSideOf(uint i, uint vertexCount) {
  bool back = i >= vertexCount;
  return VertexSide(back ? i - vertexCount : i, back);
}

bool hasSide(ObjectData body, VertexSide side) {
  return !side.back || hasBack(body);
}

vec3 outwardsOf(VertexSide side, vec3 normal) {
  return side.back ? -normal : normal;
}

#endif
