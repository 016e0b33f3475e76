#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "opaline/scene.h"

namespace opaline {

/// Meshes of one topology in numbered files, frame by frame.
class MeshSequence {
 public:
  /// `pattern` is a path whose last part has exactly one %d or %0Nd, as frame_%04d.ply. Finds the
  /// smallest number that exists, from 0 to 999999, and those that follow it without a gap; reads
  /// the first. Throws Error when there is none, or when it is not one still object.
  explicit MeshSequence(const std::filesystem::path& pattern, const LoadOptions& options = {});
  /// What the library itself makes of a scene file that names a sequence.
  struct State;
  explicit MeshSequence(State&& state);
  ~MeshSequence();
  MeshSequence(MeshSequence&&) noexcept;
  MeshSequence& operator=(MeshSequence&&) noexcept;

  /// Whether a path names a sequence rather than one file; a file of just that name is a file.
  static bool isPattern(const std::filesystem::path& path);

  /// The first frame: one object without a rig.
  const Scene& scene() const;
  int firstNumber() const;
  int lastNumber() const;
  int frameCount() const { return lastNumber() - firstNumber() + 1; }
  std::filesystem::path file(int number) const;

  /// The positions of a frame, one for each vertex of scene(), at the first frame's scale and
  /// place. May be called from several threads at once. Throws Error, naming the file, when it
  /// cannot be read or its topology is not that of the first.
  void read(int number, std::vector<Vec3>& positionsMm) const;

 private:
  std::unique_ptr<State> state_;
};

}  // namespace opaline
