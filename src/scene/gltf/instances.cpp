#include "scene/gltf/instances.h"

#include <fmt/format.h>

#include <cstddef>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scene/gltf/accessor.h"
#include "scene/text.h"

namespace opaline::scene {

namespace {

constexpr const char* instancing = "EXT_mesh_gpu_instancing";
constexpr std::size_t mostInstances = 1'000'000;

/// Numbers of an instance attribute; none where the instances lack it.
struct Attribute {
  std::vector<float> numbers;
  std::size_t size = 0;

  std::vector<double> of(std::size_t instance) const {
    if (numbers.empty()) return {};
    const auto first = numbers.begin() + static_cast<std::ptrdiff_t>(size * instance);
    return {first, first + static_cast<std::ptrdiff_t>(size)};
  }
};

class Instances {
 public:
  Instances(const Input& input, const tinygltf::Model& model, GltfAccessors& accessors,
            std::size_t node)
      : input_(input), accessors_(accessors), node_(node) {
    const auto& extensions = model.nodes[node].extensions;
    const auto found = extensions.find(instancing);
    if (found == extensions.end() || !found->second.Has("attributes")) return;
    const tinygltf::Value& attributes = found->second.Get("attributes");
    translation_ = read(attributes, "TRANSLATION", 3);
    rotation_ = read(attributes, "ROTATION", 4);
    scale_ = read(attributes, "SCALE", 3);
  }

  std::size_t count() const { return count_.value_or(0); }

  tinygltf::Node at(std::size_t instance, const tinygltf::Node& of) const {
    tinygltf::Node node;
    node.name = fmt::format("{} {}", of.name.empty() ? fmt::format("node {}", node_) : of.name,
                            instance + 1);
    node.mesh = of.mesh;
    node.translation = translation_.of(instance);
    node.rotation = rotation_.of(instance);
    node.scale = scale_.of(instance);
    return node;
  }

 private:
  Attribute read(const tinygltf::Value& attributes, const std::string& name, int size) {
    if (!attributes.Has(name)) return {};
    const tinygltf::Value& value = attributes.Get(name);
    const int accessor = value.IsInt() ? value.GetNumberAsInt() : -1;
    const std::size_t count = accessors_.countOf(accessor);
    if (count > mostInstances || count != count_.value_or(count))
      failGltf(
          input_,
          fmt::format("the instances of node {} have {} of {}, but {}", node_, count, name,
                      count > mostInstances ? fmt::format("at most {} are possible", mostInstances)
                                            : fmt::format("{} of another attribute", *count_)));
    count_ = count;
    return {accessors_.floats(accessor, size, count), static_cast<std::size_t>(size)};
  }

  const Input& input_;
  GltfAccessors& accessors_;
  std::size_t node_;
  std::optional<std::size_t> count_;
  Attribute translation_;
  Attribute rotation_;
  Attribute scale_;
};

}  // namespace

void expandInstances(const Input& input, tinygltf::Model& model) {
  GltfAccessors accessors(input, model);
  std::vector<tinygltf::Node> made;
  const std::size_t nodes = model.nodes.size();
  for (std::size_t n = 0; n < nodes; ++n) {
    if (model.nodes[n].mesh < 0) continue;
    const Instances instances(input, model, accessors, n);
    if (instances.count() == 0) continue;
    if (made.size() + instances.count() > mostInstances)
      failGltf(input, fmt::format("it has more than {} instances", mostInstances));
    tinygltf::Node& node = model.nodes[n];
    for (std::size_t i = 0; i < instances.count(); ++i) {
      node.children.push_back(static_cast<int>(nodes + made.size()));
      made.push_back(instances.at(i, node));
    }
    node.mesh = -1;
  }
  model.nodes.insert(model.nodes.end(), std::make_move_iterator(made.begin()),
                     std::make_move_iterator(made.end()));
}

}  // namespace opaline::scene
