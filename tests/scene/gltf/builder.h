#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

#include "scene/gltf/glb.h"

namespace opaline::test {

/// A binary glTF with animations, assembled accessor by accessor.
class GltfBuilder {
 public:
  template <typename T>
  int add(const std::vector<T>& values, const char* type, int components,
          const std::string& flags = "") {
    views_.push_back(fmt::format(R"({{"buffer":0,"byteOffset":{},"byteLength":{}}})",
                                 binary_.size(), values.size() * sizeof(T)));
    accessors.push_back(fmt::format(
        R"({{"bufferView":{},"componentType":{},"count":{},"type":"{}"{}}})", views_.size() - 1,
        componentType<T>(), values.size() / static_cast<std::size_t>(components), type, flags));
    binary_ += raw(values);
    while (binary_.size() % 4 != 0) binary_ += '\0';
    return static_cast<int>(accessors.size()) - 1;
  }
  int scalars(const std::vector<float>& v) { return add(v, "SCALAR", 1); }
  int vectors(const std::vector<float>& v) { return add(v, "VEC3", 3); }
  int quaternions(const std::vector<float>& v) { return add(v, "VEC4", 4); }

  /// Adds an animation "name" with samplers of one channel each.
  void animate(const std::string& name, const std::vector<std::string>& samplers,
               const std::vector<std::string>& targets) {
    std::vector<std::string> channels;
    for (std::size_t i = 0; i < targets.size(); ++i) {
      channels.push_back(fmt::format(R"({{"sampler":{},"target":{{{}}}}})",
                                     i < samplers.size() ? i : 0, targets[i]));
    }
    animations_.push_back(fmt::format(R"({{"name":"{}","samplers":[{}],"channels":[{}]}})", name,
                                      fmt::join(samplers, ","), fmt::join(channels, ",")));
  }
  static std::string sampler(int input, int output, const char* interpolation = "LINEAR") {
    return fmt::format(R"({{"input":{},"output":{},"interpolation":"{}"}})", input, output,
                       interpolation);
  }

  std::string file() const {
    return glb(
        fmt::format(R"({{"asset":{{"version":"2.0"}},"nodes":[{}],"meshes":[{}],"accessors":[{}],)"
                    R"("bufferViews":[{}],"buffers":[{{"byteLength":{}}}],"animations":[{}]{}}})",
                    nodes, meshes, fmt::join(accessors, ","), fmt::join(views_, ","),
                    binary_.size(), fmt::join(animations_, ","), more),
        binary_);
  }

  std::vector<std::string> accessors{};
  std::string nodes = R"({"mesh":0,"name":"tetra"})";
  std::string meshes{};
  std::string more{};

 private:
  template <typename T>
  static int componentType() {
    if constexpr (std::is_same_v<T, std::int8_t>) return 5120;
    if constexpr (std::is_same_v<T, std::uint8_t>) return 5121;
    if constexpr (std::is_same_v<T, std::int16_t>) return 5122;
    if constexpr (std::is_same_v<T, std::uint16_t>) return 5123;
    return 5126;
  }

  std::string binary_;
  std::vector<std::string> views_;
  std::vector<std::string> animations_;
};

}  // namespace opaline::test
