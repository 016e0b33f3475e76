#include "scene/gltf_animation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/formats.h"
#include "scene/text.h"

namespace opaline::scene {

namespace {

const tinygltf::Mesh* meshOf(const tinygltf::Model& model, const tinygltf::Node& node) {
  if (node.mesh < 0 || static_cast<std::size_t>(node.mesh) >= model.meshes.size()) return nullptr;
  return &model.meshes[static_cast<std::size_t>(node.mesh)];
}

bool allFinite(const std::vector<float>& values) {
  return std::all_of(values.begin(), values.end(), [](float v) { return std::isfinite(v); });
}

Node nodeOf(const Input& input, const tinygltf::Model& model, const GltfNodes& nodes,
            const std::vector<std::uint32_t>& place, std::size_t index) {
  const tinygltf::Node& from = model.nodes[index];
  Node node;
  node.name = cleanText(from.name);
  const int parent = nodes.parents[index];
  if (parent >= 0) node.parent = static_cast<int>(place[static_cast<std::size_t>(parent)]);
  // Their sizes have been checked where the hierarchy was resolved.
  const auto copy = [](const std::vector<double>& values, auto& to) {
    for (std::size_t i = 0; i < values.size(); ++i) to[i] = static_cast<float>(values[i]);
  };
  bool finite = true;
  if (!from.matrix.empty()) {
    node.matrix = affineFrom(matrixFromColumns(from.matrix));
    finite = isFinite(*node.matrix);
  } else {
    copy(from.translation, node.translation);
    copy(from.scale, node.scale);
    if (!from.rotation.empty()) {
      const std::vector<double>& q = from.rotation;
      const double size = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
      for (std::size_t c = 0; c < 4 && size > 0; ++c) {
        node.rotation[c] = static_cast<float>(q[c] / size);
        finite = finite && std::isfinite(node.rotation[c]);
      }
    }
    finite = finite && isFinite(node.translation) && isFinite(node.scale);
  }
  const std::vector<double>& weights = defaultWeights(model, from);
  node.morphWeights.resize(std::min(morphTargetsOf(model, from), weights.size()));
  for (std::size_t w = 0; w < node.morphWeights.size(); ++w) {
    node.morphWeights[w] = static_cast<float>(weights[w]);
  }
  if (!finite || !allFinite(node.morphWeights)) {
    failGltf(input, fmt::format("the transform or the weights of node {} are out of range", index));
  }
  return node;
}

/// Reads the animations of one model.
class Reader {
 public:
  Reader(const Input& input, const tinygltf::Model& model, GltfAccessors& accessors,
         GltfMotion& motion)
      : input_(input), model_(model), accessors_(accessors), motion_(motion) {}

  void read() {
    for (std::size_t a = 0; a < model_.animations.size(); ++a) {
      const tinygltf::Animation& animation = model_.animations[a];
      Clip clip;
      clip.name = animation.name.empty() ? fmt::format("clip {}", a) : cleanText(animation.name);
      for (const tinygltf::AnimationChannel& channel : animation.channels) {
        readChannel(animation, clip, channel);
      }
      if (!clip.tracks.empty()) motion_.clips.push_back(std::move(clip));
    }
    if (skipped_ > 0) {
      note(input_.log, fmt::format("{}: {} animation channels move nothing that can be rendered",
                                   cleanText(input_.file.string(), 1000), skipped_));
    }
  }

 private:
  [[noreturn]] void fail(const Clip& clip, const std::string& reason) const {
    failGltf(input_, fmt::format("animation '{}' {}", cleanText(clip.name, 60), reason));
  }

  void readChannel(const tinygltf::Animation& animation, Clip& clip,
                   const tinygltf::AnimationChannel& channel) {
    if (channel.target_node == -1) return;  // for extensions
    if (channel.target_node < 0 ||
        static_cast<std::size_t>(channel.target_node) >= model_.nodes.size()) {
      fail(clip, fmt::format("moves node {}, which does not exist", channel.target_node));
    }
    const auto index = static_cast<std::size_t>(channel.target_node);
    const tinygltf::Node& node = model_.nodes[index];
    const auto target = targetOf(channel.target_path);
    const bool weights = target == TrackTarget::MorphWeights;
    const std::size_t width = weights                           ? morphTargetsOf(model_, node)
                              : target == TrackTarget::Rotation ? 4
                                                                : 3;
    // A node with a matrix is never animated (glTF 2.0, section 3.5.3).
    if (!target || width == 0 || (!weights && !node.matrix.empty())) {
      ++skipped_;
      return;
    }
    if (channel.sampler < 0 ||
        static_cast<std::size_t>(channel.sampler) >= animation.samplers.size()) {
      fail(clip, "names a sampler that does not exist");
    }
    Track track = readTrack(clip, animation.samplers[static_cast<std::size_t>(channel.sampler)],
                            *target, width);
    track.node = motion_.place[index];
    clip.seconds = std::max(clip.seconds, track.seconds.back());
    clip.tracks.push_back(std::move(track));
    (weights ? motion_.weighted : motion_.moved)[index] = true;
  }

  static std::optional<TrackTarget> targetOf(const std::string& path) {
    if (path == "translation") return TrackTarget::Translation;
    if (path == "rotation") return TrackTarget::Rotation;
    if (path == "scale") return TrackTarget::Scale;
    if (path == "weights") return TrackTarget::MorphWeights;
    return std::nullopt;
  }

  Track readTrack(const Clip& clip, const tinygltf::AnimationSampler& sampler, TrackTarget target,
                  std::size_t width) {
    Track track;
    track.target = target;
    if (sampler.interpolation == "STEP") {
      track.interpolation = Interpolation::Step;
    } else if (sampler.interpolation == "CUBICSPLINE") {
      track.interpolation = Interpolation::CubicSpline;
    } else if (sampler.interpolation != "LINEAR") {
      fail(clip, fmt::format("is interpolated by '{}', which is none of STEP, LINEAR and "
                             "CUBICSPLINE",
                             cleanText(sampler.interpolation, 40)));
    }
    track.seconds = accessors_.floats(sampler.input, 1);
    if (track.seconds.empty()) fail(clip, "has a sampler without keys");
    if (!(track.seconds.front() >= 0) || !allFinite(track.seconds)) {
      fail(clip, "has a key whose time is negative or not finite");
    }
    const auto notAscending = [](float a, float b) { return !(a < b); };
    if (std::adjacent_find(track.seconds.begin(), track.seconds.end(), notAscending) !=
        track.seconds.end()) {
      fail(clip, "has keys whose times do not ascend");
    }
    const std::size_t parts = track.interpolation == Interpolation::CubicSpline ? 3 : 1;
    const bool weights = target == TrackTarget::MorphWeights;
    const std::size_t elements = track.seconds.size() * parts * (weights ? width : 1);
    track.values =
        accessors_.floats(sampler.output, weights ? 1 : static_cast<int>(width), elements);
    if (!allFinite(track.values)) fail(clip, "has a key whose value is not finite");
    return track;
  }

  const Input& input_;
  const tinygltf::Model& model_;
  GltfAccessors& accessors_;
  GltfMotion& motion_;
  std::size_t skipped_ = 0;
};

}  // namespace

std::size_t morphTargetsOf(const tinygltf::Model& model, const tinygltf::Node& node) {
  const tinygltf::Mesh* mesh = meshOf(model, node);
  std::size_t targets = 0;
  if (mesh == nullptr) return targets;
  for (const tinygltf::Primitive& primitive : mesh->primitives) {
    targets = std::max(targets, primitive.targets.size());
  }
  return targets;
}

const std::vector<double>& defaultWeights(const tinygltf::Model& model,
                                          const tinygltf::Node& node) {
  const tinygltf::Mesh* mesh = meshOf(model, node);
  return node.weights.empty() && mesh != nullptr ? mesh->weights : node.weights;
}

GltfMotion readMotion(const Input& input, const tinygltf::Model& model, const GltfNodes& nodes,
                      GltfAccessors& accessors) {
  GltfMotion motion;
  if (model.animations.empty()) return motion;
  const std::size_t count = model.nodes.size();
  motion.place.resize(count);
  motion.moved.resize(count);
  motion.weighted.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    motion.place[static_cast<std::size_t>(nodes.order[i])] = static_cast<std::uint32_t>(i);
  }
  Reader(input, model, accessors, motion).read();
  if (!motion.any()) return {};
  for (const int n : nodes.order) {
    const auto index = static_cast<std::size_t>(n);
    motion.nodes.push_back(nodeOf(input, model, nodes, motion.place, index));
    const int parent = nodes.parents[index];
    if (parent >= 0 && motion.moved[static_cast<std::size_t>(parent)]) motion.moved[index] = true;
  }
  return motion;
}

}  // namespace opaline::scene
