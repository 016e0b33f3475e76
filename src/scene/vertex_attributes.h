#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "opaline/types.h"

namespace opaline::scene {

/// The vertex attributes that only textures and colours use. Each list is empty or has one entry
/// per vertex.
struct VertexAttributes {
  std::size_t vertices = 0;
  std::array<std::vector<Vec2>, 2> textureCoordinates;
  std::vector<std::array<float, 4>> colors;
};

struct RawObject;

/// Appends the attributes of more vertices. Coordinates that one side lacks become 0, and colours
/// white.
void appendAttributes(VertexAttributes& to, VertexAttributes&& more);

/// Maps an object's attributes from the file's vertices, which `mesh.provenance` names, to the
/// mesh's.
void alignAttributes(RawObject& object);

}  // namespace opaline::scene
