#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "cli/json.h"
#include "cli/motion_options.h"
#include "opaline/renderer.h"
#include "opaline/scene.h"
#include "opaline/sequence.h"
#include "opaline/tone.h"

namespace opaline::app {

/// Everything that decides the pixels of a row of pictures, except the device: devices differ only
/// by rounding, and several may share a row.
struct PictureMakers {
  const Scene& scene;
  RenderOptions options;
  int clip = 0;
  Aov aov = Aov::Radiance;
  std::optional<ToneOptions> tone;               ///< none: linear, as in EXR
  std::shared_ptr<const MeshSequence> sequence;  ///< files that the frames show
  Json method = Json::object();  ///< how the light is found, in words and numbers; stamps have it
};

/// The stamp of each frame. It says what made the frame, as JSON of printable ASCII. Its `row` is a
/// digest of all that the frames share: the scene as it was read, whatever its files are called,
/// the options, the frame rate and the program's version. Its `digest` is of that, the frame's time
/// and its mesh, and so of everything that decides the pixels. Thread-safe.
std::function<std::string(int frame)> frameStamps(const PictureMakers& makers,
                                                  const FrameRange& frames);

/// Whether two stamps have the same digest.
bool isSamePicture(const std::string& stamp, const std::string& other);

/// Whether both come from one scene with the same options, at any time. Where one is older and
/// has no `row`, their readable parts decide.
bool isSameRow(const std::string& stamp, const std::string& other);

/// The time that the picture shows; none where the text is not a stamp.
std::optional<double> secondsOf(const std::string& stamp);

}  // namespace opaline::app
