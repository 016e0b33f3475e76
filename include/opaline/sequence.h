#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "opaline/export.h"
#include "opaline/scene.h"

namespace opaline {

/// Meshes of one topology in numbered files, frame by frame.
class OPALINE_API MeshSequence {
 public:
  /// `pattern` is a path whose last part has exactly one %d or %0Nd, such as frame_%04d.ply. Finds
  /// the smallest number that exists, from 0 to 999999, and all that follow without a gap, which it
  /// notes. Reads the first file. Throws Error when there is none, or when the first is not one
  /// object without motion.
  explicit MeshSequence(const std::filesystem::path& pattern, const LoadOptions& options = {});
  /// For the library itself: a scene file that names a sequence.
  struct State;
  explicit MeshSequence(State&& state);
  ~MeshSequence();
  MeshSequence(MeshSequence&&) noexcept;
  MeshSequence& operator=(MeshSequence&&) noexcept;

  /// Whether a path names a sequence. A file with exactly that name is a file, not a sequence.
  static bool isPattern(const std::filesystem::path& path);

  /// The first frame: one object without a rig.
  const Scene& scene() const;
  int firstNumber() const;
  int lastNumber() const;
  int frameCount() const { return lastNumber() - firstNumber() + 1; }
  std::filesystem::path file(int number) const;

  /// The positions of a frame, one for each vertex of scene(), at the first frame's scale and
  /// place. May be called from several threads at once. Throws Error that names the file when it
  /// cannot be read or its topology differs from the first.
  void read(int number, std::vector<Vec3>& positionsMm) const;

 private:
  std::unique_ptr<State> state_;
};

}  // namespace opaline
