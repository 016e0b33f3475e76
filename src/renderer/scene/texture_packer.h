#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "opaline/material.h"
#include "shaders/shared/opaque.h"

namespace opaline {

/// Puts textures with all their levels one behind the other, as half floats, linear in light.
class TexturePacker {
 public:
  /// So many texels there is room for.
  explicit TexturePacker(std::size_t room) : room_(room) {}

  /// First all that there are, so that the room is known to suffice, or by how much they must be
  /// smaller.
  void announce(const std::optional<Texture>& texture, TexelMeaning meaning);
  /// How often each edge is halved of those that are too large.
  int halvings() const;

  /// Only what has been announced.
  shared::TextureData add(const std::optional<Texture>& texture, TexelMeaning meaning);

  bool knows(const TexturePixels& pixels, TexelMeaning meaning) {
    return find(pixels, meaning) != nullptr;
  }
  /// Once they are on the device: what is known is where they lie.
  void forgetTexels() { texels_ = {}; }

  /// Of a texture that has been added.
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
