#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/frame_range.h"
#include "cli/json.h"
#include "cli/paths.h"
#include "film/film.h"
#include "film/kept_positions.h"
#include "opaline/file.h"
#include "opaline/log.h"
#include "opaline/options/picture.h"
#include "opaline/scene.h"
#include "opaline/sequence.h"

// What commands that make a still, or with --frames many pictures, do alike.
namespace opaline::app {

/// Throws Error before hours of work where a still or the pictures, or the report, cannot be
/// written.
void requireOutputs(const Target& output, const std::optional<FrameRange>& frames,
                    const std::optional<std::filesystem::path>& report);

/// What such a command settles before it makes its first picture.
struct PictureJob {
  Scene scene;
  RenderOptions options;
  SceneTime time;  ///< of a still
  ToneOptions tone;
  Target output;
  std::shared_ptr<const MeshSequence> sequence;
  std::shared_ptr<KeptPositions> kept = std::make_shared<KeptPositions>();

  /// Also refuses frames beyond the sequence.
  void aimCamera(const std::optional<FrameRange>& frames);
  /// Each picture gets a stamp that says the method, so that --resume knows it again. A film has
  /// none.
  FilmOrder filmOrder(const FrameRange& frames, Aov aov, const Json& method) const;
};

/// Adds the file that an option names, or the file of each frame.
void addOutputs(const std::string& option, const std::filesystem::path& file,
                const std::optional<FrameRange>& frames, std::vector<Output>& to);

/// The number of frames to be made. Notes how many exist already, and how many are made again.
std::size_t framesToMake(const FilmOrder& order, const LogCallback& log);

/// Notes that all frames are one picture where nothing moves.
void noteStandstill(const Scene& scene, int clip, const LogCallback& log);

/// Notes what becomes of a film of an odd size.
void noteFilmSize(const Target& output, const RenderOptions& options, const LogCallback& log);

/// "1 frame", "2 frames".
std::string countOfFrames(std::size_t count);

/// There may be more chunks than frames, so that one gets none.
void noteEmptyChunk(const Chunk& chunk, const LogCallback& log);

/// Adds to the report which frames there are and their speed; null for a chunk without any.
void addFrames(const std::optional<FrameRange>& frames, Json& report);

}  // namespace opaline::app
