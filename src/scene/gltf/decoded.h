#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "scene/gltf/file.h"

namespace opaline::scene {

/// Holds the decoded parts of a file: each goes into a buffer of its own, appended to the model.
/// The sum of all sizes is limited, since a file may name one part many times.
class GltfDecoded {
 public:
  GltfDecoded(const Input& input, tinygltf::Model& model) : input_(input), model_(model) {}

  /// Throws Error where `whose` would exceed the limit. Call it before anything is allocated.
  void reserve(std::size_t bytes, std::string_view whose);

  /// The number of the new buffer.
  int addBuffer(std::vector<unsigned char>&& data);

  /// Part of a buffer of the file. Throws Error where `whose` names bytes that do not exist.
  std::span<const unsigned char> compressed(int buffer, std::size_t offset, std::size_t length,
                                            std::string_view whose) const;

  const Input& input() const { return input_; }
  tinygltf::Model& model() { return model_; }

 private:
  const Input& input_;
  tinygltf::Model& model_;
  std::size_t reserved_ = 0;
};

}  // namespace opaline::scene
