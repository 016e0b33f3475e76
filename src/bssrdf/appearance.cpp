#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "bssrdf/ball.h"
#include "opaline/medium.h"

namespace opaline {

namespace {

// The share C of the even light that entered a half-space leaves again. With s = √(1 - α'):
// C = (1 - s)(1 - b s) / (1 + c s).
struct Fit {
  double eta;
  double b;
  double c;
};
constexpr std::array<Fit, 6> fits{{{1.0, 0.100, 1.217},
                                   {1.2, 0.410, 2.153},
                                   {1.3, 0.450, 2.825},
                                   {1.4, 0.480, 3.569},
                                   {1.5, 0.500, 4.398},
                                   {1.6, 0.520, 5.293}}};

Fit fitAt(double eta) {
  std::size_t above = 1;
  while (above + 1 < fits.size() && fits[above].eta < eta) ++above;
  const Fit& low = fits[above - 1];
  const Fit& high = fits[above];
  const double part = std::clamp((eta - low.eta) / (high.eta - low.eta), 0.0, 1.0);
  return {eta, std::lerp(low.b, high.b, part), std::lerp(low.c, high.c, part)};
}

double colorOf(double s, const Fit& fit) {
  return (1 - s) * (1 - fit.b * s) / (1 + fit.c * s);
}

/// s = √(1 - α') of an observed colour. The albedo follows from s and g.
double observed(double color, const Fit& fit) {
  const double sum = 1 + fit.b + fit.c * color;
  return (sum - std::sqrt(sum * sum - 4 * fit.b * (1 - color))) / (2 * fit.b);
}

double albedoOf(double s, double g) {
  return (1 - s * s) / (1 - g * s * s);
}

/// The same for a ball, by bisection: the more it absorbs, the darker it is.
double observedOnBall(double color, const Appearance& appearance, std::size_t channel,
                      const Fit& fit) {
  double low = 0;
  double high = 1;
  for (int i = 0; i < 60; ++i) {
    const double s = (low + high) / 2;
    const double reducedPerMm =
        (1 - appearance.g * albedoOf(s, appearance.g)) / appearance.meanFreePathMm[channel];
    const double trPerMm = std::sqrt(3.0) * s * reducedPerMm;
    const double seen =
        bssrdf::colorOfBall(colorOf(s, fit), appearance.eta, appearance.ballMm / 2 * trPerMm);
    (seen > color ? low : high) = s;
  }
  return (low + high) / 2;
}

/// The same by the formula of KHR_materials_volume_scatter, after Kulla and Conty 2017.
double khr(double color) {
  const double s =
      4.09712 + 4.20863 * color - std::sqrt(9.59217 + 41.6808 * color + 17.7126 * color * color);
  return std::clamp(s, 0.0, 1.0);
}

}  // namespace

Medium mediumOf(const Appearance& appearance) {
  const Fit fit = fitAt(appearance.eta);
  Medium medium;
  medium.eta = appearance.eta;
  medium.g = appearance.g;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const double color = std::clamp(appearance.color[channel], 0.0, 1.0);
    double s = 0;
    if (appearance.colorModel == ColorModel::Khr) {
      s = khr(color);
    } else if (appearance.ballMm > 0) {
      s = observedOnBall(color, appearance, channel, fit);
    } else {
      s = observed(color, fit);
    }
    // A medium has to scatter something.
    constexpr double leastAlbedo = 1e-4;
    const double albedo = std::max(albedoOf(s, appearance.g), leastAlbedo);
    const double extinctionPerMm = 1 / appearance.meanFreePathMm[channel];
    medium.sigmaSPrimePerMm[channel] = (1 - appearance.g) * albedo * extinctionPerMm;
    medium.sigmaAPerMm[channel] = (1 - albedo) * extinctionPerMm;
  }
  return medium;
}

Rgb colorOf(const Medium& medium) {
  const Fit fit = fitAt(medium.eta);
  Rgb color{};
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const double absorbed = medium.sigmaAPerMm[channel];
    const double s = std::sqrt(absorbed / (absorbed + medium.sigmaSPrimePerMm[channel]));
    color[channel] = static_cast<float>(colorOf(s, fit));
  }
  return color;
}

}  // namespace opaline
