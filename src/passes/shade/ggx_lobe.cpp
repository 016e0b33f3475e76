#include "passes/shade/ggx_lobe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace opaline::passes {

namespace {

using Direction = std::array<double, 3>;

double reversedBits(std::uint32_t bits) {
  bits = (bits << 16U) | (bits >> 16U);
  bits = ((bits & 0x00ff00ffU) << 8U) | ((bits & 0xff00ff00U) >> 8U);
  bits = ((bits & 0x0f0f0f0fU) << 4U) | ((bits & 0xf0f0f0f0U) >> 4U);
  bits = ((bits & 0x33333333U) << 2U) | ((bits & 0xccccccccU) >> 2U);
  bits = ((bits & 0x55555555U) << 1U) | ((bits & 0xaaaaaaaaU) >> 1U);
  return bits * 0x1p-32;
}

Direction normalized(const Direction& v) {
  const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  return {v[0] / length, v[1] / length, v[2] / length};
}

// A sample of the normals visible from `out` (Heitz 2018, listing 1), which lies in the xz plane.
Direction visibleNormal(const Direction& out, double alpha, double u1, double u2) {
  const Direction v = normalized({alpha * out[0], 0, out[2]});
  const Direction t1{0, 1, 0};
  const Direction t2{v[1] * t1[2] - v[2] * t1[1], v[2] * t1[0] - v[0] * t1[2],
                     v[0] * t1[1] - v[1] * t1[0]};
  const double r = std::sqrt(u1);
  const double phi = 2 * std::numbers::pi * u2;
  const double a = r * std::cos(phi);
  const double s = 0.5 * (1 + v[2]);
  const double b = (1 - s) * std::sqrt(1 - a * a) + s * r * std::sin(phi);
  const double c = std::sqrt(std::max(0.0, 1 - a * a - b * b));
  const Direction n{a * t1[0] + b * t2[0] + c * v[0], a * t1[1] + b * t2[1] + c * v[1],
                    a * t1[2] + b * t2[2] + c * v[2]};
  return normalized({alpha * n[0], alpha * n[1], std::max(0.0, n[2])});
}

// Smith's Λ for GGX.
double lambda(double cosine, double alpha) {
  const double tangentSquared = (1 - cosine * cosine) / (cosine * cosine);
  return 0.5 * (std::sqrt(1 + alpha * alpha * tangentSquared) - 1);
}

}  // namespace

double mirroredOfAll(double alpha, double cosine, std::uint32_t samples,
                     const std::function<double(double)>& reflectance) {
  const Direction out{std::sqrt(1 - cosine * cosine), 0, cosine};
  const double lambdaOut = lambda(cosine, alpha);
  double sum = 0;
  for (std::uint32_t i = 0; i < samples; ++i) {
    const Direction half = visibleNormal(out, alpha, (i + 0.5) / samples, reversedBits(i));
    const double cosineHalf = out[0] * half[0] + out[2] * half[2];
    const double cosineIn = 2 * cosineHalf * half[2] - out[2];
    if (cosineIn <= 0 || cosineHalf <= 0) continue;
    const double shadowing = (1 + lambdaOut) / (1 + lambdaOut + lambda(cosineIn, alpha));
    sum += reflectance(std::min(cosineHalf, 1.0)) * shadowing;
  }
  return sum / samples;
}

}  // namespace opaline::passes
