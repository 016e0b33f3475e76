#include "reference/path/layer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "bssrdf/paint.h"
#include "reference/texture.h"

namespace opaline::reference {

Layer::Layer(const Body& body, int channel)
    : body_(&body),
      channel_(static_cast<std::size_t>(channel)),
      bare_(double{colorOf(body.medium)[channel_]}) {
  constexpr std::size_t entries = 1024;
  const auto layers = bssrdf::paints(body.medium, entries);
  for (const bssrdf::PaintedBoundary& layer : layers[channel_]) table_.push_back(layer.thickness);
}

double Layer::colorAt(const SurfacePoint& point) const {
  return double{body_->paint->color[channel_]} * vertexColorAt(*body_, point, channel_) *
         textureAt(*body_, point, body_->paint->colorTexture, channel_, TexelKind::Color);
}

double Layer::thicknessAt(const SurfacePoint& point) const {
  if (!body_) return thickness_;
  const double part = std::sqrt(std::clamp(colorAt(point) / std::max(bare_, 1e-6), 0.0, 1.0));
  const double at = part * static_cast<double>(table_.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(at), table_.size() - 2);
  return std::lerp(table_[low], table_[low + 1], at - static_cast<double>(low));
}

}  // namespace opaline::reference
