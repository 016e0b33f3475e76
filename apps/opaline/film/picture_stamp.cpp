#include "film/picture_stamp.h"

#include <fmt/format.h>

#include <utility>

#include "cli/json.h"
#include "cli/picture_options.h"
#include "core/digest.h"
#include "core/file.h"
#include "film/sequence_frames.h"

namespace opaline::app {

namespace {

using core::Digest;

// Every structure is taken apart whole: whoever gives it another member is told by the compiler
// that the stamp must know of it, or that it does not decide pixels.

template <typename T, typename Add>
void addEach(Digest& digest, const std::vector<T>& values, const Add& add) {
  digest.add(std::uint64_t{values.size()});
  for (const T& value : values) add(value);
}

template <typename T, typename Add>
void addIfThere(Digest& digest, const std::optional<T>& value, const Add& add) {
  digest.add(value.has_value());
  if (value) add(*value);
}

void addRig(Digest& digest, const Rig& rig) {
  const auto& [node, positions, normals, targets, joints, firstInfluence, influences, toScene] =
      rig;
  digest.add(node);
  digest.add(positions);
  digest.add(normals);
  addEach(digest, targets, [&](const MorphTarget& target) {
    const auto& [moved, turned] = target;
    digest.add(moved);
    digest.add(turned);
  });
  digest.add(joints);
  digest.add(firstInfluence);
  digest.add(influences);
  digest.add(toScene);
}

void addObject(Digest& digest, const Object& object) {
  const auto& [name, mesh, medium, rig] = object;
  const auto& [positionsMm, normals, triangles, facetted] = mesh;
  const auto& [mediumName, sigmaSPrimePerMm, sigmaAPerMm, eta] = medium;
  digest.add(positionsMm);
  digest.add(normals);
  digest.add(triangles);
  digest.add(facetted);
  digest.add(sigmaSPrimePerMm);
  digest.add(sigmaAPerMm);
  digest.add(eta);
  addIfThere(digest, rig, [&](const Rig& given) { addRig(digest, given); });
}

void addMotion(Digest& digest, const Scene& scene) {
  addEach(digest, scene.nodes, [&](const Node& node) {
    const auto& [name, parent, translation, rotation, scale, matrix, morphWeights] = node;
    digest.add(parent);
    digest.add(translation);
    digest.add(rotation);
    digest.add(scale);
    addIfThere(digest, matrix, [&](const Affine& affine) { digest.add(affine); });
    digest.add(morphWeights);
  });
  addEach(digest, scene.clips, [&](const Clip& clip) {
    const auto& [name, seconds, tracks] = clip;
    digest.add(seconds);
    addEach(digest, tracks, [&](const Track& track) {
      const auto& [node, target, interpolation, keys, values] = track;
      digest.add(node);
      digest.add(target);
      digest.add(interpolation);
      digest.add(keys);
      digest.add(values);
    });
  });
  addEach(digest, scene.deformers, [&](const Deformer& deformer) {
    const auto& [kind, amount, periodSeconds] = deformer;
    digest.add(kind);
    digest.add(amount);
    digest.add(periodSeconds);
  });
}

void addLighting(Digest& digest, const Lighting& lighting) {
  const auto& [directional, points, ambient, environment] = lighting;
  addEach(digest, directional, [&](const DirectionalLight& light) {
    const auto& [directionToLight, irradiance] = light;
    digest.add(directionToLight);
    digest.add(irradiance);
  });
  addEach(digest, points, [&](const PointLight& light) {
    const auto& [positionMm, intensity] = light;
    digest.add(positionMm);
    digest.add(intensity);
  });
  digest.add(ambient);
  digest.add(environment != nullptr);
  if (!environment) return;
  digest.add(environment->width);
  digest.add(environment->rgba);
}

void addScene(Digest& digest, const Scene& scene) {
  // What the camera sees counts, and not who chose it.
  const auto& [name, objects, lighting, camera, cameraChosen, nodes, clips, deformers, repairs,
               notShown] = scene;
  addEach(digest, objects, [&](const Object& object) { addObject(digest, object); });
  addLighting(digest, lighting);
  const auto& [positionMm, targetMm, up, verticalFovDegrees] = camera;
  digest.add(positionMm);
  digest.add(targetMm);
  digest.add(up);
  digest.add(verticalFovDegrees);
  addMotion(digest, scene);
}

void addOptions(Digest& digest, const RenderOptions& options) {
  // How often, when and how patiently it is rendered changes no pixel.
  const auto& [width, height, transport, sum, site, tolerance, maxSources, boundarySurfels, bounces,
               pattern, dsmSize, shadowSize, specular, roughness, treeLevel, antialias, frames,
               seconds, clip, patient, reuseLight] = options;
  const auto& [nearRings, nearSpacing, farDistance] = pattern;
  const auto add = [&](const auto&... values) { (digest.add(values), ...); };
  add(width, height, transport, sum, site, tolerance, maxSources, boundarySurfels, bounces,
      nearRings, nearSpacing, farDistance, dsmSize, shadowSize, specular, roughness, treeLevel,
      antialias, clip);
}

void addTone(Digest& digest, const core::ToneOptions& tone) {
  const auto& [exposureStops, curve, background] = tone;
  digest.add(exposureStops);
  digest.add(curve);
  addIfThere(digest, background, [&](const Rgb& colour) { digest.add(colour); });
}

void addFile(Digest& digest, const std::filesystem::path& file) {
  constexpr std::size_t mostBytes = std::size_t{1} << 31U;
  digest.add(core::readFile(file, mostBytes));
}

/// What people want to know of a picture that they find.
Json readable(const PictureMakers& makers) {
  Json media = Json::array();
  for (const Object& object : makers.scene.objects) {
    media.push_back({{"object", object.name},
                     {"medium", object.medium.name},
                     {"sigma_s_per_mm", object.medium.sigmaSPrimePerMm},
                     {"sigma_a_per_mm", object.medium.sigmaAPerMm},
                     {"eta", object.medium.eta}});
  }
  const RenderOptions& options = makers.options;
  return {{"program", "opaline " OPALINE_VERSION},
          {"scene", makers.scene.name},
          {"diagonal_mm", diagonalMm(makers.scene)},
          {"media", std::move(media)},
          {"size", {options.width, options.height}},
          {"transport", nameOf(options.transport, transports())},
          {"sum", nameOf(options.sum, sums())},
          {"site", nameOf(options.site, sites())}};
}

}  // namespace

std::function<std::string(int frame)> frameStamps(const PictureMakers& makers,
                                                  const FrameRange& frames) {
  Digest ofAll;
  ofAll.addBytes(OPALINE_VERSION, sizeof(OPALINE_VERSION));
  addScene(ofAll, makers.scene);
  addOptions(ofAll, makers.options);
  ofAll.add(makers.aov);
  addIfThere(ofAll, makers.tone, [&](const core::ToneOptions& tone) { addTone(ofAll, tone); });
  return [ofAll, frames, json = readable(makers), sequence = makers.sequence](int frame) {
    Digest digest = ofAll;
    digest.add(frames.seconds(frame));
    if (sequence) addFile(digest, sequence->file(numberOfFrame(*sequence, frame)));
    Json stamp = json;
    stamp["seconds"] = frames.seconds(frame);
    stamp["digest"] = fmt::format("{:016x}", digest.value());
    return stamp.dump(-1, ' ', true, Json::error_handler_t::replace);
  };
}

bool isSamePicture(const std::string& stamp, const std::string& other) {
  const auto digestOf = [](const std::string& text) {
    const Json json = Json::parse(text, nullptr, false);
    const bool holdsOne = json.is_object() && json.contains("digest");
    return holdsOne && json["digest"].is_string() ? json["digest"].get<std::string>() : "";
  };
  const std::string digest = digestOf(stamp);
  return !digest.empty() && digest == digestOf(other);
}

}  // namespace opaline::app
