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

/// The list of a mesh as its file gives it. Polygons count uncut, since the triangles they are cut
/// into depend on where their corners lie.
FaceList faceListOf(const RawMesh& mesh);

/// How the second list differs from the first; empty if it does not.
std::string differenceOf(const FaceList& first, const FaceList& second);

/// The only object of a file. Throws Error, naming the file and `use`, where there are several
/// objects or where it is animated.
RawObject& onlyStillObject(RawScene& scene, const std::string& file, const std::string& use);

}  // namespace opaline::scene
