#include "bssrdf/paint.h"

#include <algorithm>
#include <cmath>

#include "bssrdf/ball.h"
#include "bssrdf/fresnel.h"
#include "bssrdf/profile.h"

namespace opaline::bssrdf {

namespace {

struct Moments {
  double twoC1 = 0;
  double threeC2 = 0;
  double t1 = 0;
  double t2 = 0;
};

// Below the critical cosine all is reflected. In either range, the cosines are denser towards the
// lower end, where the path through the layer is long and Fresnel's reflectance steep.
Moments momentsOf(double eta, double thickness) {
  constexpr int steps = 192;
  const double critical = std::sqrt(std::max(0.0, 1 - 1 / (eta * eta)));
  Moments moments;
  const auto add = [&](double low, double high) {
    for (int i = 0; i < steps; ++i) {
      const double at = (i + 0.5) / steps;
      const double cosine = low + (high - low) * at * at;
      const double weight = (high - low) * 2 * at / steps;
      const double reflectance = fresnelReflectanceInside(eta, cosine);
      const double through = std::exp(-thickness / cosine);
      moments.twoC1 += 2 * weight * cosine * reflectance * through * through;
      moments.threeC2 += 3 * weight * cosine * cosine * reflectance * through * through;
      moments.t1 += 2 * weight * cosine * (1 - reflectance) * through;
      moments.t2 += 3 * weight * cosine * cosine * (1 - reflectance) * through;
    }
  };
  if (critical > 0) add(0, critical);
  add(critical, 1);
  return moments;
}

double robinA(const Moments& moments) {
  return (1 + moments.threeC2) / (1 - moments.twoC1);
}

PaintedBoundary boundaryOf(double thickness, const Moments& bare, const Moments& with) {
  const double a = robinA(bare);
  const double painted = robinA(with);
  const double kappa = 2 / (1 + with.threeC2);
  PaintedBoundary boundary;
  boundary.thickness = thickness;
  boundary.entering = with.t1 / bare.t1;
  boundary.layer = a / painted;
  boundary.leaving = 2 * a * (with.t1 / 4 + with.t2 / (4 * painted));
  boundary.takenOff = kappa * boundary.entering * with.t2 / 2;
  boundary.source = kappa * boundary.entering;
  return boundary;
}

PaintedBoundary mixed(const PaintedBoundary& a, const PaintedBoundary& b, double part) {
  return {std::lerp(a.thickness, b.thickness, part),
          std::lerp(a.entering, b.entering, part),
          std::lerp(a.layer, b.layer, part),
          std::lerp(a.leaving, b.leaving, part),
          std::lerp(a.takenOff, b.takenOff, part),
          std::lerp(a.source, b.source, part),
          std::lerp(a.deep, b.deep, part)};
}

// Of even light that passed the interface, the share that a half-space returns. `taken` is the part
// of the fluence that it takes away, √(σ_a D).
double reflectanceOf(const PaintedBoundary& boundary, double a, double taken) {
  const double fluence = boundary.source / (taken + boundary.layer / (2 * a));
  return fluence * boundary.leaving / (2 * a) - boundary.takenOff;
}

// The entry with that reflectance, interpolated in a table by ascending thickness. Reflectance
// falls as layers grow.
PaintedBoundary withReflectance(const std::vector<PaintedBoundary>& table,
                                const std::vector<double>& reflectances, double wanted) {
  const auto after = std::lower_bound(reflectances.begin(), reflectances.end(), wanted,
                                      [](double has, double is) { return has > is; });
  if (after == reflectances.begin()) return table.front();
  if (after == reflectances.end()) return table.back();
  const auto i = static_cast<std::size_t>(after - reflectances.begin());
  const double drop = reflectances[i - 1] - reflectances[i];
  return mixed(table[i - 1], table[i], drop > 0 ? (reflectances[i - 1] - wanted) / drop : 0);
}

constexpr std::size_t fineLayers = 256;

std::vector<PaintedBoundary> fineTable(double eta) {
  const Moments bare = momentsOf(eta, 0);
  std::vector<PaintedBoundary> table;
  for (std::size_t i = 0; i < fineLayers; ++i) {
    const double part = static_cast<double>(i) / (fineLayers - 1);
    const double thickness = thickestPaint * part * part;
    table.push_back(boundaryOf(thickness, bare, momentsOf(eta, thickness)));
  }
  return table;
}

// Shares of light that leaves, relative to those without a layer: for even light, and for a source
// at any depth.
struct Shares {
  std::vector<double> even;
  std::vector<double> deep;
};

Shares sharesOf(const std::vector<PaintedBoundary>& layers, double a, const Profile& profile) {
  const double taken = profile.diffusionMm * profile.sigmaTrPerMm;
  const auto deep = [&](const PaintedBoundary& layer) {
    return layer.leaving / (taken + layer.layer / (2 * a));
  };
  Shares shares;
  for (const PaintedBoundary& layer : layers) {
    shares.even.push_back(reflectanceOf(layer, a, taken) / reflectanceOf(layers.front(), a, taken));
    shares.deep.push_back(deep(layer) / deep(layers.front()));
  }
  return shares;
}

}  // namespace

PaintedBoundary paintedBoundary(double eta, double thickness) {
  return boundaryOf(thickness, momentsOf(eta, 0), momentsOf(eta, thickness));
}

std::array<std::vector<PaintedBoundary>, 3> paints(const Medium& medium, std::size_t n) {
  const std::vector<PaintedBoundary> layers = fineTable(medium.eta);
  const double a = robinA(momentsOf(medium.eta, 0));
  const std::array<Profile, 3> profiles = makeProfiles(Model::BetterDipole, medium);
  std::array<std::vector<PaintedBoundary>, 3> made;
  for (std::size_t c = 0; c < 3; ++c) {
    const Shares shares = sharesOf(layers, a, profiles[c]);
    std::vector<PaintedBoundary> ofChannel = layers;
    for (std::size_t i = 0; i < layers.size(); ++i)
      ofChannel[i].deep = shares.even[i] / (layers[i].entering * shares.deep[i]);
    for (std::size_t i = 0; i < n; ++i) {
      const double part = static_cast<double>(i) / static_cast<double>(n - 1);
      made[c].push_back(withReflectance(ofChannel, shares.even, part * part));
    }
  }
  return made;
}

std::array<LayerColors, 3> layerColors(const Medium& medium, double ballMm) {
  const std::vector<PaintedBoundary> layers = fineTable(medium.eta);
  const double a = robinA(momentsOf(medium.eta, 0));
  const Rgb bare = colorOf(medium);
  const std::array<Profile, 3> profiles = makeProfiles(Model::BetterDipole, medium);
  std::array<LayerColors, 3> colors;
  for (std::size_t c = 0; c < 3; ++c) {
    const double x = ballMm / 2 * profiles[c].sigmaTrPerMm;
    const double byThick = profiles[c].diffusionMm * profiles[c].sigmaTrPerMm;
    const double byBall = byThick * takenByBall(x);
    const double thick = double{bare[c]} / reflectanceOf(layers.front(), a, byThick);
    const double ball =
        colorOfBall(double{bare[c]}, medium.eta, x) / reflectanceOf(layers.front(), a, byBall);
    for (const PaintedBoundary& layer : layers) {
      colors[c].thick.push_back(thick * reflectanceOf(layer, a, byThick));
      colors[c].ball.push_back(ball * reflectanceOf(layer, a, byBall));
    }
  }
  return colors;
}

}  // namespace opaline::bssrdf
