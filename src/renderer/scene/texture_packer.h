#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "opaline/material.h"
#include "shaders/shared/opaque.h"

namespace opaline {

/// Stores textures with all their levels one after the other, as half floats that are linear in
/// light.
class TexturePacker {
 public:
  /// `room` is the largest number of texels.
  explicit TexturePacker(std::size_t room) : room_(room) {}

  /// Has to be called for all textures first, so that it is known how much smaller they must be to
  /// fit.
  void announce(const std::optional<Texture>& texture, TexelMeaning meaning);
  /// How often the edges of too large textures are halved.
  int halvings() const;

  /// Adds a texture, which has to have been announced.
  shared::TextureData add(const std::optional<Texture>& texture, TexelMeaning meaning);

  bool knows(const TexturePixels& pixels, TexelMeaning meaning) {
    return find(pixels, meaning) != nullptr;
  }
  /// Frees the texels once they are on the device; their places stay known.
  void forgetTexels() { texels_ = {}; }

  /// Sets the transform of a texture that has been added.
  static void setTransform(const Texture& texture, shared::TextureData& data);

  struct Texel {
    std::uint32_t redGreen;
    std::uint32_t blueAlpha;
  };
  const std::vector<Texel>& texels() const { return texels_; }

 private:
  struct Known {
    const TexturePixels* pixels;
    TexelMeaning meaning;
    std::optional<shared::uvec4> place;  ///< as in TextureData, without its bits
  };
  Known* find(const TexturePixels& pixels, TexelMeaning meaning);
  shared::uvec4 pack(const TexturePixels& pixels, TexelMeaning meaning);

  std::size_t room_;
  std::vector<Known> known_;
  std::vector<Texel> texels_;
};

}  // namespace opaline
