#include "scene/gltf/changes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "opaline/options/scene.h"
#include "scene/gltf/lights.h"
#include "scene/gltf/medium.h"
#include "scene/not_shown.h"
#include "scene/pose.h"
#include "scene/text.h"
#include "scene/track_sample.h"
#include "scene/vector_math.h"

namespace opaline::scene {

namespace {

/// Step at which curves are sampled.
constexpr double stepSeconds = 1.0 / 60;
/// Most moments for one thing in one clip, and for a whole file.
constexpr std::size_t mostMoments = 2048;
constexpr std::size_t mostMomentsOfFile = 100'000;

/// The times at which to sample: those of the keys, steps between them, and just before each step
/// of a step track the last moment of the old value.
std::vector<float> momentsOf(const std::vector<const Track*>& tracks) {
  std::vector<float> times;
  for (const Track* track : tracks) {
    const std::vector<float>& keys = track->seconds;
    if (keys.size() > mostMoments) continue;  // steps serve as well as so many keys
    times.insert(times.end(), keys.begin(), keys.end());
    if (track->interpolation != Interpolation::Step) continue;
    for (const float key : keys)
      if (key > 0) times.push_back(std::nextafter(key, 0.0F));
  }
  float first = INFINITY;
  float last = 0;
  for (const Track* track : tracks) {
    first = std::min(first, track->seconds.front());
    last = std::max(last, track->seconds.back());
  }
  const double length = double{last} - double{first};
  const double wanted = std::ceil(length / stepSeconds);
  const auto steps = static_cast<std::size_t>(std::clamp(wanted, 1.0, double{mostMoments} / 2));
  if (times.size() > mostMoments / 2) times.clear();
  for (std::size_t i = 0; i <= steps; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(steps);
    times.push_back(std::clamp(static_cast<float>(double{first} + part * length), first, last));
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

/// Reads the changes of the clips, one after the other.
class Reader {
 public:
  Reader(const Input& input, const tinygltf::Model& model, const GltfNodes& nodes,
         const GltfMotion& motion, const GltfParts& parts, GltfMaterials& materials,
         RawScene& scene)
      : input_(input),
        model_(model),
        nodes_(nodes),
        motion_(motion),
        parts_(parts),
        materials_(materials),
        scene_(scene) {
    moving_.nodes = motion.nodes;
    moving_.clips = motion.clips;
    pose_ = makePose(moving_);
  }

  std::vector<ClipChanges> read() {
    std::vector<ClipChanges> all(motion_.clips.size());
    for (std::size_t c = 0; c < all.size(); ++c) {
      clip_ = c;
      for (const GltfLight& light : parts_.lights) readLightKeys(light, all[c]);
      if (parts_.cameraNode) readCameraKeys(*parts_.cameraNode, all[c]);
      for (std::size_t i = 0; i < scene_.objects.size(); ++i) readMaterialKeys(i, all[c]);
    }
    for (const std::string& pointer : motion_.notAnimated)
      addNotShown(scene_.notShown, "animated properties", cleanText(pointer, 100));
    return all;
  }

 private:
  /// Tracks of the clip that move a node, by way of its ancestors too.
  std::vector<const Track*> tracksOf(std::size_t node) const {
    std::vector<bool> above(motion_.nodes.size());
    for (int n = static_cast<int>(node); n >= 0; n = nodes_.parents[static_cast<std::size_t>(n)])
      above[motion_.place[static_cast<std::size_t>(n)]] = true;
    std::vector<const Track*> tracks;
    for (const Track& track : motion_.clips[clip_].tracks)
      if (above[track.node] && track.target != TrackTarget::MorphWeights) tracks.push_back(&track);
    return tracks;
  }

  std::vector<const GltfPointerTrack*> pointersTo(GltfPointer::Of of, std::size_t index) const {
    std::vector<const GltfPointerTrack*> found;
    for (const GltfPointerTrack& pointer : motion_.pointers[clip_])
      if (pointer.to.of == of && pointer.to.index == index) found.push_back(&pointer);
    return found;
  }

  /// `of` with its properties set to what these pointers say at a time.
  template <typename T>
  static T at(double seconds, const std::vector<const GltfPointerTrack*>& pointers, T of) {
    for (const GltfPointerTrack* pointer : pointers) {
      const TrackSample sample(pointer->track, seconds);
      std::array<double, 4> numbers{};
      for (std::size_t i = 0; i < pointer->to.width; ++i) numbers[i] = sample.interpolated(i);
      setProperty(pointer->to, std::span(numbers).first(pointer->to.width), of);
    }
    return of;
  }

  /// The moments of everything that moves a thing. Empty where nothing does, or where the file has
  /// no moments left.
  std::vector<float> moments(std::vector<const Track*> tracks,
                             const std::vector<const GltfPointerTrack*>& pointers,
                             const std::string& name) {
    for (const GltfPointerTrack* pointer : pointers) tracks.push_back(&pointer->track);
    if (tracks.empty()) return {};
    std::vector<float> times = momentsOf(tracks);
    if (times.size() > room_) {
      addNotShown(scene_.notShown, "animated properties beyond 100000 moments", name);
      return {};
    }
    room_ -= times.size();
    return times;
  }

  /// A node's transform; null while it has no directions.
  const Matrix4* worldAt(std::size_t node, double seconds) {
    poseAt(moving_, static_cast<int>(clip_), seconds, pose_);
    const Matrix4& world = pose_.world[motion_.place[node]];
    return hasDirections(world) ? &world : nullptr;
  }

  template <typename T>
  static void add(float seconds, T value, Keys<T>& to) {
    to.seconds.push_back(seconds);
    to.values.push_back(std::move(value));
  }

  template <typename T>
  static void keep(Keys<T> keys, std::size_t index, std::vector<Keys<T>>& to) {
    if (keys.seconds.empty()) return;
    keys.index = static_cast<std::uint32_t>(index);
    to.push_back(std::move(keys));
  }

  void readLightKeys(const GltfLight& of, ClipChanges& to) {
    const tinygltf::Light& light = model_.lights[of.light];
    const auto pointers = pointersTo(GltfPointer::Of::Light, of.light);
    Keys<DirectionalLight> directional;
    Keys<PointLight> points;
    Keys<SpotLight> spots;
    for (const float seconds : moments(tracksOf(of.node), pointers, light.name)) {
      const Matrix4* const world = worldAt(of.node, double{seconds});
      if (world == nullptr) continue;
      tinygltf::Light now = at(double{seconds}, pointers, light);
      now.spot.innerConeAngle = std::min(now.spot.innerConeAngle, now.spot.outerConeAngle);
      const auto read = readLight(input_, now, *world, of.node);
      if (const auto* one = std::get_if<DirectionalLight>(&*read)) add(seconds, *one, directional);
      if (const auto* one = std::get_if<PointLight>(&*read)) add(seconds, *one, points);
      if (const auto* one = std::get_if<SpotLight>(&*read)) add(seconds, *one, spots);
    }
    keep(std::move(directional), of.index, to.directional);
    keep(std::move(points), of.index, to.points);
    keep(std::move(spots), of.index, to.spots);
  }

  /// The target keeps the distance that the scene's camera has from its own.
  void readCameraKeys(std::size_t node, ClipChanges& to) {
    const auto index = static_cast<std::size_t>(model_.nodes[node].camera);
    const tinygltf::Camera& camera = model_.cameras[index];
    const auto pointers = pointersTo(GltfPointer::Of::Camera, index);
    const options::Range degrees = options::fieldOf<Camera>("fov_degrees").allowed.range;
    const double distance =
        length(toDouble(scene_.camera->targetMm) - toDouble(scene_.camera->positionMm));
    Keys<Camera> keys;
    for (const float seconds : moments(tracksOf(node), pointers, camera.name)) {
      const Matrix4* const world = worldAt(node, double{seconds});
      if (world == nullptr) continue;
      tinygltf::Camera now = at(double{seconds}, pointers, camera);
      constexpr double degree = 3.14159265358979323846 / 180;
      now.perspective.yfov = std::clamp(now.perspective.yfov, 1.0001 * degrees.least * degree,
                                        0.9999 * degrees.most * degree);
      Camera one = readCamera(input_, now, *world);
      const Double3 from = toDouble(one.positionMm);
      one.targetMm = toFloat(from + distance * (toDouble(one.targetMm) - from));
      if (complaintAbout(one).empty()) add(seconds, one, keys);
    }
    keep(std::move(keys), 0, to.cameras);
  }

  void readMaterialKeys(std::size_t object, ClipChanges& to) {
    const int material = parts_.materialOfObject[object];
    if (material < 0) return;
    const auto index = static_cast<std::size_t>(material);
    const tinygltf::Material& of = model_.materials[index];
    auto pointers = pointersTo(GltfPointer::Of::Material, index);
    const RawObject& body = scene_.objects[object];
    std::erase_if(pointers, [&](const GltfPointerTrack* pointer) {
      const std::string& property = pointer->to.property;
      const bool ofMedium = property.starts_with("extensions/KHR_materials_volume") ||
                            property.starts_with("extensions/KHR_materials_scatter");
      const bool isSeen = ofMedium != body.opaque.has_value();
      if (!isSeen) addNotShown(scene_.notShown, "animated properties", property);
      return !isSeen;
    });
    if (pointers.empty()) return;
    if (body.opaque) {
      Keys<OpaqueMaterial> keys;
      for (const float seconds : moments({}, pointers, of.name))
        add(seconds, materials_.opaqueOf(at(double{seconds}, pointers, of)), keys);
      return keep(std::move(keys), object, to.surfaces);
    }
    if (body.paint || !saysMediumByVolume(of) || saysMediumInExtras(of)) {
      addNotShown(scene_.notShown,
                  body.paint ? "animated colours of painted media"
                             : "animated properties of media that are given otherwise",
                  of.name);
      return;
    }
    Keys<Medium> keys;
    for (const float seconds : moments({}, pointers, of.name)) {
      auto medium = gltfMediumByVolume(input_, at(double{seconds}, pointers, of));
      if (!medium) continue;
      medium->eta = body.medium.eta;
      add(seconds, std::move(*medium), keys);
    }
    keep(std::move(keys), object, to.media);
  }

  const Input& input_;
  const tinygltf::Model& model_;
  const GltfNodes& nodes_;
  const GltfMotion& motion_;
  const GltfParts& parts_;
  GltfMaterials& materials_;
  RawScene& scene_;
  Scene moving_;  // holds nodes and clips only
  Pose pose_;
  std::size_t clip_ = 0;
  std::size_t room_ = mostMomentsOfFile;
};

}  // namespace

bool isAnimated(const GltfMotion& motion, int material) {
  if (material < 0) return false;
  const auto index = static_cast<std::size_t>(material);
  for (const std::vector<GltfPointerTrack>& clip : motion.pointers)
    for (const GltfPointerTrack& pointer : clip)
      if (pointer.to.of == GltfPointer::Of::Material && pointer.to.index == index) return true;
  return false;
}

std::vector<ClipChanges> readChanges(const Input& input, const tinygltf::Model& model,
                                     const GltfNodes& nodes, const GltfMotion& motion,
                                     const GltfParts& parts, GltfMaterials& materials,
                                     RawScene& scene) {
  return Reader(input, model, nodes, motion, parts, materials, scene).read();
}

}  // namespace opaline::scene
