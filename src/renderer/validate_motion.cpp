#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "opaline/error.h"
#include "opaline/options/scene.h"
#include "renderer/validate.h"
#include "shaders/shared/deform.h"

namespace opaline {

namespace {

[[noreturn]] void refuse(const Scene& scene, const std::string& what) {
  throw Error(fmt::format("scene '{}': {}", scene.name, what));
}

template <typename T>
bool allFinite(const T& values) {
  return std::all_of(values.begin(), values.end(), [](float v) { return std::isfinite(v); });
}

bool allFinite(const std::vector<Vec3>& list) {
  return std::all_of(list.begin(), list.end(), [](const Vec3& v) { return allFinite(v); });
}

bool allFinite(const Affine& map) {
  return std::all_of(map.columns.begin(), map.columns.end(),
                     [](const Vec3& column) { return allFinite(column); });
}

void validateNodes(const Scene& scene) {
  for (std::size_t n = 0; n < scene.nodes.size(); ++n) {
    const Node& node = scene.nodes[n];
    if (node.parent < -1 || (node.parent >= 0 && static_cast<std::size_t>(node.parent) >= n))
      refuse(scene, fmt::format("the parent of node {} is {}, but must be an earlier one or -1", n,
                                node.parent));
    if (!allFinite(node.translation) || !allFinite(node.rotation) || !allFinite(node.scale) ||
        !allFinite(node.morphWeights) || (node.matrix && !allFinite(*node.matrix)))
      refuse(scene, fmt::format("node {} has numbers that are not finite", n));
  }
}

std::size_t partsOfKey(const Track& track) {
  return track.interpolation == Interpolation::CubicSpline ? 3 : 1;
}

// How many values a part of a key has. For weights it follows from the track's own sizes.
std::size_t valuesOfPart(const Track& track) {
  if (track.target == TrackTarget::Rotation) return 4;
  if (track.target != TrackTarget::MorphWeights) return 3;
  return track.values.size() / (partsOfKey(track) * track.seconds.size());
}

void validateTrack(const Scene& scene, const Clip& clip, const Track& track) {
  if (track.node >= scene.nodes.size())
    refuse(scene,
           fmt::format("clip '{}' moves node {}, which does not exist", clip.name, track.node));
  if (!isUpTo(TrackTarget::MorphWeights, track.target) ||
      !isUpTo(Interpolation::CubicSpline, track.interpolation))
    refuse(scene, fmt::format("clip '{}' has a track of an unknown kind: target {}, "
                              "interpolation {}",
                              clip.name, static_cast<int>(track.target),
                              static_cast<int>(track.interpolation)));
  if (track.seconds.empty() || !allFinite(track.seconds) || !allFinite(track.values) ||
      !std::is_sorted(track.seconds.begin(), track.seconds.end()))
    refuse(scene, fmt::format("clip '{}' has a track whose times are not finite and ascending",
                              clip.name));
  if (track.values.size() != partsOfKey(track) * track.seconds.size() * valuesOfPart(track))
    refuse(scene, fmt::format("clip '{}' has a track of {} keys with {} values", clip.name,
                              track.seconds.size(), track.values.size()));
}

void validateSkin(const Scene& scene, const Object& object, const Rig& rig) {
  if (rig.joints.empty()) return;
  const std::size_t vertices = rig.positions.size();
  if (rig.firstInfluence.size() != vertices + 1 || rig.firstInfluence.front() != 0 ||
      rig.firstInfluence.back() != rig.influences.size() ||
      !std::is_sorted(rig.firstInfluence.begin(), rig.firstInfluence.end()))
    refuse(scene, fmt::format("the influences of object '{}' do not fit its {} vertices",
                              object.name, vertices));
  for (const Influence& influence : rig.influences)
    if (influence.joint >= rig.joints.size() || !std::isfinite(influence.weight))
      refuse(scene, fmt::format("object '{}' has an influence of joint {} with weight {}, but {} "
                                "joints",
                                object.name, influence.joint, influence.weight, rig.joints.size()));
  for (const Joint& joint : rig.joints)
    if (joint.node >= scene.nodes.size() || !allFinite(joint.inverseBind))
      refuse(scene,
             fmt::format("a joint of object '{}' is node {}, which does not exist, or is not "
                         "finite",
                         object.name, joint.node));
}

void validateRig(const Scene& scene, const Object& object, const Rig& rig) {
  const std::size_t vertices = object.mesh.positionsMm.size();
  const auto fits = [&](const std::vector<Vec3>& list, bool mayBeEmpty) {
    return (list.size() == vertices || (mayBeEmpty && list.empty())) && allFinite(list);
  };
  if (rig.node >= scene.nodes.size())
    refuse(scene, fmt::format("object '{}' hangs on node {}, which does not exist", object.name,
                              rig.node));
  bool whole = fits(rig.positions, false) && fits(rig.normals, false) && allFinite(rig.toScene);
  for (const MorphTarget& target : rig.targets)
    whole = whole && fits(target.positions, true) && fits(target.normals, true);
  if (!whole)
    refuse(scene, fmt::format("the rig of object '{}' needs finite positions and normals for each "
                              "of its {} vertices, and so do its morph targets",
                              object.name, vertices));
  validateSkin(scene, object, rig);
}

template <typename T>
void validateKeys(const Scene& scene, const Keys<T>& keys, std::size_t count,
                  std::string_view what) {
  if (keys.index >= count)
    refuse(scene, fmt::format("a clip changes {} {}, which does not exist", what, keys.index));
  if (keys.seconds.empty() || keys.values.size() != keys.seconds.size() ||
      !allFinite(keys.seconds) || !std::is_sorted(keys.seconds.begin(), keys.seconds.end()))
    refuse(scene, fmt::format("a clip changes {} {} at times that are not finite and ascending, or "
                              "not as many as values",
                              what, keys.index));
  for (const T& value : keys.values)
    if (const std::string complaint = complaintAbout(value); !complaint.empty())
      refuse(scene, fmt::format("a clip changes {} {}: {}", what, keys.index, complaint));
}

void validateChanges(const Scene& scene, const ClipChanges& changes) {
  const auto validate = [&](const auto& all, std::size_t count, std::string_view what) {
    for (const auto& keys : all) validateKeys(scene, keys, count, what);
  };
  // Any index is allowed, since fewer lights may have replaced those of the clip.
  constexpr std::size_t any = std::numeric_limits<std::size_t>::max();
  validate(changes.directional, any, "directional light");
  validate(changes.points, any, "point light");
  validate(changes.spots, any, "spot light");
  validate(changes.cameras, 1, "camera");
  validate(changes.surfaces, scene.objects.size(), "object");
  validate(changes.media, scene.objects.size(), "object");
  for (const Keys<OpaqueMaterial>& keys : changes.surfaces)
    if (!scene.objects[keys.index].opaque)
      refuse(scene, fmt::format("a clip changes the surface of object '{}', which is not opaque",
                                scene.objects[keys.index].name));
  for (const Keys<Medium>& keys : changes.media) {
    const Object& object = scene.objects[keys.index];
    if (object.opaque || object.paint)
      refuse(scene, fmt::format("a clip changes the medium of object '{}', which is opaque or "
                                "painted",
                                object.name));
  }
}

}  // namespace

void validateMotion(const Scene& scene) {
  validateNodes(scene);
  for (const Clip& clip : scene.clips) {
    if (!(clip.seconds >= 0) || !std::isfinite(clip.seconds))
      refuse(scene, fmt::format("clip '{}' is {} s long", clip.name, clip.seconds));
    for (const Track& track : clip.tracks) validateTrack(scene, clip, track);
  }
  if (scene.changes.size() > scene.clips.size())
    refuse(scene, fmt::format("there are changes of {} clips, but {} clips", scene.changes.size(),
                              scene.clips.size()));
  for (const ClipChanges& changes : scene.changes) validateChanges(scene, changes);
  for (const Object& object : scene.objects)
    if (object.rig) validateRig(scene, object, *object.rig);
  validate(scene.deformers);
}

void validate(const std::vector<Deformer>& deformers) {
  for (const Deformer& deformer : deformers)
    if (const std::string complaint = options::complaintAbout(deformer); !complaint.empty())
      throw UsageError("a deformer: " + complaint);
  static_assert(maxDeformers == shared::maxDeformers);
  if (deformers.size() > maxDeformers)
    throw UsageError(
        fmt::format("there are {} deformers, but there may be {}", deformers.size(), maxDeformers));
}

}  // namespace opaline
