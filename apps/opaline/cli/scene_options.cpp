#include "cli/scene_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include "cli/fields.h"
#include "cli/frame_names.h"
#include "cli/values.h"
#include "opaline/environment.h"
#include "opaline/error.h"
#include "opaline/framing.h"
#include "opaline/options/scene.h"

namespace opaline::app {

namespace {

constexpr Range lengthRange{-1e6, 1e6, "mm"};

/// X,Y,Z:R,G,B. The colour may be optional.
struct PlacedColour {
  Given place;
  std::optional<Rgb> colour;
};

Given partOf(const Given& given, std::size_t from, std::size_t end) {
  const std::string part = given.text.substr(from, end - from);
  return {given.option, part, part == given.text ? std::string() : given.text};
}

PlacedColour readPlacedColour(const Given& given, const Range& range) {
  const std::size_t colon = given.text.find(':');
  PlacedColour result{partOf(given, 0, colon), std::nullopt};
  if (colon != std::string::npos) {
    result.colour = readColour(partOf(given, colon + 1, std::string::npos), range);
  }
  return result;
}

/// The parts of a text between its colons.
std::vector<Given> partsOf(const Given& given) {
  std::vector<Given> parts;
  std::size_t from = 0;
  while (from <= given.text.size()) {
    const std::size_t end = std::min(given.text.find(':', from), given.text.size());
    parts.push_back(partOf(given, from, end));
    from = end + 1;
  }
  return parts;
}

template <typename Light>
Light checked(const Given& given, const Light& light) {
  if (const std::string complaint = complaintAbout(light); !complaint.empty())
    throw UsageError(fmt::format("{} {}: {}", given.option, given.text, complaint));
  return light;
}

/// DX,DY,DZ[:R,G,B[:DEGREES]]
DirectionalLight readDirectional(const Given& given) {
  const std::vector<Given> parts = partsOf(given);
  if (parts.size() > 3) {
    throw UsageError(fmt::format(
        "{} {}: needs a direction, X,Y,Z, and perhaps an irradiance and the degrees of the radius "
        "as which it is mirrored, X,Y,Z:R,G,B:DEGREES",
        given.option, given.text));
  }
  const auto allowed = [](std::string_view key) {
    return options::fieldOf<DirectionalLight>(key).allowed.range;
  };
  DirectionalLight light{.directionToLight = readDirection(parts[0])};
  if (parts.size() > 1) light.irradiance = readColour(parts[1], allowed("irradiance"));
  if (parts.size() > 2)
    light.angularRadiusDegrees =
        static_cast<float>(readNumber(parts[2], allowed("angular_radius_degrees")));
  return light;
}

/// X,Y,Z:R,G,B:DX,DY,DZ[:INNER,OUTER]
SpotLight readSpot(const Given& given) {
  const std::vector<Given> parts = partsOf(given);
  if (parts.size() < 3 || parts.size() > 4) {
    throw UsageError(fmt::format(
        "{} {}: needs a place, an intensity and a direction, X,Y,Z:R,G,B:DX,DY,DZ, and perhaps the "
        "degrees from its axis between which it falls off, :INNER,OUTER",
        given.option, given.text));
  }
  SpotLight light{
      .positionMm = readPlace(parts[0], lengthRange),
      .direction = readDirection(parts[2]),
      .intensity = readColour(parts[1], options::fieldOf<SpotLight>("intensity").allowed.range)};
  if (parts.size() == 4) {
    const std::string& angles = parts[3].text;
    const std::size_t comma = angles.find(',');
    if (comma == std::string::npos) {
      throw UsageError(fmt::format("{} {}: needs two angles, INNER,OUTER, in degrees", given.option,
                                   given.text));
    }
    const auto degrees = [&](const std::string& text, std::string_view key) {
      return static_cast<float>(readNumber({given.option, text, given.text},
                                           options::fieldOf<SpotLight>(key).allowed.range));
    };
    light.innerDegrees = degrees(angles.substr(0, comma), "inner_degrees");
    light.outerDegrees = degrees(angles.substr(comma + 1), "outer_degrees");
  }
  return checked(given, light);
}

/// The text's parts, which must be as many as the light has; else an error says what it needs.
std::vector<Given> partsOf(const Given& given, std::size_t count, const char* needs) {
  std::vector<Given> parts = partsOf(given);
  if (parts.size() == count) return parts;
  throw UsageError(fmt::format("{} {}: needs {}", given.option, given.text, needs));
}

template <typename Light>
float readRadius(const Given& given) {
  return static_cast<float>(readNumber(given, options::fieldOf<Light>("radius_mm").allowed.range));
}

template <typename Light>
Rgb readRadiance(const Given& given) {
  return readColour(given, options::fieldOf<Light>("radiance").allowed.range);
}

AreaLight readRectangle(const Given& given) {
  const auto parts = partsOf(given, 4,
                             "a centre, two half edges and a radiance, "
                             "X,Y,Z:X,Y,Z:X,Y,Z:R,G,B, and shines to the side of the "
                             "edges' cross product");
  return checked(given, RectangleLight{.centreMm = readPlace(parts[0], lengthRange),
                                       .uMm = readPlace(parts[1], lengthRange),
                                       .vMm = readPlace(parts[2], lengthRange),
                                       .radiance = readRadiance<RectangleLight>(parts[3])});
}

AreaLight readDisc(const Given& given) {
  const auto parts = partsOf(given, 4,
                             "a centre, a normal to the side that shines, a radius and a "
                             "radiance, X,Y,Z:X,Y,Z:MM:R,G,B");
  return checked(given, DiscLight{.centreMm = readPlace(parts[0], lengthRange),
                                  .normal = readDirection(parts[1]),
                                  .radiusMm = readRadius<DiscLight>(parts[2]),
                                  .radiance = readRadiance<DiscLight>(parts[3])});
}

AreaLight readSphere(const Given& given) {
  const auto parts = partsOf(given, 3, "a centre, a radius and a radiance, X,Y,Z:MM:R,G,B");
  return checked(given, SphereLight{.centreMm = readPlace(parts[0], lengthRange),
                                    .radiusMm = readRadius<SphereLight>(parts[1]),
                                    .radiance = readRadiance<SphereLight>(parts[2])});
}

AreaLight readTube(const Given& given) {
  const auto parts =
      partsOf(given, 4, "its two ends, a radius and a radiance, X,Y,Z:X,Y,Z:MM:R,G,B");
  return checked(given, TubeLight{.fromMm = readPlace(parts[0], lengthRange),
                                  .toMm = readPlace(parts[1], lengthRange),
                                  .radiusMm = readRadius<TubeLight>(parts[2]),
                                  .radiance = readRadiance<TubeLight>(parts[3])});
}

Vec3 sum(const Vec3& a, const Vec3& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

void move(const Vec3& by, AreaLight& area) {
  if (auto* tube = std::get_if<TubeLight>(&area)) {
    tube->fromMm = sum(by, tube->fromMm);
    tube->toMm = sum(by, tube->toMm);
  } else {
    std::visit(
        [&](auto& light) {
          if constexpr (requires { light.centreMm; }) light.centreMm = sum(by, light.centreMm);
        },
        area);
  }
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
               diagonalMm_ = static_cast<float>(
                   readNumber(given, options::fieldOf<LoadOptions>("diagonal_mm").allowed.range));
             });
  medium_.addTo(line);
  line.value("--morph-to", "FILE", "mesh to turn into; colors: observed, khr",
             [this](const Given& given) { morphTo_ = given.text; });
  addField(line, options::fieldOf<LoadOptions>("color_model"), chosen_, {}, "");
}

bool SceneOptions::any() const {
  return !files_.empty() || builtIn_ || diagonalMm_ || morphTo_ || medium_.any() ||
         !chosen_.empty();
}

std::string SceneOptions::name() const {
  if (files_.empty()) return builtIn_.value_or("bear");
  const std::string stem = files_.front().stem().string();
  const std::optional<FrameNames> names = FrameNames::parse(stem);
  return names ? names->common() : stem;
}

OwnMedia SceneOptions::ownMedia() const {
  return medium_.names() && files_.size() == 1 ? mediaOf(files_.front()) : OwnMedia();
}

void SceneOptions::checkMedia() const {
  const OwnMedia own = ownMedia();
  static_cast<void>(medium_.medium(own));
  static_cast<void>(medium_.ofObjects(own));
}

LoadedScene SceneOptions::load(const LogCallback& log) const {
  if (!files_.empty() && builtIn_) {
    throw UsageError(fmt::format("--builtin {} and the scene {} exclude each other", *builtIn_,
                                 files_.front().string()));
  }
  if (morphTo_ && files_.empty()) {
    throw UsageError(
        fmt::format("--morph-to {}: a built-in scene cannot turn into another mesh; name a SCENE",
                    morphTo_->string()));
  }
  LoadOptions options;
  options.diagonalMm = diagonalMm_;
  const OwnMedia own = ownMedia();
  options.medium = medium_.medium(own);
  options.media = medium_.ofObjects(own);
  options.morphTo = morphTo_;
  options.log = log;
  chosen_.applyTo(options);
  if (files_.empty()) {
    const bool teapot = builtIn_ == "teapot";
    return {teapot ? builtInTeapot(options) : builtInBear(options),
            {},
            sourceOf(teapot ? "builtin:teapot" : "builtin:bear", options),
            {}};
  }
  if (files_.size() == 1 && MeshSequence::isPattern(files_.front())) {
    auto sequence = std::make_shared<const MeshSequence>(files_.front(), options);
    return {sequence->scene(), {}, sourceOf(files_.front(), options), sequence};
  }
  return loadSceneFiles(files_, options);
}

void LightOptions::addTo(CommandLine& line) {
  line.repeated("--directional", "DIR[:RGB[:R]]",
                "to the light; irradiance [1,1,1]; radius, degrees", [this](const Given& given) {
                  directional_.push_back(readDirectional(given));
                  any_ = true;
                });
  line.repeated("--point", "X,Y,Z:R,G,B", "mm, irradiance at 1 mm", [this](const Given& given) {
    const PlacedColour light =
        readPlacedColour(given, options::fieldOf<PointLight>("intensity").allowed.range);
    if (!light.colour) {
      throw UsageError(
          fmt::format("{} {}: needs an intensity, X,Y,Z:R,G,B", given.option, given.text));
    }
    points_.push_back({readPlace(light.place, lengthRange), *light.colour});
    any_ = true;
  });
  line.repeated("--spot", "X,Y,Z:R,G,B[:DIR[:INNER,OUTER]]", "", [this](const Given& given) {
    spots_.push_back(readSpot(given));
    any_ = true;
  });
  const auto area = [&](const std::string& name, const std::string& placeholder,
                        const std::string& help, AreaLight (*read)(const Given&)) {
    line.repeated(name, placeholder, help, [this, read](const Given& given) {
      areas_.push_back(read(given));
      any_ = true;
    });
  };
  area("--rectangle", "SHAPE:R,G,B", "see docs/light.md", readRectangle);
  area("--disc", "SHAPE:R,G,B", "", readDisc);
  area("--sphere", "SHAPE:R,G,B", "", readSphere);
  area("--tube", "SHAPE:R,G,B", "", readTube);
  line.value("--ambient", "R,G,B", "radiance from all sides; albedo [0.5]",
             [this](const Given& given) {
               ambient_ = readColour(given, options::fieldOf<Lighting>("radiance").allowed.range);
               any_ = true;
             });
  line.valueOr("--ground", "[R,G,B]", options::textOf(Ground{}.color), [this](const Given& given) {
    ground_ = Ground{.color = readColour(given, options::fieldOf<Ground>("color").allowed.range)};
  });
  line.value("--environment", "FILE", "latitude-longitude .hdr or .exr, radiance",
             [this](const Given& given) {
               environment_ = given.text;
               any_ = true;
             });
  addTogether(line, {"rotation_degrees", "intensity"}, {"degrees", "factor"}, turned_,
              {"--environment-rotation", "--environment-intensity"});
}

void LightOptions::applyTo(LoadedScene& loaded) const {
  if (ground_) {
    removeGround(loaded.scene);
    loaded.scene.objects.push_back(groundUnder(loaded.scene, *ground_));
  }
  if (any_) {
    loaded.source.environment.reset();
    if (environment_) {
      loaded.source.environment = EnvironmentFile{std::filesystem::absolute(*environment_)};
    }
    loaded.scene.lighting = lightingFor(loaded.scene);
    stopLights(loaded.scene);
  }
  std::optional<EnvironmentFile>& environment = loaded.source.environment;
  if (!environment && !turned_.empty()) {
    throw UsageError(
        fmt::format("--environment-{} needs an environment: name one with --environment FILE",
                    turned_.has("intensity") ? "intensity" : "rotation"));
  }
  if (!environment || !(environment_ || !turned_.empty())) return;
  turned_.applyTo(*environment);
  loaded.scene.lighting.environment = readEnvironment(*environment);
}

Lighting LightOptions::lightingFor(const Scene& scene) const {
  Lighting lighting;
  lighting.directional = directional_;
  const Vec3 middle = middleOf(boundsOf(scene));
  for (PointLight light : points_) {
    light.positionMm = sum(middle, light.positionMm);
    lighting.points.push_back(light);
  }
  for (SpotLight light : spots_) {
    light.positionMm = sum(middle, light.positionMm);
    lighting.spots.push_back(light);
  }
  lighting.areas = areas_;
  for (AreaLight& light : lighting.areas) move(middle, light);
  lighting.ambient = ambient_;
  return lighting;
}

void CameraOptions::addTo(CommandLine& line) {
  line.value("--camera-direction", "X,Y,Z", "from the target to the camera [0,0,1]",
             [this](const Given& given) { place_.direction = readDirection(given); });
  line.value("--camera-position", "X,Y,Z", "mm from the box's centre",
             [this](const Given& given) { place_.positionMm = readPlace(given, lengthRange); });
  line.value("--camera-target", "X,Y,Z", "",
             [this](const Given& given) { place_.targetMm = readPlace(given, lengthRange); });
  addField(line, options::fieldOf<Camera>("fov_degrees"), chosen_);
}

void CameraOptions::check() const {
  if (!place_.direction || !place_.positionMm) return;
  throw UsageError(
      "--camera-direction and --camera-position exclude each other: a direction keeps the distance "
      "and a position has one");
}

void CameraOptions::applyTo(Scene& scene) const {
  check();
  if (any()) stopCamera(scene);
  Camera& camera = scene.camera;
  const Vec3 middle = middleOf(boundsOf(scene));
  CameraPlace place = place_;
  for (std::optional<Vec3>* const point : {&place.positionMm, &place.targetMm})
    if (*point) *point = sum(middle, **point);
  placeCamera(place, camera);
  if (!(distanceToTargetMm(camera) > 0)) {
    throw UsageError("--camera-position and --camera-target are the same place");
  }
  if (chosen_.has("fov_degrees") && camera.orthographicHeightMm) {
    throw UsageError(
        "--fov-degrees is of a pinhole camera; the lines of sight of this scene's camera are "
        "parallel, and [camera] orthographic_height_mm says how much it sees");
  }
  chosen_.applyTo(camera);
  scene.cameraChosen = scene.cameraChosen || place.positionMm || place.targetMm || !chosen_.empty();
}

}  // namespace opaline::app
