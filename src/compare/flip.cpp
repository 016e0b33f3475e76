#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "compare/cie_color.h"
#include "compare/plane.h"
#include "core/sound_image.h"
#include "opaline/compare.h"
#include "opaline/error.h"
#include "opaline/tone.h"

namespace opaline::compare {

namespace {

// Sections and symbols are those of Andersson et al. 2020.

/// Section 4.1.1: a contrast sensitivity function is a sum of Gaussians a √(π/b) exp(-π² r²/b), r
/// in degrees.
struct Gaussian {
  double a;
  double b;
};
constexpr Gaussian achromatic{1, 0.0047};
constexpr Gaussian redGreen{1, 0.0053};
constexpr std::array<Gaussian, 2> blueYellow{{{34.1, 0.04}, {13.5, 0.025}}};
constexpr double widestB = 0.04;

// Section 4.1.3, 4.2 and 4.3.
constexpr double qc = 0.7;
constexpr double pc = 0.4;
constexpr double pt = 0.95;
constexpr double qf = 0.5;
constexpr double featureWidthDegrees = 0.082;

template <typename Function>
Kernel sampled(double radius, Function function) {
  const int reach = static_cast<int>(std::ceil(radius));
  Kernel kernel;
  for (int x = -reach; x <= reach; ++x) kernel.push_back(function(static_cast<double>(x)));
  return kernel;
}

double sum(const Kernel& kernel) {
  double result = 0;
  for (const double weight : kernel) result += weight;
  return result;
}

Kernel scaled(Kernel kernel, double factor) {
  for (double& weight : kernel) weight *= factor;
  return kernel;
}

/// One Gaussian of a sensitivity. exp(-π² (x²+y²)/b) is a product, so the filter is separable.
struct SensitivityKernel {
  Kernel kernel;  ///< sums to 1
  double weight;  ///< of the Gaussian in its sensitivity, before weights are normalised to sum to 1
};

SensitivityKernel sensitivityKernel(const Gaussian& gaussian, double pixelsPerDegree) {
  constexpr double pi = std::numbers::pi;
  // Three standard deviations of the widest of all Gaussians.
  const double radius = 3 * std::sqrt(widestB / (2 * pi * pi)) * pixelsPerDegree;
  const Kernel raw = sampled(radius, [&](double x) {
    const double degrees = x / pixelsPerDegree;
    return std::exp(-pi * pi * degrees * degrees / gaussian.b);
  });
  const double total = sum(raw);
  return {scaled(raw, 1 / total), gaussian.a * std::sqrt(pi / gaussian.b) * total * total};
}

/// Section 4.2: first and second derivatives of a Gaussian, whose positive weights sum to 1 and
/// whose negative ones to -1.
struct FeatureKernels {
  Kernel smooth;
  Kernel edge;
  Kernel point;
};

Kernel balanced(Kernel kernel) {
  double positive = 0;
  double negative = 0;
  for (const double weight : kernel) (weight > 0 ? positive : negative) += weight;
  for (double& weight : kernel) weight /= weight > 0 ? positive : -negative;
  return kernel;
}

FeatureKernels featureKernels(double pixelsPerDegree) {
  const double sigma = featureWidthDegrees / 2 * pixelsPerDegree;
  const double variance = sigma * sigma;
  const auto gaussian = [&](double x) { return std::exp(-x * x / (2 * variance)); };
  const Kernel smooth = sampled(3 * sigma, gaussian);
  return {
      scaled(smooth, 1 / sum(smooth)),
      balanced(sampled(3 * sigma, [&](double x) { return -x * gaussian(x); })),
      balanced(sampled(3 * sigma, [&](double x) { return (x * x / variance - 1) * gaussian(x); }))};
}

Plane magnitude(Plane x, const Plane& y) {
  for (std::size_t i = 0; i < x.values.size(); ++i) {
    x.values[i] = std::hypot(x.values[i], y.values[i]);
  }
  return x;
}

/// Y_y, C_x and C_z of section 4.1.1: L*a*b* without its roots.
std::array<Plane, 3> toYcxcz(const Image8& picture) {
  std::array<double, 256> linear{};
  for (std::size_t i = 0; i < linear.size(); ++i) {
    linear[i] = static_cast<double>(decodeSrgb(static_cast<float>(i) / 255.0F));
  }
  const Plane empty(picture.width, picture.height);
  std::array<Plane, 3> planes{empty, empty, empty};
  for (std::size_t i = 0; i < empty.values.size(); ++i) {
    const std::uint8_t* const pixel = &picture.rgba[4 * i];
    const Triple xyz = relativeXyz({linear[pixel[0]], linear[pixel[1]], linear[pixel[2]]});
    planes[0].values[i] = static_cast<float>(116 * xyz[1] - 16);
    planes[1].values[i] = static_cast<float>(500 * (xyz[0] - xyz[1]));
    planes[2].values[i] = static_cast<float>(200 * (xyz[1] - xyz[2]));
  }
  return planes;
}

void applySensitivity(std::array<Plane, 3>& ycxcz, double pixelsPerDegree) {
  const Kernel y = sensitivityKernel(achromatic, pixelsPerDegree).kernel;
  const Kernel x = sensitivityKernel(redGreen, pixelsPerDegree).kernel;
  const SensitivityKernel wide = sensitivityKernel(blueYellow[0], pixelsPerDegree);
  const SensitivityKernel narrow = sensitivityKernel(blueYellow[1], pixelsPerDegree);
  ycxcz[0] = filtered(ycxcz[0], y, y);
  ycxcz[1] = filtered(ycxcz[1], x, x);
  const Plane other = filtered(ycxcz[2], narrow.kernel, narrow.kernel);
  ycxcz[2] = filtered(ycxcz[2], wide.kernel, wide.kernel);
  const double share = narrow.weight / (wide.weight + narrow.weight);
  for (std::size_t i = 0; i < other.values.size(); ++i) {
    ycxcz[2].values[i] = static_cast<float>(std::lerp(static_cast<double>(ycxcz[2].values[i]),
                                                      static_cast<double>(other.values[i]), share));
  }
}

/// Section 4.1.2: the Hunt effect; colors are more colorful when they are light.
Triple huntAdjustedLab(const Triple& linearRgb) {
  const Triple color = lab(linearRgb);
  return {color[0], 0.01 * color[0] * color[1], 0.01 * color[0] * color[2]};
}

/// HyAB distance (Abasi et al. 2019), to the power q_c.
double colorDistance(const Triple& a, const Triple& b) {
  const double distance = std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]);
  return std::pow(distance, qc);
}

/// Filtered colors, converted back from YCxCz and clamped to the cube that a screen can show.
Triple shown(const std::array<Plane, 3>& ycxcz, std::size_t pixel) {
  const double y = (static_cast<double>(ycxcz[0].values[pixel]) + 16) / 116;
  Triple rgb = linearRgbFromRelativeXyz({y + static_cast<double>(ycxcz[1].values[pixel]) / 500, y,
                                         y - static_cast<double>(ycxcz[2].values[pixel]) / 200});
  for (double& channel : rgb) channel = std::clamp(channel, 0.0, 1.0);
  return rgb;
}

/// Section 4.1.3: distances up to p_c times the largest are mapped to p_t of the range.
double redistributed(double distance) {
  static const double largest =
      colorDistance(huntAdjustedLab({0, 1, 0}), huntAdjustedLab({0, 0, 1}));
  const double bend = pc * largest;
  if (distance < bend) return pt / bend * distance;
  return std::min(pt + (distance - bend) / (largest - bend) * (1 - pt), 1.0);
}

struct Seen {
  std::array<Plane, 3> color;  ///< YCxCz after the sensitivities
  Plane edges;
  Plane points;
};

Seen look(const Image8& picture, double pixelsPerDegree) {
  Seen seen;
  seen.color = toYcxcz(picture);
  Plane luminance = seen.color[0];
  for (float& value : luminance.values) value = (value + 16) / 116;
  const FeatureKernels kernels = featureKernels(pixelsPerDegree);
  seen.edges = magnitude(filtered(luminance, kernels.edge, kernels.smooth),
                         filtered(luminance, kernels.smooth, kernels.edge));
  seen.points = magnitude(filtered(luminance, kernels.point, kernels.smooth),
                          filtered(luminance, kernels.smooth, kernels.point));
  applySensitivity(seen.color, pixelsPerDegree);
  return seen;
}

}  // namespace

Plane flipMap(const Image8& a, const Image8& b, double pixelsPerDegree) {
  if (a.width != b.width || a.height != b.height)
    throw UsageError("images that are compared must have the same size");
  core::requireSound(a);
  core::requireSound(b);
  if (!(pixelsPerDegree >= 1 && pixelsPerDegree <= 1000))
    throw UsageError("pixels per degree must be from 1 to 1000");
  const Seen seenA = look(a, pixelsPerDegree);
  const Seen seenB = look(b, pixelsPerDegree);
  Plane map(a.width, a.height);
  for (std::size_t i = 0; i < map.values.size(); ++i) {
    const double color = redistributed(colorDistance(huntAdjustedLab(shown(seenA.color, i)),
                                                     huntAdjustedLab(shown(seenB.color, i))));
    const double features =
        static_cast<double>(std::max(std::abs(seenA.edges.values[i] - seenB.edges.values[i]),
                                     std::abs(seenA.points.values[i] - seenB.points.values[i])));
    // Each difference is at most √2.
    const double feature = std::pow(std::min(features / std::numbers::sqrt2, 1.0), qf);
    map.values[i] = static_cast<float>(std::pow(color, 1 - feature));
  }
  return map;
}

}  // namespace opaline::compare
