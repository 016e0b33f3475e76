#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "opaline/numbered_name.h"
#include "opaline/scene.h"
#include "scene/matrix.h"
#include "scene/mesh/same_topology.h"
#include "scene/raw_scene.h"

namespace opaline::scene {

/// The numbered files of a sequence, and how their vertices become those of a scene made from the
/// first file. Call in order: loadFirst(), inMillimetres(), followRepairs(), anything that places
/// the scene, finished(), followPlace(). Then read() can repeat what was done to the first file.
class MeshFiles {
 public:
  /// As MeshSequence; a sequence cannot be morphed.
  MeshFiles(const std::filesystem::path& pattern,
            const std::optional<std::filesystem::path>& morphTo);

  int first() const { return first_; }
  int last() const { return last_; }
  std::filesystem::path file(int number) const;

  /// Notes a gap that ends the sequence.
  RawScene loadFirst(const LogCallback& log);
  void followRepairs(const RawScene& repaired);
  /// Removes the rig from the scene.
  void followPlace(Scene& scene);

  /// As MeshSequence::read().
  void read(int number, std::vector<Vec3>& positionsMm) const;

 private:
  std::filesystem::path folder_;
  std::optional<NumberedName> name_;
  int first_ = 0;
  int last_ = 0;
  std::optional<int> nextAfterGap_;
  FaceList faces_;
  std::vector<std::uint32_t> origin_;  // per vertex of the scene, the file's vertex
  Matrix4 toScene_;
};

}  // namespace opaline::scene
