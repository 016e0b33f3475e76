#include "reference/texture.h"

#include <algorithm>
#include <cmath>

#include "opaline/tone.h"

namespace opaline::reference {

namespace {

double wrapped(double at, TextureWrap wrap) {
  if (wrap == TextureWrap::ClampToEdge) return std::clamp(at, 0.0, 1.0);
  const double part = at - std::floor(at);
  if (wrap == TextureWrap::Repeat) return part;
  return std::fmod(std::floor(at), 2.0) == 0 ? part : 1 - part;
}

// The index of a pixel beside the border, as the texture continues there.
int neighbour(int at, int size, TextureWrap wrap) {
  if (at >= 0 && at < size) return at;
  if (wrap == TextureWrap::Repeat) return (at + size) % size;
  return std::clamp(at, 0, size - 1);
}

/// One channel of a texture.
struct Channel {
  const Texture& texture;
  std::size_t index;
  bool isColor;

  double pixel(int x, int y) const {
    const TexturePixels& pixels = *texture.pixels;
    x = neighbour(x, pixels.width, texture.wrapU);
    y = neighbour(y, pixels.height, texture.wrapV);
    const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(pixels.width) +
                    static_cast<std::size_t>(x);
    const float stored = static_cast<float>(pixels.rgba[4 * at + index]) / 65535;
    return double{isColor ? decodeSrgb(stored) : stored};
  }

  double at(double u, double v) const {
    const auto along = [&](const Vec3& row) {
      return double{row[0]} * u + double{row[1]} * v + double{row[2]};
    };
    const double x = wrapped(along(texture.transform[0]), texture.wrapU) * texture.pixels->width;
    const double y = wrapped(along(texture.transform[1]), texture.wrapV) * texture.pixels->height;
    if (!texture.interpolated) return pixel(static_cast<int>(x), static_cast<int>(y));
    const int left = static_cast<int>(std::floor(x - 0.5));
    const int top = static_cast<int>(std::floor(y - 0.5));
    const double right = x - 0.5 - left;
    const double down = y - 0.5 - top;
    return (1 - down) * ((1 - right) * pixel(left, top) + right * pixel(left + 1, top)) +
           down * ((1 - right) * pixel(left, top + 1) + right * pixel(left + 1, top + 1));
  }
};

template <typename Of>
double meanOf(const Body& body, const SurfacePoint& point, const Of& of) {
  const Triangle& corners = body.triangles[point.triangle];
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += point.weights[k] * double{of(corners[k])};
  return sum;
}

}  // namespace

double textureAt(const Body& body, const SurfacePoint& point, const std::optional<Texture>& texture,
                 std::size_t channel, TexelKind kind) {
  if (!texture) return 1;
  constexpr std::size_t alpha = 3;
  const Channel read{*texture, channel, kind == TexelKind::Color && channel != alpha};
  const auto& coordinates = body.textureCoordinates[texture->coordinates == 1];
  if (coordinates.empty()) return read.at(0, 0);
  return read.at(meanOf(body, point, [&](std::uint32_t v) { return coordinates[v][0]; }),
                 meanOf(body, point, [&](std::uint32_t v) { return coordinates[v][1]; }));
}

double vertexColorAt(const Body& body, const SurfacePoint& point, std::size_t channel) {
  if (body.colors.empty()) return 1;
  return meanOf(body, point, [&](std::uint32_t v) { return body.colors[v][channel]; });
}

}  // namespace opaline::reference
