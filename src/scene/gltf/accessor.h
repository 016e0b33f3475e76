#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "scene/gltf/file.h"

namespace opaline::scene {

/// Reads accessors of one model. Everything is checked against the bytes that are there before it
/// is allocated. The sum of what is read is limited, since a file may name one accessor many times.
class GltfAccessors {
 public:
  GltfAccessors(const Input& input, const tinygltf::Model& model) : input_(input), model_(model) {}

  std::size_t countOf(int accessor) const;

  /// `components` numbers per element, normalised where the accessor says so. Throws Error unless
  /// the accessor has that many components and, if given, `count` elements.
  std::vector<float> floats(int accessor, int components,
                            std::optional<std::size_t> count = std::nullopt);
  /// The same for whole numbers that are at least 0.
  std::vector<std::uint32_t> integers(int accessor, int components,
                                      std::optional<std::size_t> count = std::nullopt);

  /// Counts numbers that a file causes without reading them. Throws Error beyond the limit.
  void spend(std::size_t numbers);

 private:
  template <typename T, typename Convert>
  std::vector<T> read(int accessor, int components, std::optional<std::size_t> count,
                      Convert&& convert);
  const tinygltf::Accessor& at(int accessor) const;
  /// `count` elements of `elementBytes` in a view from an offset, `strideBytes` apart (0 on entry:
  /// tightly packed).
  const unsigned char* bytes(int view, std::size_t offset, std::size_t count,
                             std::size_t elementBytes, std::size_t& strideBytes) const;

  const Input& input_;
  const tinygltf::Model& model_;
  std::size_t numbersRead_ = 0;
};

}  // namespace opaline::scene
