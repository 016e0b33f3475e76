#pragma once

#include <optional>
#include <vector>

#include "cli/motion_options.h"
#include "film/kept_positions.h"
#include "opaline/positions.h"
#include "opaline/scene.h"
#include "opaline/sequence.h"

namespace opaline::app {

/// What is rendered when.
struct Moment {
  double seconds = 0;
  std::optional<int> number{};  ///< of the file that has the body, where it is a row of files
};

/// What a camera is to see.
struct Framed {
  int clip = 0;
  double aspect = 1;                       ///< of the picture, width over height
  const MeshSequence* sequence = nullptr;  ///< of the scene's only object
  std::vector<Moment> moments{};
  KeptPositions* kept = nullptr;  ///< gets what is read of the sequence
};

double aspectOf(const RenderOptions& options);

/// All frames, or 1024 of more, and one still. Throw UsageError beyond the last of a sequence's
/// files.
std::vector<Moment> momentsOf(const FrameRange& frames, const MeshSequence* sequence);
std::vector<Moment> momentOf(double seconds, const MeshSequence* sequence);

/// Some moments of a motion that repeats itself after so many seconds.
std::vector<Moment> someMoments(double lengthSeconds, const MeshSequence* sequence);

/// Moves the camera back, where nobody chose its place, just as far that all vertices are in the
/// picture at every moment. Where they are from where it stands, nothing changes. A file that
/// cannot be read is left to whoever renders it.
void showAll(Scene& scene, const Framed& framed);

/// Leads the camera to where it sees all of the scene as it is at one moment, looking the way it
/// does.
void frame(Scene& scene, const SceneTime& time, const PositionsByObject& positionsMm,
           double aspect);

}  // namespace opaline::app
