#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "cli/motion_options.h"
#include "film/kept_positions.h"
#include "opaline/file.h"
#include "opaline/renderer.h"
#include "opaline/sequence.h"
#include "opaline/tone.h"

namespace opaline::app {

/// Many frames, and where they go.
struct FilmOrder {
  FrameRange frames;
  Target output{""};  ///< a film, .mp4, or a name with a mark for the number
  Aov aov = Aov::Radiance;
  RenderOptions options;
  int clip = 0;
  ToneOptions tone;     ///< for pictures other than EXR
  bool resume = false;  ///< skip frames whose files exist; not for a film
  /// The stamp that each picture carries, if any. A picture with another stamp is not the one
  /// wanted. Called on several threads.
  std::function<std::string(int frame)> stamp;
  bool quiet = false;
  /// Called before each frame is submitted, to set more than the time.
  std::function<void(Renderer& renderer, int frame)> place;
};

/// Throws UsageError for frames that a film cannot leave out.
void requireEveryFrame(const FrameRange& frames);

/// Throws Error before hours of work when the output cannot be written or ffmpeg is missing.
void requireFilmWritable(const Target& output, const FrameRange& frames);

/// Whether the file of that frame exists and is to be kept.
bool isThere(const FilmOrder& order, int frame);

/// All files that the order writes.
std::vector<std::string> outputsOf(const FilmOrder& order);

struct FramesThere {
  std::size_t kept = 0;
  std::size_t otherwiseMade = 0;  ///< whole pictures with another stamp or none
};

/// How many frames exist already, and how many files are other pictures.
FramesThere countThere(const FilmOrder& order);

/// What was done to make a film.
struct FilmMade {
  std::size_t frames = 0;  ///< frames that did not exist before
  RenderReport report;
};

/// Renders the missing frames, of which there must be at least one. Earlier frames are still
/// written meanwhile.
FilmMade renderFilm(Renderer& renderer, const FilmOrder& order);

/// A FilmOrder::place that moves the body to where the frame's file has it. Files that are kept
/// already are not read again. Throws like numberOfFrame().
std::function<void(Renderer& renderer, int frame)> placeBySequence(
    std::shared_ptr<const MeshSequence> sequence, const FrameRange& frames,
    std::shared_ptr<KeptPositions> kept = std::make_shared<KeptPositions>());

}  // namespace opaline::app
