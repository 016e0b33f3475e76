#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "opaline/material.h"
#include "scene/gltf/file.h"

namespace opaline::scene {

/// The textures of one file. A picture is read when the first material asks for it.
class GltfTextures {
 public:
  GltfTextures(const Input& input, const tinygltf::Model& model) : input_(input), model_(model) {}

  /// What a material names, by a `textureInfo`, which texture of the file, which coordinates, and
  /// what KHR_texture_transform says; none where it names none, and where its picture cannot be
  /// read, which is noted once. Throws Error for an index out of range.
  std::optional<Texture> texture(int index, int coordinates, const tinygltf::ExtensionMap& with);
  /// The same of an extension, whose textures are JSON yet.
  std::optional<Texture> texture(const tinygltf::Value& info);

 private:
  std::shared_ptr<const TexturePixels> pixelsOf(const tinygltf::Texture& texture);
  std::shared_ptr<const TexturePixels> pixelsOf(int image);
  void noteLeftOut(const std::string& reason);
  TexturePixels read(std::size_t image) const;

  const Input& input_;
  const tinygltf::Model& model_;
  std::map<int, std::shared_ptr<const TexturePixels>> pixels_;  ///< null: cannot be read
  std::set<std::string> leftOut_;                               ///< why, said once each
  std::size_t pixelsRead_ = 0;
};

}  // namespace opaline::scene
