#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scene/gltf/accessor.h"
#include "scene/raw_scene.h"
#include "scene/vector_math.h"

namespace opaline::scene {

/// A primitive while it is baked.
struct Draft {
  std::vector<Double3> positions;
  std::vector<Double3> normals;  ///< empty where the file has none
  std::vector<std::uint64_t> tags;
  std::vector<Triangle> triangles;
  bool mirrored = false;
};

inline std::optional<int> attribute(const std::map<std::string, int>& attributes,
                                    const std::string& name) {
  const auto found = attributes.find(name);
  return found == attributes.end() ? std::nullopt : std::optional(found->second);
}

inline std::vector<Double3> vectors(GltfAccessors& accessors, int accessor,
                                    std::optional<std::size_t> count) {
  const std::vector<float> numbers = accessors.floats(accessor, 3, count);
  std::vector<Double3> result(numbers.size() / 3);
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = {double{numbers[3 * i]}, double{numbers[3 * i + 1]}, double{numbers[3 * i + 2]}};
  }
  return result;
}

/// The unit vector, or zero where `v` has no direction.
inline Vec3 unitOrZero(const Double3& v) {
  const double size = length(v);
  return size > 0 && isFinite(v) ? toFloat((1 / size) * v) : Vec3{0, 0, 0};
}

}  // namespace opaline::scene
