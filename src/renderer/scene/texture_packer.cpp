#include "renderer/scene/texture_packer.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/packing.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "opaline/tone.h"

namespace opaline {

namespace {

/// One level, linear.
struct Level {
  int width = 0;
  int height = 0;
  std::vector<glm::vec4> texels;

  const glm::vec4& at(int x, int y) const {
    return texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

constexpr int edgeAt(int edge, int halvings) {
  return std::max(edge >> halvings, 1);
}

std::size_t texelsOf(const TexturePixels& pixels, int halvings) {
  int width = edgeAt(pixels.width, halvings);
  int height = edgeAt(pixels.height, halvings);
  std::size_t sum = 0;
  while (true) {
    sum += static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    if (width == 1 && height == 1) return sum;
    width = edgeAt(width, 1);
    height = edgeAt(height, 1);
  }
}

const std::vector<float>& linearOfEncoded() {
  static const std::vector<float> table = [] {
    std::vector<float> values(65536);
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = decodeSrgb(static_cast<float>(i) / 65535.0F);
    return values;
  }();
  return table;
}

glm::vec4 linearTexel(const std::uint16_t* rgba, TexelMeaning meaning) {
  const auto plain = [&](int c) { return static_cast<float>(rgba[c]) / 65535.0F; };
  if (meaning == TexelMeaning::Color) {
    const std::vector<float>& linear = linearOfEncoded();
    return {linear[rgba[0]], linear[rgba[1]], linear[rgba[2]], plain(3)};
  }
  if (meaning == TexelMeaning::Number) return {plain(0), plain(1), plain(2), plain(3)};
  const glm::vec3 told = 2.0F * glm::vec3(plain(0), plain(1), plain(2)) - 1.0F;
  const float size = glm::length(told);
  return size > 1e-3F ? glm::vec4(told / size, 1) : glm::vec4(0, 0, 1, 1);
}

Level levelOf(const TexturePixels& pixels, TexelMeaning meaning) {
  Level level{pixels.width, pixels.height, {}};
  level.texels.reserve(pixels.rgba.size() / 4);
  for (std::size_t i = 0; i < pixels.rgba.size(); i += 4)
    level.texels.push_back(linearTexel(&pixels.rgba[i], meaning));
  return level;
}

/// The texels that one texel of the next level averages along an edge, and their shares. If the
/// number of texels is odd, each new one covers parts of three.
struct Part {
  int first;
  std::array<float, 3> shares;
};

Part partOf(int at, int from, int to) {
  if (from == to) return {at, {1, 0, 0}};
  const float width = static_cast<float>(from) / static_cast<float>(to);
  const float begin = static_cast<float>(at) * width;
  const float end = begin + width;
  const int first = static_cast<int>(begin);
  Part part{first, {}};
  for (int i = 0; i < 3; ++i) {
    const float low = std::max(begin, static_cast<float>(first + i));
    const float high = std::min(end, static_cast<float>(first + i + 1));
    part.shares[static_cast<std::size_t>(i)] = std::max(high - low, 0.0F) / width;
  }
  return part;
}

Level halved(const Level& from) {
  Level to{edgeAt(from.width, 1), edgeAt(from.height, 1), {}};
  for (int y = 0; y < to.height; ++y) {
    const Part rows = partOf(y, from.height, to.height);
    for (int x = 0; x < to.width; ++x) {
      const Part columns = partOf(x, from.width, to.width);
      glm::vec4 sum(0);
      for (std::size_t j = 0; j < 3; ++j) {
        if (rows.shares[j] == 0) continue;
        for (std::size_t i = 0; i < 3; ++i) {
          if (columns.shares[i] == 0) continue;
          sum += rows.shares[j] * columns.shares[i] *
                 from.at(columns.first + static_cast<int>(i), rows.first + static_cast<int>(j));
        }
      }
      to.texels.push_back(sum);
    }
  }
  return to;
}

std::uint32_t bitsOf(const Texture& texture) {
  const auto wrap = [](TextureWrap mode) { return static_cast<std::uint32_t>(mode); };
  return wrap(texture.wrapU) | wrap(texture.wrapV) << shared::wrapVShift |
         (texture.interpolated ? 0U : shared::textureHasEdges) |
         (texture.coordinates == 1 ? shared::textureIsOnSecondSet : 0U);
}

}  // namespace

TexturePacker::Known* TexturePacker::find(const TexturePixels& pixels, TexelMeaning meaning) {
  const auto found = std::find_if(known_.begin(), known_.end(), [&](const Known& known) {
    return known.pixels == &pixels && known.meaning == meaning;
  });
  return found == known_.end() ? nullptr : &*found;
}

void TexturePacker::announce(const std::optional<Texture>& texture, TexelMeaning meaning) {
  if (texture && !find(*texture->pixels, meaning))
    known_.push_back({texture->pixels.get(), meaning, {}});
}

int TexturePacker::halvings() const {
  constexpr int most = 14;
  for (int halvings = 0; halvings < most; ++halvings) {
    std::size_t sum = 0;
    for (const Known& known : known_) sum += texelsOf(*known.pixels, halvings);
    if (sum <= room_) return halvings;
  }
  return most;
}

shared::TextureData TexturePacker::add(const std::optional<Texture>& texture,
                                       TexelMeaning meaning) {
  if (!texture) return {};
  Known* known = find(*texture->pixels, meaning);
  assert(known);
  if (!known->place) known->place = pack(*texture->pixels, meaning);
  shared::TextureData data{.place = *known->place};
  data.place.w = bitsOf(*texture);
  setTransform(*texture, data);
  return data;
}

void TexturePacker::setTransform(const Texture& texture, shared::TextureData& data) {
  const auto& [u, v] = texture.transform;
  data.rowU = {u[0], u[1], u[2], 0};
  data.rowV = {v[0], v[1], v[2], 0};
}

shared::uvec4 TexturePacker::pack(const TexturePixels& pixels, TexelMeaning meaning) {
  Level level = levelOf(pixels, meaning);
  for (int i = halvings(); i > 0; --i) level = halved(level);
  const auto first = static_cast<std::uint32_t>(texels_.size());
  const auto size =
      static_cast<std::uint32_t>(level.width) | static_cast<std::uint32_t>(level.height) << 16U;
  for (std::uint32_t levels = 1;; ++levels) {
    for (const glm::vec4& texel : level.texels)
      texels_.push_back(
          {glm::packHalf2x16({texel.r, texel.g}), glm::packHalf2x16({texel.b, texel.a})});
    if (level.width == 1 && level.height == 1) return {first, size, levels, 0};
    level = halved(level);
  }
}

}  // namespace opaline
