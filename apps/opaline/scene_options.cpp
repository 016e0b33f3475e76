#include "scene_options.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <set>
#include <utility>

#include "core/measures.h"
#include "frame_names.h"
#include "opaline/error.h"
#include "scene/environment_file.h"
#include "values.h"

namespace opaline::app {

namespace {

constexpr Range lengthRange{-1e6, 1e6, "mm"};
constexpr Range lightRange{0, 1e6};
constexpr double mostDiffusionLengths = 1000;
constexpr double leastDiffusionLengths = 2;
constexpr double mostFovDegrees = 170;

/// X,Y,Z:R,G,B, the colour optional or not.
struct PlacedColour {
  Given place;
  std::optional<Rgb> colour;
};

PlacedColour readPlacedColour(const Given& given) {
  const std::size_t colon = given.text.find(':');
  PlacedColour result{{given.option, given.text.substr(0, colon)}, std::nullopt};
  if (colon != std::string::npos) {
    result.colour = readColour({given.option, given.text.substr(colon + 1)}, lightRange);
  }
  return result;
}

double distanceToTargetMm(const Camera& camera) {
  return std::hypot(double{camera.positionMm[0]} - camera.targetMm[0],
                    double{camera.positionMm[1]} - camera.targetMm[1],
                    double{camera.positionMm[2]} - camera.targetMm[2]);
}

/// Whether nobody chose the target and the distance, so that what is cut off was hardly meant.
bool standsWhereDefaultCameraStands(const Scene& scene) {
  const Camera usual = defaultCamera(scene);
  const double wanted = distanceToTargetMm(usual);
  Camera between = usual;  // from one target to the other
  between.positionMm = scene.camera.targetMm;
  return distanceToTargetMm(between) <= 1e-5 * wanted &&
         scene.camera.verticalFovDegrees == usual.verticalFovDegrees &&
         std::abs(distanceToTargetMm(scene.camera) - wanted) <= 1e-5 * wanted;
}

/// The vertical field of view in which all corners of the scene's box are seen.
double fovOfWholeBoxDegrees(const Scene& scene, double aspect) {
  using Vector = std::array<double, 3>;
  const auto dot = [](const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  };
  const auto unitCross = [](const Vector& a, const Vector& b) {
    const Vector c{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    const double length = std::hypot(c[0], c[1], c[2]);
    return Vector{c[0] / length, c[1] / length, c[2] / length};
  };
  const auto from = [&](const Vec3& point) {
    const Vec3& eye = scene.camera.positionMm;
    return Vector{double{point[0]} - eye[0], double{point[1]} - eye[1], double{point[2]} - eye[2]};
  };
  Vector axis = from(scene.camera.targetMm);
  for (double& component : axis) component /= distanceToTargetMm(scene.camera);
  const Vec3& up = scene.camera.up;
  const Vector right = unitCross(axis, {up[0], up[1], up[2]});
  const Vector above = unitCross(right, axis);
  const Bounds bounds = boundsOf(scene);
  double tangent = 0;
  for (unsigned corner = 0; corner < 8; ++corner) {
    Vec3 point{};
    for (unsigned i = 0; i < 3; ++i) {
      point[i] = ((corner >> i) & 1U) != 0 ? bounds.maxMm[i] : bounds.minMm[i];
    }
    const Vector ray = from(point);
    const double across = std::max(std::abs(dot(ray, above)), std::abs(dot(ray, right)) / aspect);
    tangent = std::max(tangent, across / dot(ray, axis));
  }
  return 2 * std::atan(tangent) * 180 / std::numbers::pi;
}

}  // namespace

void SceneOptions::addTo(CommandLine& line) {
  line.positionals("SCENE", ".glb, .gltf, .obj, .ply, .toml, or frame_%04d.ply",
                   [this](const Given& given) { files_.emplace_back(given.text); });
  line.value("--builtin", "NAME", "bear or teapot, instead of SCENE [bear]",
             [this](const Given& given) {
               builtIn_ = readChoice<std::string>(given, {{"bear", "bear"}, {"teapot", "teapot"}});
             });
  line.value("--diagonal-mm", "X", "scale the bounding box's diagonal to X mm",
             [this](const Given& given) {
               diagonalMm_ = static_cast<float>(readNumber(given, {1e-3, 1e6, "mm"}));
             });
  medium_.addTo(line);
  line.value("--morph-to", "FILE", "mesh that it turns into: clip \"morph\"",
             [this](const Given& given) { morphTo_ = given.text; });
}

bool SceneOptions::any() const {
  return !files_.empty() || builtIn_ || diagonalMm_ || morphTo_ || medium_.any();
}

std::string SceneOptions::name() const {
  if (files_.empty()) return builtIn_.value_or("bear");
  const std::string stem = files_.front().stem().string();
  const std::optional<FrameNames> names = FrameNames::parse(stem);
  return names ? names->common() : stem;
}

LoadedScene SceneOptions::load(const LogCallback& log) const {
  if (!files_.empty() && builtIn_) {
    throw UsageError(fmt::format("--builtin {} and the scene {} exclude each other", *builtIn_,
                                 files_.front().string()));
  }
  if (morphTo_ && files_.empty()) {
    throw UsageError(fmt::format("--morph-to {}: a built-in scene has no counterpart, name a SCENE",
                                 morphTo_->string()));
  }
  LoadOptions options;
  options.diagonalMm = diagonalMm_;
  options.medium = medium_.medium();
  options.morphTo = morphTo_;
  options.log = log;
  if (files_.empty()) {
    const bool teapot = builtIn_ == "teapot";
    return {teapot ? builtInTeapot(options) : builtInBear(options),
            {},
            {},
            scene::sourceOf(teapot ? "builtin:teapot" : "builtin:bear", options)};
  }
  if (files_.size() == 1 && MeshSequence::isPattern(files_.front())) {
    auto sequence = std::make_shared<const MeshSequence>(files_.front(), options);
    return {sequence->scene(), {}, sequence, scene::sourceOf(files_.front(), options)};
  }
  auto [scene, settings, source, sequence] = scene::loadSceneFiles(files_, options);
  return {std::move(scene), std::move(settings), std::move(sequence), std::move(source)};
}

void LightOptions::addTo(CommandLine& line) {
  line.repeated(
      "--directional", "DIR[:RGB]", "X,Y,Z towards it; irradiance R,G,B [1,1,1]",
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
                  points_.push_back({readPlace(light.place, lengthRange), *light.colour});
                  any_ = true;
                });
  line.value("--ambient", "R,G,B", "radiance from everywhere; one number is grey",
             [this](const Given& given) {
               ambient_ = readColour(given, lightRange);
               any_ = true;
             });
  line.value("--environment", "FILE", "latitude-longitude .hdr or .exr, radiance",
             [this](const Given& given) {
               environment_ = given.text;
               any_ = true;
             });
  line.value("--environment-rotation", "DEGREES", "degrees [0], factor [1]",
             [this](const Given& given) {
               rotationDegrees_ = readNumber(given, {-1e6, 1e6, "degrees"});
             });
  line.value("--environment-intensity", "X", "", [this](const Given& given) {
    intensity_ = static_cast<float>(readNumber(given, {0, 1e6}));
  });
}

void LightOptions::applyTo(LoadedScene& loaded) const {
  if (any_) {
    loaded.source.environment.reset();
    if (environment_) {
      loaded.source.environment = scene::EnvironmentFile{std::filesystem::absolute(*environment_)};
    }
    loaded.scene.lighting = lightingFor(loaded.scene);
  }
  std::optional<scene::EnvironmentFile>& environment = loaded.source.environment;
  if (!environment && (rotationDegrees_ || intensity_)) {
    throw UsageError(
        fmt::format("--environment-{} needs an environment: name one with --environment FILE",
                    rotationDegrees_ ? "rotation" : "intensity"));
  }
  if (!environment || !(environment_ || rotationDegrees_ || intensity_)) return;
  if (rotationDegrees_) environment->rotationDegrees = *rotationDegrees_;
  if (intensity_) environment->intensity = *intensity_;
  loaded.scene.lighting.environment = scene::readEnvironment(*environment);
}

Lighting LightOptions::lightingFor(const Scene& scene) const {
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
  return lighting;
}

std::optional<double> fovThatIsNeededDegrees(const Scene& scene, int width, int height) {
  if (!standsWhereDefaultCameraStands(scene)) return std::nullopt;
  const double needed = fovOfWholeBoxDegrees(scene, static_cast<double>(width) / height);
  if (needed <= double{scene.camera.verticalFovDegrees}) return std::nullopt;
  return needed;
}

void CameraOptions::addTo(CommandLine& line) {
  line.value("--camera-direction", "X,Y,Z", "from the centre to the camera [0,0,1]",
             [this](const Given& given) { direction_ = readDirection(given); });
  line.value(
      "--fov-degrees", "X", "vertical field of view, 1 to 170 [30]", [this](const Given& given) {
        verticalFovDegrees_ = static_cast<float>(readNumber(given, {1, mostFovDegrees, "degrees"}));
      });
}

void CameraOptions::applyTo(Scene& scene) const {
  const float fovDegrees = verticalFovDegrees_.value_or(scene.camera.verticalFovDegrees);
  if (direction_) {
    const Camera old = scene.camera;
    scene.camera = defaultCamera(scene, *direction_, fovDegrees);
    scene.camera.targetMm = old.targetMm;
    const double distanceMm = distanceToTargetMm(old);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      scene.camera.positionMm[axis] =
          static_cast<float>(double{old.targetMm[axis]} + distanceMm * double{(*direction_)[axis]});
    }
  }
  scene.camera.verticalFovDegrees = fovDegrees;
}

std::optional<std::string> CameraOptions::noteOnFraming(const Scene& scene, int width,
                                                        int height) const {
  if (verticalFovDegrees_) return std::nullopt;
  const std::optional<double> needed = fovThatIsNeededDegrees(scene, width, height);
  if (!needed) return std::nullopt;
  const double whole = std::ceil(*needed);
  const std::string cure = whole <= mostFovDegrees
                               ? fmt::format("--fov-degrees {:.0f} shows all of it", whole)
                               : std::string("a wider --size shows more of it");
  return "the model does not fit into the picture; " + cure;
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
    notes.push_back(fmt::format(
        "the model measures {}, {:.3g} diffusion lengths of {} ({}): it will look {}; "
        "--diagonal-mm sets its size",
        core::lengthText(diagonal, 4), ratio, object.medium.name, core::lengthText(*length),
        ratio > mostDiffusionLengths ? "opaque" : "like fog"));
  }
  return notes;
}

}  // namespace opaline::app
