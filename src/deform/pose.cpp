#include "deform/pose.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace opaline::deform {

namespace {

using scene::Matrix4;

std::size_t valuesPerKey(const Track& track) {
  const std::size_t parts = track.interpolation == Interpolation::CubicSpline ? 3 : 1;
  return track.seconds.empty() ? 0 : track.values.size() / (track.seconds.size() * parts);
}

/// A place among the keys of a track: between `from` and `to`, at `t` in [0, 1).
struct KeyPlace {
  std::size_t from = 0;
  std::size_t to = 0;
  double t = 0;
  double keySeconds = 0;  ///< from one key to the other
};

KeyPlace placeAmong(const std::vector<float>& keys, double seconds) {
  const auto next = std::upper_bound(keys.begin(), keys.end(), seconds);
  if (next == keys.begin()) return {};
  const auto before = static_cast<std::size_t>(next - keys.begin()) - 1;
  if (next == keys.end()) return {before, before, 0, 0};
  const double length = double{*next} - double{keys[before]};
  return {before, before + 1, (seconds - double{keys[before]}) / length, length};
}

/// One track at one time, component by component (glTF 2.0, appendix C).
class Sample {
 public:
  Sample(const Track& track, double seconds)
      : track_(track),
        width_(valuesPerKey(track)),
        place_(placeAmong(track.seconds, seconds)),
        cubic_(track.interpolation == Interpolation::CubicSpline) {
    if (track.interpolation == Interpolation::Step) place_.to = place_.from;
  }

  std::size_t width() const { return width_; }

  double interpolated(std::size_t component) const {
    const double v0 = value(place_.from, component);
    if (place_.from == place_.to) return v0;
    const double v1 = value(place_.to, component);
    const double t = place_.t;
    if (!cubic_) return (1 - t) * v0 + t * v1;
    const double out = part(place_.from, 2, component);
    const double in = part(place_.to, 0, component);
    const double t2 = t * t;
    const double t3 = t2 * t;
    return (2 * t3 - 3 * t2 + 1) * v0 + place_.keySeconds * (t3 - 2 * t2 + t) * out +
           (3 * t2 - 2 * t3) * v1 + place_.keySeconds * (t3 - t2) * in;
  }

  scene::Double3 vector() const { return {interpolated(0), interpolated(1), interpolated(2)}; }

  /// Of any length above 0: matrixFromParts() normalises.
  std::array<double, 4> rotation() const {
    std::array<double, 4> q{};
    if (cubic_ || place_.from == place_.to) {
      for (std::size_t c = 0; c < 4; ++c) q[c] = interpolated(c);
      return q;
    }
    const std::array<double, 4> a = unitValue(place_.from);
    const std::array<double, 4> b = unitValue(place_.to);
    const double d = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
    const double angle = std::acos(std::min(std::abs(d), 1.0));
    // Between quaternions this close the chord and the arc are the same.
    const bool close = angle < 1e-6;
    const double fromA = close ? 1 - place_.t : std::sin((1 - place_.t) * angle);
    const double fromB = (close ? place_.t : std::sin(place_.t * angle)) * (d < 0 ? -1 : 1);
    for (std::size_t c = 0; c < 4; ++c) q[c] = fromA * a[c] + fromB * b[c];
    return q;
  }

 private:
  double part(std::size_t key, std::size_t which, std::size_t component) const {
    return double{track_.values[(3 * key + which) * width_ + component]};
  }
  double value(std::size_t key, std::size_t component) const {
    return cubic_ ? part(key, 1, component) : double{track_.values[key * width_ + component]};
  }
  std::array<double, 4> unitValue(std::size_t key) const {
    std::array<double, 4> q{};
    double norm = 0;
    for (std::size_t c = 0; c < 4; ++c) {
      q[c] = value(key, c);
      norm += q[c] * q[c];
    }
    if (!(norm > 0)) return {0, 0, 0, 1};
    for (double& component : q) component /= std::sqrt(norm);
    return q;
  }

  const Track& track_;
  std::size_t width_;
  KeyPlace place_;
  bool cubic_;
};

void apply(const Track& track, double seconds, Pose& pose) {
  const Sample sample(track, seconds);
  LocalTransform& local = pose.local[track.node];
  switch (track.target) {
    case TrackTarget::Translation:
      if (sample.width() == 3) local.translation = sample.vector();
      return;
    case TrackTarget::Rotation:
      if (sample.width() == 4) local.rotation = sample.rotation();
      return;
    case TrackTarget::Scale:
      if (sample.width() == 3) local.scale = sample.vector();
      return;
    case TrackTarget::MorphWeights: {
      const std::uint32_t first = pose.firstWeight[track.node];
      const std::size_t room = pose.firstWeight[track.node + 1] - first;
      for (std::size_t w = 0; w < std::min(room, sample.width()); ++w) {
        pose.weights[first + w] = static_cast<float>(sample.interpolated(w));
      }
      return;
    }
  }
}

/// Everything as the file has it.
void rest(const Scene& scene, Pose& pose) {
  for (std::size_t n = 0; n < scene.nodes.size(); ++n) {
    const Node& node = scene.nodes[n];
    const auto& q = node.rotation;
    pose.local[n] = {scene::toDouble(node.translation),
                     {double{q[0]}, double{q[1]}, double{q[2]}, double{q[3]}},
                     scene::toDouble(node.scale)};
    const std::uint32_t first = pose.firstWeight[n];
    const std::size_t room = pose.firstWeight[n + 1] - first;
    for (std::size_t w = 0; w < room; ++w) {
      pose.weights[first + w] = w < node.morphWeights.size() ? node.morphWeights[w] : 0.0F;
    }
  }
}

std::vector<std::size_t> weightsPerNode(const Scene& scene) {
  std::vector<std::size_t> counts;
  for (const Node& node : scene.nodes) counts.push_back(node.morphWeights.size());
  for (const Object& object : scene.objects) {
    if (!object.rig) continue;
    std::size_t& count = counts[object.rig->node];
    count = std::max(count, object.rig->targets.size());
  }
  return counts;
}

}  // namespace

Pose makePose(const Scene& scene) {
  Pose pose;
  pose.world.resize(scene.nodes.size());
  pose.local.resize(scene.nodes.size());
  pose.firstWeight.push_back(0);
  for (const std::size_t count : weightsPerNode(scene)) {
    pose.firstWeight.push_back(pose.firstWeight.back() + static_cast<std::uint32_t>(count));
  }
  pose.weights.resize(pose.firstWeight.back());
  poseAt(scene, -1, 0, pose);
  return pose;
}

double clipTime(const Clip& clip, double seconds) {
  if (!std::isfinite(seconds)) return 0;
  const double end{clip.seconds};
  return seconds <= end || !(end > 0) ? seconds : std::fmod(seconds, end);
}

void poseAt(const Scene& scene, int clip, double seconds, Pose& pose) {
  rest(scene, pose);
  if (clip >= 0 && static_cast<std::size_t>(clip) < scene.clips.size()) {
    const Clip& of = scene.clips[static_cast<std::size_t>(clip)];
    const double time = clipTime(of, seconds);
    for (const Track& track : of.tracks) apply(track, time, pose);
  }
  for (std::size_t n = 0; n < scene.nodes.size(); ++n) {
    const Node& node = scene.nodes[n];
    const LocalTransform& local = pose.local[n];
    const Matrix4 own =
        node.matrix ? scene::matrixFrom(*node.matrix)
                    : scene::matrixFromParts(local.translation, local.rotation, local.scale);
    pose.world[n] = node.parent < 0 ? own : pose.world[static_cast<std::size_t>(node.parent)] * own;
  }
}

void jointMatrices(const Rig& rig, const Pose& pose, std::span<Matrix4> matrices) {
  const Matrix4 toScene = scene::matrixFrom(rig.toScene);
  if (rig.joints.empty()) {
    matrices[0] = toScene * pose.world[rig.node];
    return;
  }
  for (std::size_t j = 0; j < rig.joints.size(); ++j) {
    const Joint& joint = rig.joints[j];
    matrices[j] = toScene * (pose.world[joint.node] * scene::matrixFrom(joint.inverseBind));
  }
}

bool mirrors(std::span<const Matrix4> matrices) {
  const auto mirroring = std::count_if(matrices.begin(), matrices.end(), [](const Matrix4& matrix) {
    return matrix.determinant() < 0;
  });
  return 2 * static_cast<std::size_t>(mirroring) > matrices.size();
}

std::span<const float> morphWeights(const Rig& rig, const Pose& pose) {
  return std::span(pose.weights).subspan(pose.firstWeight[rig.node], rig.targets.size());
}

}  // namespace opaline::deform
