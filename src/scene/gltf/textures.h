#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "opaline/material.h"
#include "opaline/scene.h"
#include "scene/gltf/file.h"

namespace opaline::scene {

/// The textures of one file. A picture is read when the first material asks for it.
class GltfTextures {
 public:
  GltfTextures(const Input& input, const tinygltf::Model& model) : input_(input), model_(model) {}

  /// The texture that a material's `textureInfo` names: its index in the file, its coordinates, and
  /// what KHR_texture_transform says. None where no texture is named, or where its picture cannot
  /// be read, which is noted once. Throws Error for an index out of range.
  std::optional<Texture> texture(int index, int coordinates, const tinygltf::ExtensionMap& with);
  /// The same for an extension, whose texture is still JSON.
  std::optional<Texture> texture(const tinygltf::Value& info);

  /// Those whose picture cannot be read, of all that have been asked for.
  const std::vector<NotShown>& unreadable() const { return unreadable_; }

 private:
  std::shared_ptr<const TexturePixels> pixelsOf(const tinygltf::Texture& texture);
  std::shared_ptr<const TexturePixels> pixelsOf(int image);
  void leaveOut(std::string_view name, const std::string& reason);
  std::string nameOf(std::size_t image) const;
  TexturePixels read(std::size_t image) const;

  const Input& input_;
  const tinygltf::Model& model_;
  std::map<int, std::shared_ptr<const TexturePixels>> pixels_;  ///< null: cannot be read
  std::set<std::string> leftOut_;                               ///< why, said once each
  std::vector<NotShown> unreadable_;
  std::size_t pixelsRead_ = 0;
};

}  // namespace opaline::scene
