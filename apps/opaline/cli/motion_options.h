#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/command_line.h"
#include "cli/frame_range.h"
#include "opaline/options/picture.h"
#include "opaline/renderer.h"
#include "opaline/scene.h"
#include "opaline/scene_file.h"

namespace opaline::app {

/// --time, --frames, --fps, --chunk, --clip, --deform.
class MotionOptions {
 public:
  /// Without `films` only what makes stills.
  void addTo(CommandLine& line, bool films = true);
  /// Throws UsageError for a mixture that contradicts itself.
  void check() const;

  /// Nothing when one still is asked for.
  std::optional<FrameRange> frames() const;
  /// Those of them that are to be rendered here, if any.
  std::optional<FrameRange> framesOfChunk() const;
  const std::optional<Chunk>& chunk() const { return chunk_; }

  /// Appends the deformers that were asked for.
  void applyTo(Scene& scene) const;
  /// What was asked for, else what the scene file says. Throws UsageError for a clip that the scene
  /// does not have.
  SceneTime time(const Scene& scene, const SceneFileSettings& settings) const;

 private:
  options::Chosen<options::PictureSettings> chosen_;  // the time of a still
  std::optional<FrameRange> frames_;
  std::optional<double> framesPerSecond_;
  std::optional<Chunk> chunk_;
  options::Chosen<options::NamedSettings> named_;  // the clip
  std::vector<Deformer> deformers_;
};

/// Whether a picture of the scene depends on the time.
bool moves(const Scene& scene, int clip);

}  // namespace opaline::app
