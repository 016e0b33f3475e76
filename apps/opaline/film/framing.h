#pragma once

#include <optional>
#include <vector>

#include "cli/motion_options.h"
#include "film/kept_positions.h"
#include "opaline/positions.h"
#include "opaline/scene.h"
#include "opaline/sequence.h"

namespace opaline::app {

/// A time to be rendered.
struct Moment {
  double seconds = 0;
  std::optional<int> number{};  ///< of the file with the body, in a row of files
};

/// What the camera must see.
struct Framed {
  int clip = 0;
  double aspect = 1;                       ///< of the picture, width over height
  const MeshSequence* sequence = nullptr;  ///< of the scene's only object
  std::vector<Moment> moments{};
  KeptPositions* kept = nullptr;  ///< receives what is read of the sequence
};

double aspectOf(const RenderOptions& options);

/// All frames, or 1024 of them if there are more, and the moment of a still. Both throw UsageError
/// beyond the last file of a sequence.
std::vector<Moment> momentsOf(const FrameRange& frames, const MeshSequence* sequence);
std::vector<Moment> momentOf(double seconds, const MeshSequence* sequence);

/// Some moments of a motion that repeats every `lengthSeconds`.
std::vector<Moment> someMoments(double lengthSeconds, const MeshSequence* sequence);

/// Moves the camera back just as far that all vertices are in the picture at every moment, unless
/// somebody chose its place. Nothing changes where they already are. A file that cannot be read is
/// left to whoever renders it.
void showAll(Scene& scene, const Framed& framed);

/// Moves the camera to where it sees the whole scene at one moment; its direction stays.
void frame(Scene& scene, const SceneTime& time, const PositionsByObject& positionsMm,
           double aspect);

}  // namespace opaline::app
