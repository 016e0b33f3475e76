#include "reference/path/distance_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace opaline::reference {

namespace {

/// Voxels along the longest edge of the box.
constexpr double voxelsAlong = 160;
/// Squared distance, in voxels, before any voxel of the surface is found.
constexpr float farAway = 1e12F;

/// Computes the squared distance to the nearest marked voxel along one line, in place: the lower
/// envelope of parabolas.
class LineTransform {
 public:
  explicit LineTransform(std::size_t longest)
      : heights_(longest), roots_(longest), borders_(longest + 1) {}

  void operator()(float* values, std::size_t count, std::size_t stride) {
    for (std::size_t i = 0; i < count; ++i) heights_[i] = values[i * stride];
    std::size_t last = 0;
    roots_[0] = 0;
    borders_[0] = -std::numeric_limits<double>::infinity();
    borders_[1] = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < count; ++i) {
      double meet = intersection(i, roots_[last]);
      while (meet <= borders_[last]) meet = intersection(i, roots_[--last]);
      roots_[++last] = i;
      borders_[last] = meet;
      borders_[last + 1] = std::numeric_limits<double>::infinity();
    }
    std::size_t at = 0;
    for (std::size_t i = 0; i < count; ++i) {
      while (borders_[at + 1] < static_cast<double>(i)) ++at;
      const double apart = static_cast<double>(i) - static_cast<double>(roots_[at]);
      values[i * stride] = static_cast<float>(apart * apart + heights_[roots_[at]]);
    }
  }

 private:
  double intersection(std::size_t a, std::size_t b) const {
    const auto x = static_cast<double>(a);
    const auto y = static_cast<double>(b);
    return (heights_[a] + x * x - heights_[b] - y * y) / (2 * (x - y));
  }

  std::vector<double> heights_;
  std::vector<std::size_t> roots_;
  std::vector<double> borders_;
};

}  // namespace

DistanceBound::DistanceBound(const Scene& scene) {
  const Box box = boxOfMedia(scene);
  const Vector extent = box.maxMm - box.minMm;
  const double edge = std::max({extent[0], extent[1], extent[2], 1e-12}) / voxelsAlong;
  voxelsPerMm_ = 1 / edge;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    // One more voxel on either side, so that rounding leaves nothing outside.
    originMm_[axis] = box.minMm[axis] - edge;
    size_[axis] = static_cast<std::size_t>(std::ceil(extent[axis] * voxelsPerMm_)) + 3;
  }
  boundMm_.assign(size_[0] * size_[1] * size_[2], farAway);

  // Every voxel in a triangle's box counts as touched, which only lowers the bound. Large triangles
  // are halved until that costs little.
  struct Piece {
    Vector a, b, c;
  };
  std::vector<Piece> pieces;
  // Opaque bodies may extend beyond the grid.
  const auto isOutside = [&](const Piece& piece) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto [least, most] = std::minmax({piece.a[axis], piece.b[axis], piece.c[axis]});
      if ((most - originMm_[axis]) * voxelsPerMm_ < 0 ||
          (least - originMm_[axis]) * voxelsPerMm_ > static_cast<double>(size_[axis]))
        return true;
    }
    return false;
  };
  const auto voxelAt = [&](double placeMm, std::size_t axis, double slack) {
    return static_cast<std::size_t>(std::clamp((placeMm - originMm_[axis]) * voxelsPerMm_ + slack,
                                               0.0, static_cast<double>(size_[axis] - 1)));
  };
  const auto mark = [&](const Piece& piece) {
    std::array<std::size_t, 3> low{};
    std::array<std::size_t, 3> high{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto [least, most] = std::minmax({piece.a[axis], piece.b[axis], piece.c[axis]});
      low[axis] = voxelAt(least, axis, -1e-6);
      high[axis] = voxelAt(most, axis, 1e-6);
    }
    for (std::size_t x = low[0]; x <= high[0]; ++x)
      for (std::size_t y = low[1]; y <= high[1]; ++y)
        for (std::size_t z = low[2]; z <= high[2]; ++z)
          boundMm_[(x * size_[1] + y) * size_[2] + z] = 0;
  };
  for (const Body& body : scene.bodies) {
    for (const Triangle& t : body.triangles) {
      pieces.push_back({body.positionsMm[t[0]], body.positionsMm[t[1]], body.positionsMm[t[2]]});
      while (!pieces.empty()) {
        const Piece piece = pieces.back();
        pieces.pop_back();
        if (isOutside(piece)) continue;
        const double longest = std::max(
            {length(piece.b - piece.a), length(piece.c - piece.b), length(piece.a - piece.c)});
        if (longest <= 2 * edge) {
          mark(piece);
          continue;
        }
        const Vector ab = 0.5 * (piece.a + piece.b);
        const Vector bc = 0.5 * (piece.b + piece.c);
        const Vector ca = 0.5 * (piece.c + piece.a);
        pieces.insert(pieces.end(),
                      {{piece.a, ab, ca}, {ab, piece.b, bc}, {ca, bc, piece.c}, {ab, bc, ca}});
      }
    }
  }

  LineTransform transform(std::max({size_[0], size_[1], size_[2]}));
  const std::size_t plane = size_[1] * size_[2];
  for (std::size_t x = 0; x < size_[0]; ++x)
    for (std::size_t y = 0; y < size_[1]; ++y)
      transform(&boundMm_[x * plane + y * size_[2]], size_[2], 1);
  for (std::size_t x = 0; x < size_[0]; ++x)
    for (std::size_t z = 0; z < size_[2]; ++z)
      transform(&boundMm_[x * plane + z], size_[1], size_[2]);
  for (std::size_t i = 0; i < plane; ++i) transform(&boundMm_[i], size_[0], plane);

  // Point and surface may each be half a diagonal from the middle of their voxel.
  for (float& value : boundMm_)
    value = static_cast<float>(
        std::max(std::sqrt(static_cast<double>(value)) - std::sqrt(3.0), 0.0) * edge * 0.9999);
}

}  // namespace opaline::reference
