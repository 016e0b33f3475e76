#include "reference/path/layer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "bssrdf/paint.h"
#include "opaline/tone.h"

namespace opaline::reference {

namespace {

double wrapped(double at, TextureWrap wrap) {
  if (wrap == TextureWrap::ClampToEdge) return std::clamp(at, 0.0, 1.0);
  const double part = at - std::floor(at);
  if (wrap == TextureWrap::Repeat) return part;
  return std::fmod(std::floor(at), 2.0) == 0 ? part : 1 - part;
}

// Place of a pixel beside the border, as a picture without an end has it.
int neighbour(int at, int size, TextureWrap wrap) {
  if (at >= 0 && at < size) return at;
  if (wrap == TextureWrap::Repeat) return (at + size) % size;
  return std::clamp(at, 0, size - 1);
}

double pixel(const Texture& texture, int x, int y, std::size_t channel) {
  const TexturePixels& pixels = *texture.pixels;
  x = neighbour(x, pixels.width, texture.wrapU);
  y = neighbour(y, pixels.height, texture.wrapV);
  const auto index = static_cast<std::size_t>(y) * static_cast<std::size_t>(pixels.width) +
                     static_cast<std::size_t>(x);
  return double{decodeSrgb(static_cast<float>(pixels.rgba[4 * index + channel]) / 65535)};
}

double sampled(const Texture& texture, double u, double v, std::size_t channel) {
  const auto along = [&](const Vec3& row) {
    return double{row[0]} * u + double{row[1]} * v + double{row[2]};
  };
  const double x = wrapped(along(texture.transform[0]), texture.wrapU) * texture.pixels->width;
  const double y = wrapped(along(texture.transform[1]), texture.wrapV) * texture.pixels->height;
  if (!texture.interpolated)
    return pixel(texture, static_cast<int>(x), static_cast<int>(y), channel);
  const int left = static_cast<int>(std::floor(x - 0.5));
  const int top = static_cast<int>(std::floor(y - 0.5));
  const double right = x - 0.5 - left;
  const double down = y - 0.5 - top;
  return (1 - down) * ((1 - right) * pixel(texture, left, top, channel) +
                       right * pixel(texture, left + 1, top, channel)) +
         down * ((1 - right) * pixel(texture, left, top + 1, channel) +
                 right * pixel(texture, left + 1, top + 1, channel));
}

}  // namespace

Layer::Layer(const Body& body, int channel)
    : body_(&body),
      channel_(static_cast<std::size_t>(channel)),
      bare_(double{colorOf(body.medium)[channel_]}) {
  constexpr std::size_t entries = 1024;
  const auto layers = bssrdf::paints(body.medium, entries);
  for (const bssrdf::PaintedBoundary& layer : layers[channel_]) table_.push_back(layer.thickness);
}

double Layer::colorAt(const SurfacePoint& point) const {
  const Body::Painted& painted = *body_->painted;
  const Triangle& corners = body_->triangles[point.triangle];
  double color = double{painted.paint.color[channel_]};
  const auto mean = [&](const auto& of) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += point.weights[k] * of(corners[k]);
    return sum;
  };
  if (!painted.colors.empty())
    color *= mean([&](std::uint32_t v) { return double{painted.colors[v][channel_]}; });
  const std::optional<Texture>& texture = painted.paint.colorTexture;
  if (!texture) return color;
  const auto& coordinates = painted.textureCoordinates[texture->coordinates == 1];
  if (coordinates.empty()) return color * sampled(*texture, 0, 0, channel_);
  return color * sampled(*texture, mean([&](std::uint32_t v) { return double{coordinates[v][0]}; }),
                         mean([&](std::uint32_t v) { return double{coordinates[v][1]}; }),
                         channel_);
}

double Layer::thicknessAt(const SurfacePoint& point) const {
  if (!body_) return thickness_;
  const double part = std::sqrt(std::clamp(colorAt(point) / std::max(bare_, 1e-6), 0.0, 1.0));
  const double at = part * static_cast<double>(table_.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(at), table_.size() - 2);
  return std::lerp(table_[low], table_[low + 1], at - static_cast<double>(low));
}

}  // namespace opaline::reference
