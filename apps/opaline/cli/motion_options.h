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
  /// Without `chunks`, a film is made by one program.
  void addTo(CommandLine& line, bool chunks = true);
  /// Throws UsageError for options that contradict each other where either a still or a film is
  /// made.
  void check() const;

  /// None when a still is asked for.
  std::optional<FrameRange> frames() const;
  /// The frames to render here; none if the chunk gets none.
  std::optional<FrameRange> framesOfChunk() const;
  const std::optional<Chunk>& chunk() const { return chunk_; }
  const std::optional<double>& framesPerSecond() const { return framesPerSecond_; }
  bool asksForTime() const { return !chosen_.empty(); }

  /// Appends the deformers that were asked for.
  void applyTo(Scene& scene) const;
  /// The time that was asked for, else the scene file's. Throws UsageError for a clip that the
  /// scene does not have.
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
