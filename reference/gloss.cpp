#include "reference/gloss.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "bssrdf/fresnel.h"

namespace opaline::reference {

namespace {

using std::numbers::pi;
constexpr int rows = 48;     // of roughness
constexpr int columns = 64;  // of the cosine to the eye
constexpr int lattice = 21;  // of facets, squared

// Visits facets that are seen at that cosine by what part of even light they mirror if they mirror
// all, and the cosine to them.
template <typename Visit>
void forEachFacet(double alpha, double cosine, const Visit& visit) {
  const Vector eye{std::sqrt(1 - cosine * cosine), 0, cosine};
  for (int i = 0; i < lattice; ++i)
    for (int j = 0; j < lattice; ++j) {
      const Vector facet = visibleFacet(alpha, eye, (i + 0.5) / lattice, (j + 0.5) / lattice);
      const double toFacet = dot(eye, facet);
      const double cosineIn = 2 * toFacet * facet[2] - eye[2];
      if (cosineIn <= 0 || toFacet <= 0) continue;
      const double hidden = ggxHidden(alpha, cosine);
      visit((1 + hidden) / (1 + hidden + ggxHidden(alpha, cosineIn)) / (lattice * lattice),
            std::min(toFacet, 1.0));
    }
}

MirroredShares integrated(double alpha, double cosine) {
  MirroredShares shares;
  forEachFacet(alpha, cosine, [&](double seen, double toFacet) {
    const double grazing = std::pow(1 - toFacet, 5);
    shares.base += seen * (1 - grazing);
    shares.grazing += seen * grazing;
  });
  return shares;
}

std::vector<MirroredShares> tabulated() {
  std::vector<MirroredShares> table;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const double roughness = std::max((row + 0.0) / (rows - 1), 0.02);
      table.push_back(integrated(roughness * roughness, (column + 0.5) / columns));
    }
  return table;
}

}  // namespace

double ggxDensity(double alpha, double cosineHalf) {
  const double a2 = alpha * alpha;
  const double t = cosineHalf * cosineHalf * (a2 - 1) + 1;
  return a2 / (pi * t * t);
}

double ggxHidden(double alpha, double cosine) {
  const double tangentSquared = (1 - cosine * cosine) / (cosine * cosine);
  return 0.5 * (std::sqrt(1 + alpha * alpha * std::max(tangentSquared, 0.0)) - 1);
}

Vector visibleFacet(double alpha, const Vector& toEye, double u1, double u2) {
  const Vector stretched = unitOr({alpha * toEye[0], alpha * toEye[1], toEye[2]}, {0, 0, 1});
  const double across = std::hypot(stretched[0], stretched[1]);
  const Vector t1 =
      across > 0 ? Vector{-stretched[1] / across, stretched[0] / across, 0} : Vector{1, 0, 0};
  const Vector t2 = cross(stretched, t1);
  const double radius = std::sqrt(u1);
  const double angle = 2 * pi * u2;
  const double a = radius * std::cos(angle);
  const double s = 0.5 * (1 + stretched[2]);
  const double b = (1 - s) * std::sqrt(std::max(1 - a * a, 0.0)) + s * radius * std::sin(angle);
  const double c = std::sqrt(std::max(1 - a * a - b * b, 0.0));
  const Vector facet = a * t1 + b * t2 + c * stretched;
  return unitOr({alpha * facet[0], alpha * facet[1], std::max(facet[2], 0.0)}, {0, 0, 1});
}

MirroredShares mirroredShares(double alpha, double cosine) {
  static const std::vector<MirroredShares> table = tabulated();
  const double row = std::clamp(std::sqrt(alpha) * (rows - 1), 0.0, rows - 1.001);
  const double column = std::clamp(cosine * columns - 0.5, 0.0, columns - 1.001);
  const auto at = [&](int i, int j) { return table[static_cast<std::size_t>(i * columns + j)]; };
  const int i = static_cast<int>(row);
  const int j = static_cast<int>(column);
  const auto mean = [&](double MirroredShares::*part) {
    return std::lerp(std::lerp(at(i, j).*part, at(i, j + 1).*part, column - j),
                     std::lerp(at(i + 1, j).*part, at(i + 1, j + 1).*part, column - j), row - i);
  };
  return {mean(&MirroredShares::base), mean(&MirroredShares::grazing)};
}

MediumMirror::MediumMirror(double eta, double alpha) {
  for (int column = 0; column < columns; ++column) {
    double share = 0;
    forEachFacet(alpha, (column + 0.5) / columns, [&](double seen, double toFacet) {
      share += seen * bssrdf::fresnelReflectance(eta, toFacet);
    });
    table_.push_back(share);
  }
}

double MediumMirror::share(double cosine) const {
  const double column = std::clamp(cosine * columns - 0.5, 0.0, columns - 1.001);
  const auto i = static_cast<std::size_t>(column);
  return std::lerp(table_[i], table_[i + 1], column - static_cast<double>(i));
}

}  // namespace opaline::reference
