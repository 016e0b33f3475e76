#include "scene/gltf/animation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

#include "scene/formats.h"
#include "scene/text.h"

namespace opaline::scene {

namespace {

const tinygltf::Mesh* meshOf(const tinygltf::Model& model, const tinygltf::Node& node) {
  if (node.mesh < 0 || static_cast<std::size_t>(node.mesh) >= model.meshes.size()) return nullptr;
  return &model.meshes[static_cast<std::size_t>(node.mesh)];
}

/// How many morph targets each mesh has.
std::vector<std::size_t> countTargets(const tinygltf::Model& model) {
  std::vector<std::size_t> counts;
  for (const tinygltf::Mesh& mesh : model.meshes) {
    std::size_t most = 0;
    for (const tinygltf::Primitive& primitive : mesh.primitives) {
      most = std::max(most, primitive.targets.size());
    }
    counts.push_back(most);
  }
  return counts;
}

bool allFinite(const std::vector<float>& values) {
  return std::all_of(values.begin(), values.end(), [](float v) { return std::isfinite(v); });
}

/// resolveNodes() has checked the sizes of these arrays.
bool readTransform(const tinygltf::Node& from, Node& node) {
  if (!from.matrix.empty()) {
    node.matrix = affineFrom(matrixFromColumns(from.matrix));
    return isFinite(*node.matrix);
  }
  const auto copy = [](const std::vector<double>& values, auto& to) {
    for (std::size_t i = 0; i < values.size(); ++i) to[i] = static_cast<float>(values[i]);
  };
  copy(from.translation, node.translation);
  copy(from.scale, node.scale);
  std::vector<double> q = from.rotation;
  if (!q.empty()) {
    const double size = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
    if (!std::isfinite(size)) return false;
    for (double& component : q) component /= size;
    if (size > 0) copy(q, node.rotation);
  }
  return isFinite(node.translation) && isFinite(node.scale);
}

/// Reads the animations of one model.
class Reader {
 public:
  Reader(const Input& input, const tinygltf::Model& model, const GltfNodes& nodes,
         GltfAccessors& accessors, GltfMotion& motion)
      : input_(input),
        model_(model),
        nodes_(nodes),
        accessors_(accessors),
        motion_(motion),
        targets_(countTargets(model)) {}

  void read() {
    for (std::size_t i = 0; i < model_.nodes.size(); ++i) addNode(i);
    for (std::size_t a = 0; a < model_.animations.size(); ++a) {
      const tinygltf::Animation& animation = model_.animations[a];
      Clip clip;
      clip.name = animation.name.empty() ? fmt::format("clip {}", a) : cleanText(animation.name);
      std::vector<GltfPointerTrack> pointers;
      for (const tinygltf::AnimationChannel& channel : animation.channels) {
        if (channel.target_path == "pointer")
          readPointerChannel(animation, clip, channel, pointers);
        else
          readChannel(animation, clip, channel);
      }
      if (clip.tracks.empty() && pointers.empty()) continue;
      clip.name = nameOfItsOwn(clip.name);
      motion_.clips.push_back(std::move(clip));
      motion_.pointers.push_back(std::move(pointers));
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

  /// Makes a clip's name unique: clips are asked for by name. "none" is taken, as it means no clip.
  std::string nameOfItsOwn(const std::string& wanted) {
    std::string name = wanted;
    while (name == "none" || !names_.insert(name).second) {
      name = fmt::format("{} ({})", wanted, ++numberOf_.try_emplace(wanted, 1).first->second);
    }
    return name;
  }

  /// Appends a node; all nodes come in order, parents first.
  void addNode(std::size_t at) {
    const auto index = static_cast<std::size_t>(nodes_.order[at]);
    motion_.place[index] = static_cast<std::uint32_t>(at);
    const tinygltf::Node& from = model_.nodes[index];
    Node node;
    node.name = cleanText(from.name);
    const int parent = nodes_.parents[index];
    if (parent >= 0)
      node.parent = static_cast<int>(motion_.place[static_cast<std::size_t>(parent)]);
    const bool finite = readTransform(from, node);
    const std::vector<double>& weights = defaultWeights(model_, from);
    const std::size_t count = std::min(targetsOf(from), weights.size());
    accessors_.spend(count);
    for (std::size_t w = 0; w < count; ++w) {
      node.morphWeights.push_back(static_cast<float>(weights[w]));
    }
    if (!finite || !allFinite(node.morphWeights)) {
      failGltf(input_,
               fmt::format("the transform or the weights of node {} are out of range", index));
    }
    motion_.nodes.push_back(std::move(node));
  }

  std::size_t targetsOf(const tinygltf::Node& node) const {
    return meshOf(model_, node) == nullptr ? 0 : targets_[static_cast<std::size_t>(node.mesh)];
  }

  void readChannel(const tinygltf::Animation& animation, Clip& clip,
                   const tinygltf::AnimationChannel& channel) {
    if (channel.target_node == -1) return;  // only an extension says what it moves
    if (channel.target_node < 0 ||
        static_cast<std::size_t>(channel.target_node) >= model_.nodes.size()) {
      fail(clip, fmt::format("moves node {}, which does not exist", channel.target_node));
    }
    const auto index = static_cast<std::size_t>(channel.target_node);
    const tinygltf::Node& node = model_.nodes[index];
    const auto target = targetOf(channel.target_path);
    const bool weights = target == TrackTarget::MorphWeights;
    const std::size_t width = weights ? targetsOf(node) : target == TrackTarget::Rotation ? 4 : 3;
    // A node with a matrix is never animated (glTF 2.0, section 3.5.3).
    if (!target || width == 0 || (!weights && !node.matrix.empty())) {
      ++skipped_;
      return;
    }
    Track track = readTrack(clip, samplerOf(animation, clip, channel), *target, width);
    track.node = motion_.place[index];
    clip.seconds = std::max(clip.seconds, track.seconds.back());
    clip.tracks.push_back(std::move(track));
    (weights ? motion_.weighted : motion_.moved)[index] = true;
  }

  const tinygltf::AnimationSampler& samplerOf(const tinygltf::Animation& animation,
                                              const Clip& clip,
                                              const tinygltf::AnimationChannel& channel) const {
    if (channel.sampler < 0 ||
        static_cast<std::size_t>(channel.sampler) >= animation.samplers.size()) {
      fail(clip, "names a sampler that does not exist");
    }
    return animation.samplers[static_cast<std::size_t>(channel.sampler)];
  }

  void readPointerChannel(const tinygltf::Animation& animation, Clip& clip,
                          const tinygltf::AnimationChannel& channel,
                          std::vector<GltfPointerTrack>& to) {
    const std::string pointer = pointerOf(channel);
    if (pointer.empty()) {
      ++skipped_;
      return;
    }
    const std::optional<GltfPointer> found = readPointer(model_, pointer);
    if (!found) {
      motion_.notAnimated.push_back(pointer);
      return;
    }
    // Weights aside, readTrack() accepts any target and takes the width it is told.
    Track track = readTrack(clip, samplerOf(animation, clip, channel), TrackTarget::Translation,
                            found->width);
    clip.seconds = std::max(clip.seconds, track.seconds.back());
    to.push_back({*found, std::move(track)});
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
  const GltfNodes& nodes_;
  GltfAccessors& accessors_;
  GltfMotion& motion_;
  std::vector<std::size_t> targets_;               ///< per mesh
  std::unordered_set<std::string> names_;          ///< of the clips so far
  std::unordered_map<std::string, int> numberOf_;  ///< how often a name was wanted
  std::size_t skipped_ = 0;
};

}  // namespace

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
  Reader(input, model, nodes, accessors, motion).read();
  if (!motion.any()) return {.notAnimated = std::move(motion.notAnimated)};
  for (const int n : nodes.order) {
    const auto index = static_cast<std::size_t>(n);
    const int parent = nodes.parents[index];
    if (parent >= 0 && motion.moved[static_cast<std::size_t>(parent)]) motion.moved[index] = true;
  }
  return motion;
}

}  // namespace opaline::scene
