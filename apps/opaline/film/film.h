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
  ToneOptions tone;     ///< of what is not EXR
  bool resume = false;  ///< leave out what is there already; not for a film
  /// What each picture carries, if anything; where that differs, it is not the picture. Is called
  /// on several threads.
  std::function<std::string(int frame)> stamp;
  bool quiet = false;
  /// Called before each frame is submitted, where something beside the time is to be set.
  std::function<void(Renderer& renderer, int frame)> place;
};

/// Throws Error now, before hours of work, when the output could not be written or ffmpeg is not
/// there.
void requireFilmWritable(const Target& output, const FrameRange& frames);

/// Whether the file of that frame need not be made.
bool isThere(const FilmOrder& order, int frame);

/// All files the order is about.
std::vector<std::string> outputsOf(const FilmOrder& order);

struct FramesThere {
  std::size_t kept = 0;
  std::size_t otherwiseMade = 0;  ///< whole pictures that carry another stamp or none
};

/// How many frames need not be made, as their files are there, and how many are others.
FramesThere countThere(const FilmOrder& order);

/// What making a film did.
struct FilmMade {
  std::size_t frames = 0;  ///< that were not there before
  RenderReport report;
};

/// Renders the missing frames, of which there is one at least, each while those before are still
/// being written.
FilmMade renderFilm(Renderer& renderer, const FilmOrder& order);

/// For FilmOrder::place: puts the body where the frame's file has it. What is kept already is not
/// read again. Throws as numberOfFrame().
std::function<void(Renderer& renderer, int frame)> placeBySequence(
    std::shared_ptr<const MeshSequence> sequence, const FrameRange& frames,
    std::shared_ptr<KeptPositions> kept = std::make_shared<KeptPositions>());

}  // namespace opaline::app
