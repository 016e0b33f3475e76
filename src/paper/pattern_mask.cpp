#include "paper/pattern_mask.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace opaline::paper {

namespace {

constexpr std::array<double, 4> gaussPoints{-0.8611363115940526, -0.3399810435848563,
                                            0.3399810435848563, 0.8611363115940526};
constexpr std::array<double, 4> gaussWeights{0.3478548451374538, 0.6521451548625461,
                                             0.6521451548625461, 0.3478548451374538};

// The integral of the profile over a square without the origin, by Gauss and Legendre.
double integralOverSquare(const bssrdf::Profile& profile, double centreX, double centreY,
                          double edge) {
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      sum += gaussWeights[i] * gaussWeights[j] *
             profile(std::hypot(centreX + 0.5 * edge * gaussPoints[i],
                                centreY + 0.5 * edge * gaussPoints[j]));
  return sum * 0.25 * edge * edge;
}

double discOfArea(const bssrdf::Profile& profile, double areaMm2) {
  return profile.disc(std::sqrt(areaMm2 / std::numbers::pi));
}

float packOffset(int x, int y) {
  const auto bits =
      (static_cast<std::uint32_t>(y) << 16U) | (static_cast<std::uint32_t>(x) & 0xffffU);
  return std::bit_cast<float>(bits);
}

// Texels.
double ringArea(const PatternExtent& extent) {
  return std::numbers::pi * (std::pow(extent.outer, 2) - std::pow(extent.blockRadius(), 2));
}

// Half the edge of a square as large as an eighth of the ring, because a linear filter doubles it.
int cellEdge(const PatternExtent& extent) {
  return std::max(1, static_cast<int>(std::lround(0.5 * std::sqrt(ringArea(extent) / 8))));
}

// For a disc, about its centre.
double meanSquareRadius(double area) {
  return area / (2 * std::numbers::pi);
}

class MaskBuilder {
 public:
  MaskBuilder(const std::array<bssrdf::Profile, 3>& profiles, const PatternExtent& extent,
              double texelMm)
      : profiles_(profiles), extent_(extent), texelMm_(texelMm) {}

  PatternMask build() {
    mask_.nearSquareMm2 = meanSquareRadius(std::pow(extent_.spacing * texelMm_, 2));
    mask_.farSquareMm2 = meanSquareRadius(ringArea(extent_) / 8 * texelMm_ * texelMm_);
    addCentre();
    const int rings = extent_.nearRings;
    for (int y = -rings; y <= rings; ++y)
      for (int x = -rings; x <= rings; ++x)
        if (x != 0 || y != 0) addNear(x * extent_.spacing, y * extent_.spacing);
    mask_.nearSamples = static_cast<std::uint32_t>(mask_.entries.size() - 2);
    addFar();
    return std::move(mask_);
  }

 private:
  const bssrdf::Profile& profile(int channel) const {
    return profiles_[static_cast<std::size_t>(channel)];
  }

  void addCentre() {
    const double cell = extent_.spacing * extent_.spacing * texelMm_ * texelMm_;
    shared::PatternEntry reflectance{};
    shared::PatternEntry exponent{};
    for (int c = 0; c < 3; ++c) {
      const double value = discOfArea(profile(c), cell);
      constexpr double step = 1e-3;
      const double slope =
          (discOfArea(profile(c), cell * (1 + step)) - discOfArea(profile(c), cell * (1 - step))) /
          (2 * step);
      reflectance.value[c] = static_cast<float>(value);
      exponent.value[c] = value > 0 ? static_cast<float>(std::max(slope, 0.0) / value) : 0.0F;
    }
    reflectance.value.a = static_cast<float>(texelMm_ * texelMm_);
    exponent.value.a = static_cast<float>(extent_.spacing * extent_.spacing);
    mask_.entries.push_back(reflectance);
    mask_.entries.push_back(exponent);
  }

  void addNear(int x, int y) {
    const double edge = extent_.spacing * texelMm_;
    const double distanceMm = std::hypot(x, y) * texelMm_;
    shared::PatternEntry entry{};
    for (int c = 0; c < 3; ++c) {
      const double mean =
          integralOverSquare(profile(c), x * texelMm_, y * texelMm_, edge) / (edge * edge);
      entry.value[c] = partOfDistance(profile(c), mean, distanceMm, mask_.nearSquareMm2);
    }
    entry.value.a = packOffset(x, y);
    mask_.entries.push_back(entry);
  }

  void addFar() {
    const double inner = extent_.blockRadius() * texelMm_;
    const double outer = extent_.outer * texelMm_;
    const double texels = ringArea(extent_) / 8;
    shared::PatternEntry entry{};
    for (int c = 0; c < 3; ++c) {
      const double mean = texels > 0 ? (profile(c).disc(outer) - profile(c).disc(inner)) /
                                           (8 * texels * texelMm_ * texelMm_)
                                     : 0;
      entry.value[c] =
          partOfDistance(profile(c), mean, extent_.distance * texelMm_, mask_.farSquareMm2);
    }
    entry.value.a = static_cast<float>(texels);
    mask_.entries.push_back(entry);
  }

  // Square of the part of a sample's distance at which the profile, with the extent of the sample's
  // piece of surface included, equals its mean over that piece; by bisection.
  static float partOfDistance(const bssrdf::Profile& profile, double mean, double distanceMm,
                              double squareMm2) {
    constexpr double largest = 4;
    if (!(mean > 0)) return static_cast<float>(largest);  // too little to be told from nothing
    double low = 0;
    double high = largest;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      const double there = profile(std::sqrt(middle * distanceMm * distanceMm + squareMm2));
      (there > mean ? low : high) = middle;
    }
    return static_cast<float>(low);
  }

  const std::array<bssrdf::Profile, 3>& profiles_;
  const PatternExtent& extent_;
  double texelMm_;
  PatternMask mask_;
};

}  // namespace

double PatternExtent::blockRadius() const {
  return (2 * nearRings + 1) * spacing / std::sqrt(std::numbers::pi);
}

int PatternExtent::nearReach() const {
  return nearRings * spacing + 2;
}

PatternExtent patternExtent(const PatternShape& shape, double texelMm, double objectAreaMm2) {
  // Parts of the radius of a disc of the object's area, beyond which a body is no plane any more.
  // These give the least error against the sum of all sources, over media and bodies.
  constexpr double largestBlock = 0.25;
  constexpr double largestRing = 0.6;
  constexpr double largest = 16384;
  const double objectRadius = std::sqrt(objectAreaMm2 / std::numbers::pi) / texelMm;
  const double across = 2 * shape.nearRings + 1;
  PatternExtent extent{.nearRings = shape.nearRings};
  extent.spacing =
      static_cast<int>(std::clamp(std::min(std::round(shape.nearSpacingMm / texelMm),
                                           std::floor(largestBlock * objectRadius / across)),
                                  1.0, largest));
  const double block = extent.blockRadius();
  const double nearest = std::ceil(block) + 1;
  const double wanted = std::max(nearest, shape.farDistanceMm / texelMm);
  const double furthest = std::max(nearest, 0.5 * (largestRing * objectRadius + block));
  extent.distance = static_cast<int>(std::round(std::min({wanted, furthest, largest})));
  extent.outer = std::clamp(2 * wanted - block, block, std::max(block, objectRadius));
  extent.cell = cellEdge(extent);
  return extent;
}

PatternExtent fitted(PatternExtent extent, int nearReach) {
  while (extent.nearReach() > nearReach && extent.nearRings > 0) {
    if (extent.spacing > 1)
      --extent.spacing;
    else
      --extent.nearRings;
  }
  return extent;
}

PatternMask makePatternMask(const std::array<bssrdf::Profile, 3>& profiles,
                            const PatternExtent& extent, double texelMm) {
  return MaskBuilder(profiles, extent, texelMm).build();
}

}  // namespace opaline::paper
