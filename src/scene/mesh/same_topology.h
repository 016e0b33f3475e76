#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "scene/raw_scene.h"

namespace opaline::scene {

/// What two meshes must have in common so that one can take the other's positions.
struct FaceList {
  std::size_t vertices = 0;
  std::size_t faces = 0;
  std::uint64_t hash = 0;  ///< of the corners of all faces
};

/// Of a mesh as its file gives it; polygons count as they are, since how they are cut into
/// triangles depends on where their corners lie.
FaceList faceListOf(const RawMesh& mesh);

/// How the second differs from the first; empty if it does not.
std::string differenceOf(const FaceList& first, const FaceList& second);

/// The only object of a file. Throws Error, naming it and `use`, where there are several or where
/// it moves by itself.
RawObject& onlyStillObject(RawScene& scene, const std::string& file, const std::string& use);

}  // namespace opaline::scene
