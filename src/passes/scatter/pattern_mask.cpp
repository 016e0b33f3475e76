#include "passes/scatter/pattern_mask.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace opaline::passes {

namespace {

constexpr std::array<double, 4> gaussPoints{-0.8611363115940526, -0.3399810435848563,
                                            0.3399810435848563, 0.8611363115940526};
constexpr std::array<double, 4> gaussWeights{0.3478548451374538, 0.6521451548625461,
                                             0.6521451548625461, 0.3478548451374538};

// Of the profile over a square that does not hold the origin, Gauss and Legendre.
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
  const auto bits = (static_cast<std::uint32_t>(y) << 16U) | (static_cast<std::uint32_t>(x) & 0xffffU);
  return std::bit_cast<float>(bits);
}

// How many texels a sample stands for that alone has to give `reflectance`.
float texelsFor(double reflectance, double profileValue, double texelArea) {
  return profileValue > 0 ? static_cast<float>(reflectance / (profileValue * texelArea)) : 0.0F;
}

class MaskBuilder {
 public:
  MaskBuilder(const std::array<bssrdf::Profile, 3>& profiles, const PatternShape& shape)
      : profiles_(profiles),
        texelMm_(shape.texelMm),
        rings_(shape.nearRings),
        limit_(std::max(1, shape.mapSize / 2)),
        spacing_(toTexels(shape.nearSpacingMm)),
        far_(std::clamp(toTexels(shape.farDistanceMm), (rings_ + 1) * spacing_,
                        std::max(limit_, (rings_ + 1) * spacing_))) {}

  PatternMask build() {
    addCentre();
    for (int y = -rings_; y <= rings_; ++y)
      for (int x = -rings_; x <= rings_; ++x)
        if (x != 0 || y != 0) addNear(x * spacing_, y * spacing_);
    addFar();
    return std::move(mask_);
  }

 private:
  int toTexels(double lengthMm) const {
    return static_cast<int>(std::clamp(std::round(lengthMm / texelMm_), 1.0,
                                       static_cast<double>(limit_)));
  }

  void addCentre() {
    const double cell = spacing_ * spacing_ * texelMm_ * texelMm_;
    shared::PatternEntry reflectance{};
    shared::PatternEntry exponent{};
    for (int c = 0; c < 3; ++c) {
      const bssrdf::Profile& profile = profiles_[static_cast<std::size_t>(c)];
      const double value = discOfArea(profile, cell);
      constexpr double step = 1e-3;
      const double slope = (discOfArea(profile, cell * (1 + step)) -
                            discOfArea(profile, cell * (1 - step))) / (2 * step);
      reflectance.value[c] = static_cast<float>(value);
      exponent.value[c] = value > 0 ? static_cast<float>(slope / value) : 0.0F;
    }
    reflectance.value.a = static_cast<float>(texelMm_ * texelMm_);
    mask_.entries.push_back(reflectance);
    mask_.entries.push_back(exponent);
  }

  void addNear(int x, int y) {
    const double edge = spacing_ * texelMm_;
    shared::PatternEntry entry{};
    for (int c = 0; c < 3; ++c) {
      const bssrdf::Profile& profile = profiles_[static_cast<std::size_t>(c)];
      entry.value[c] =
          texelsFor(integralOverSquare(profile, x * texelMm_, y * texelMm_, edge),
                    profile(std::hypot(x, y) * texelMm_), texelMm_ * texelMm_);
    }
    add(entry, x, y);
  }

  void addFar() {
    const double block = (2 * rings_ + 1) * spacing_ * texelMm_;
    const double inner = block / std::sqrt(std::numbers::pi);
    const double distance = far_ * texelMm_;
    const double outer = std::max(2 * distance - inner, inner);
    shared::PatternEntry entry{};
    for (int c = 0; c < 3; ++c) {
      const bssrdf::Profile& profile = profiles_[static_cast<std::size_t>(c)];
      entry.value[c] = texelsFor((profile.disc(outer) - profile.disc(inner)) / 8,
                                 profile(distance), texelMm_ * texelMm_);
    }
    for (int i = 0; i < 8; ++i) {
      const double angle = (i + 0.5) * std::numbers::pi / 4;
      add(entry, static_cast<int>(std::lround(far_ * std::cos(angle))),
          static_cast<int>(std::lround(far_ * std::sin(angle))));
    }
  }

  void add(shared::PatternEntry entry, int x, int y) {
    entry.value.a = packOffset(x, y);
    mask_.entries.push_back(entry);
    ++mask_.samples;
  }

  const std::array<bssrdf::Profile, 3>& profiles_;
  double texelMm_;
  int rings_;
  int limit_;
  int spacing_;
  int far_;
  PatternMask mask_;
};

}  // namespace

PatternMask makePatternMask(const std::array<bssrdf::Profile, 3>& profiles,
                            const PatternShape& shape) {
  return MaskBuilder(profiles, shape).build();
}

}  // namespace opaline::passes
