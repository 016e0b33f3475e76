#include "reference/gloss.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <mutex>
#include <numbers>

#include "bssrdf/fresnel.h"

namespace opaline::reference {

namespace {

using std::numbers::pi;
constexpr int rows = 48;     // of roughness
constexpr int columns = 64;  // of the cosine to the eye
constexpr int lattice = 21;  // of facets, squared

double integrated(double alpha, double cosine, const std::function<double(double)>& reflectance) {
  const Vector eye{std::sqrt(1 - cosine * cosine), 0, cosine};
  const double hidden = ggxHidden(alpha, cosine);
  double sum = 0;
  for (int i = 0; i < lattice; ++i)
    for (int j = 0; j < lattice; ++j) {
      const Vector facet = visibleFacet(alpha, eye, (i + 0.5) / lattice, (j + 0.5) / lattice);
      const double toFacet = dot(eye, facet);
      const double cosineIn = 2 * toFacet * facet[2] - eye[2];
      if (cosineIn <= 0 || toFacet <= 0) continue;
      const double seen = (1 + hidden) / (1 + hidden + ggxHidden(alpha, cosineIn));
      sum += seen * reflectance(std::min(toFacet, 1.0));
    }
  return sum / (lattice * lattice);
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

MirroredShare::MirroredShare(const std::function<double(double)>& reflectance) {
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const double roughness = std::max((row + 0.0) / (rows - 1), 0.02);
      table_.push_back(integrated(roughness * roughness, (column + 0.5) / columns, reflectance));
    }
}

double MirroredShare::operator()(double alpha, double cosine) const {
  const double row = std::clamp(std::sqrt(alpha) * (rows - 1), 0.0, rows - 1.001);
  const double column = std::clamp(cosine * columns - 0.5, 0.0, columns - 1.001);
  const int i = static_cast<int>(row);
  const int j = static_cast<int>(column);
  const auto at = [&](int y, int x) { return table_[static_cast<std::size_t>(y * columns + x)]; };
  return std::lerp(std::lerp(at(i, j), at(i, j + 1), column - j),
                   std::lerp(at(i + 1, j), at(i + 1, j + 1), column - j), row - i);
}

const MirroredShare& mirroredShareOfMedium(double eta) {
  static std::mutex mutex;
  static std::map<double, MirroredShare> known;
  const std::lock_guard lock(mutex);
  const auto fresnel = [&](double toFacet) { return bssrdf::fresnelReflectance(eta, toFacet); };
  return known.try_emplace(eta, fresnel).first->second;
}

MirroredShares mirroredShares(double alpha, double cosine) {
  const auto grazingOf = [](double toFacet) { return std::pow(1 - toFacet, 5); };
  static const MirroredShare base([&](double toFacet) { return 1 - grazingOf(toFacet); });
  static const MirroredShare grazing(grazingOf);
  return {base(alpha, cosine), grazing(alpha, cosine)};
}

}  // namespace opaline::reference
