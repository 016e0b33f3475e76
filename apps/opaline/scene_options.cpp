#include "scene_options.h"

#include <fmt/format.h>

#include <set>

#include "core/image_file.h"
#include "opaline/error.h"
#include "values.h"

namespace opaline::app {

namespace {

constexpr Range lengthRange{-1e6, 1e6, "mm"};
constexpr Range lightRange{0, 1e6};
constexpr double mostDiffusionLengths = 1000;
constexpr double leastDiffusionLengths = 2;

/// X,Y,Z:R,G,B, the colour optional or not.
struct PlacedColour {
  Given place;
  std::optional<Rgb> colour;
};

PlacedColour readPlacedColour(const Given& given) {
  const std::size_t colon = given.text.find(':');
  PlacedColour result{{given.option, given.text.substr(0, colon)}, std::nullopt};
  if (colon != std::string::npos) {
    result.colour = readTripleFloat({given.option, given.text.substr(colon + 1)}, lightRange);
  }
  return result;
}

}  // namespace

void SceneOptions::addTo(CommandLine& line) {
  line.positional("SCENE", "a .glb, .gltf, .obj, .ply or .toml file",
                  [this](const Given& given) { file_ = given.text; });
  line.value("--builtin", "NAME", "bear or teapot, instead of SCENE [bear]",
             [this](const Given& given) {
               builtIn_ = readChoice<std::string>(given, {{"bear", "bear"}, {"teapot", "teapot"}});
             });
  line.value("--diagonal-mm", "X", "scale the bounding box's diagonal to X mm",
             [this](const Given& given) {
               diagonalMm_ = static_cast<float>(readNumber(given, {1e-3, 1e6, "mm"}));
             });
  medium_.addTo(line);
}

std::string SceneOptions::name() const {
  return file_ ? file_->stem().string() : builtIn_.value_or("bear");
}

scene::LoadedScene SceneOptions::load(const LogCallback& log) const {
  if (file_ && builtIn_) {
    throw UsageError(fmt::format("--builtin {} and the scene {} exclude each other", *builtIn_,
                                 file_->string()));
  }
  const LoadOptions options{diagonalMm_, medium_.medium(), log};
  if (file_) return scene::loadSceneFile(*file_, options);
  return {builtIn_ == "teapot" ? builtInTeapot(options) : builtInBear(options), {}};
}

void LightOptions::addTo(CommandLine& line) {
  line.repeated(
      "--directional", "X,Y,Z[:R,G,B]", "direction towards it, irradiance [1,1,1]",
      [this](const Given& given) {
        const PlacedColour light = readPlacedColour(given);
        directional_.push_back({readDirection(light.place), light.colour.value_or(Rgb{1, 1, 1})});
        any_ = true;
      });
  line.repeated("--point", "X,Y,Z:R,G,B", "mm from the box's centre, irradiance at 1 mm",
                [this](const Given& given) {
                  const PlacedColour light = readPlacedColour(given);
                  if (!light.colour) {
                    throw UsageError(fmt::format("{} {}: needs an intensity, X,Y,Z:R,G,B",
                                                 given.option, given.text));
                  }
                  points_.push_back({readTripleFloat(light.place, lengthRange), *light.colour});
                  any_ = true;
                });
  line.value("--ambient", "R,G,B", "radiance, the same from everywhere",
             [this](const Given& given) {
               ambient_ = readTripleFloat(given, lightRange);
               any_ = true;
             });
  line.value("--environment", "FILE", "latitude-longitude .hdr or .exr, radiance",
             [this](const Given& given) {
               environment_ = given.text;
               any_ = true;
             });
}

void LightOptions::applyTo(Scene& scene) const {
  if (!any_) return;
  Lighting lighting;
  lighting.directional = directional_;
  const Bounds bounds = boundsOf(scene);
  for (PointLight light : points_) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      light.positionMm[axis] += (bounds.minMm[axis] + bounds.maxMm[axis]) / 2;
    }
    lighting.points.push_back(light);
  }
  lighting.ambient = ambient_;
  if (environment_) lighting.environment = core::readHdrImage(*environment_);
  scene.lighting = std::move(lighting);
}

void CameraOptions::addTo(CommandLine& line) {
  line.value("--camera-direction", "X,Y,Z", "from its target to the camera [0,0,1]",
             [this](const Given& given) { direction_ = readDirection(given); });
  line.value("--fov-degrees", "X", "vertical field of view, 1 to 170 [30]",
             [this](const Given& given) {
               verticalFovDegrees_ = static_cast<float>(readNumber(given, {1, 170, "degrees"}));
             });
}

void CameraOptions::applyTo(Scene& scene) const {
  if (direction_) scene.camera = turnedTo(scene.camera, *direction_);
  if (verticalFovDegrees_) scene.camera.verticalFovDegrees = *verticalFovDegrees_;
}

std::vector<std::string> notesOnSize(const Scene& scene) {
  std::vector<std::string> notes;
  std::set<std::string> seen;
  const double diagonal = diagonalMm(scene);
  for (const Object& object : scene.objects) {
    const auto length = lengthsOf(object.medium).longestDiffusionMm;
    if (!length || !seen.insert(object.medium.name).second) continue;
    const double ratio = diagonal / *length;
    if (ratio >= leastDiffusionLengths && ratio <= mostDiffusionLengths) continue;
    notes.push_back(
        fmt::format("the model measures {:.4g} mm, {:.3g} diffusion lengths of {} ({:.3g} mm): it "
                    "will look {}; "
                    "--diagonal-mm sets its size",
                    diagonal, ratio, object.medium.name, *length,
                    ratio > mostDiffusionLengths ? "opaque" : "like fog"));
  }
  return notes;
}

}  // namespace opaline::app
