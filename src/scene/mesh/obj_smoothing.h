#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "opaline/types.h"
#include "scene/mesh/obj_lines.h"

namespace opaline::scene {

/// A face without normals of its own.
struct ObjFace {
  std::size_t number = 0;                  ///< among all faces of the file
  std::vector<std::uint32_t> positions{};  ///< of its corners
};

/// The normals that smoothing groups give the corners of faces. Equal normals at one position are
/// shared.
struct ObjNormals {
  std::vector<Vec3> normals;            ///< zero where no face around has an area
  std::vector<std::uint32_t> ofCorner;  ///< the normal of each corner, face after face
};

/// The mean over the faces of one group around a position, weighted by their angles there (Thürmer
/// and Wüthrich 1998). Faces of group 0 are flat.
ObjNormals normalsOfSmoothing(std::span<const Vec3> positions, std::span<const ObjFace> faces,
                              std::span<const ObjSmoothing> smoothing);

}  // namespace opaline::scene
