#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "opaline/types.h"

namespace opaline::scene {

/// What only textures and colours read of a file's vertices. Each is empty or has one a vertex.
struct VertexAttributes {
  std::size_t vertices = 0;
  std::array<std::vector<Vec2>, 2> textureCoordinates;
  std::vector<std::array<float, 4>> colors;
};

struct RawObject;

/// Appends those of more vertices. What only one of the two has is 0 in the other, colours white.
void appendAttributes(VertexAttributes& to, VertexAttributes&& more);

/// Brings them from the file's vertices, which `mesh.provenance` names, to those of the mesh.
void alignAttributes(RawObject& object);

}  // namespace opaline::scene
