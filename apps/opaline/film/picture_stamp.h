#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "cli/motion_options.h"
#include "opaline/renderer.h"
#include "opaline/scene.h"
#include "opaline/sequence.h"
#include "opaline/tone.h"

namespace opaline::app {

/// What decides the pixels of a row of pictures, but the device: devices differ by roundings, and a
/// row may be shared among them.
struct PictureMakers {
  const Scene& scene;
  RenderOptions options;
  int clip = 0;
  Aov aov = Aov::Radiance;
  std::optional<ToneOptions> tone;               ///< none: linear, as EXR is
  std::shared_ptr<const MeshSequence> sequence;  ///< whose files the frames show
};

/// The stamp of each frame: what made it, as JSON of printable ASCII, for people and programs to
/// read, and a digest of everything that decides the pixels: the scene as it was read, whatever its
/// files are called, and the version of the program. May be called on several threads.
std::function<std::string(int frame)> frameStamps(const PictureMakers& makers,
                                                  const FrameRange& frames);

/// Whether two stamps have the same digest.
bool isSamePicture(const std::string& stamp, const std::string& other);

/// Whether they come from one scene and the same options, whatever the time; as far as their
/// readable part tells.
bool isSameRow(const std::string& stamp, const std::string& other);

/// The time that the picture shows; nothing where it is no stamp.
std::optional<double> secondsOf(const std::string& stamp);

}  // namespace opaline::app
