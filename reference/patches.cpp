#include "reference/patches.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>

namespace opaline::reference {

namespace {

// Orbits (a, a, 1-2a) and their weights, Strang and Fix 1973, as in Dunavant 1985, degree 4.
constexpr double outerWeight = 0.109951743655322;
constexpr double innerWeight = 0.223381589678011;
constexpr double outerPlace = 0.091576213509771;
constexpr double innerPlace = 0.445948490915965;

using Matrix6 = std::array<std::array<double, 6>, 6>;

std::array<double, 6> monomials(double u, double v) {
  return {1, u, v, u * u, u * v, v * v};
}

/// Gauss-Jordan elimination with pivots.
Matrix6 inverse(Matrix6 a) {
  Matrix6 result{};
  for (std::size_t i = 0; i < 6; ++i) result[i][i] = 1;
  for (std::size_t column = 0; column < 6; ++column) {
    std::size_t pivot = column;
    for (std::size_t row = column + 1; row < 6; ++row) {
      if (std::abs(a[row][column]) > std::abs(a[pivot][column])) pivot = row;
    }
    std::swap(a[pivot], a[column]);
    std::swap(result[pivot], result[column]);
    const double scale = 1 / a[column][column];
    for (std::size_t k = 0; k < 6; ++k) {
      a[column][k] *= scale;
      result[column][k] *= scale;
    }
    for (std::size_t row = 0; row < 6; ++row) {
      const double factor = row == column ? 0 : a[row][column];
      for (std::size_t k = 0; k < 6; ++k) {
        a[row][k] -= factor * a[column][k];
        result[row][k] -= factor * result[column][k];
      }
    }
  }
  return result;
}

/// The matrix from values at the rule's points to coefficients of the monomials.
const Matrix6& interpolation() {
  static const Matrix6 matrix = [] {
    Matrix6 values{};
    for (std::size_t i = 0; i < 6; ++i) {
      values[i] = monomials(triangleRule()[i].weights[1], triangleRule()[i].weights[2]);
    }
    return inverse(values);
  }();
  return matrix;
}

std::array<double, 2> inside(const SubTriangle& triangle, const std::array<double, 3>& weights) {
  std::array<double, 2> place{};
  for (std::size_t corner = 0; corner < 3; ++corner) {
    for (std::size_t i = 0; i < 2; ++i) place[i] += weights[corner] * triangle[corner][i];
  }
  return place;
}

Vector pointOf(const std::array<Vector, 3>& corners, const std::array<double, 2>& place) {
  return (1 - place[0] - place[1]) * corners[0] + place[0] * corners[1] + place[1] * corners[2];
}

std::array<Vector, 3> cornersOf(const std::array<Vector, 3>& corners, const SubTriangle& part) {
  return {pointOf(corners, part[0]), pointOf(corners, part[1]), pointOf(corners, part[2])};
}

double areaOf(const std::array<Vector, 3>& corners) {
  return 0.5 * length(cross(corners[1] - corners[0], corners[2] - corners[0]));
}

double longestEdge(const std::array<Vector, 3>& corners) {
  return std::max({length(corners[1] - corners[0]), length(corners[2] - corners[1]),
                   length(corners[0] - corners[2])});
}

using Values = std::array<Colour, 6>;

/// Divides one triangle of the mesh.
class Divider {
 public:
  Divider(const Geometry& geometry, const Irradiance& irradiance, const PatchOptions& options,
          std::uint32_t body, std::uint32_t triangle)
      : geometry_(geometry),
        irradiance_(irradiance),
        options_(options),
        body_(body),
        triangle_(triangle) {
    const Body& of = geometry.scene().bodies[body];
    for (std::size_t i = 0; i < 3; ++i) {
      corners_[i] = of.positionsMm[of.triangles[triangle][i]];
    }
    const Colour facing =
        irradiance.facing(geometry.pointOn(body, triangle, {1. / 3, 1. / 3, 1. / 3}));
    for (std::size_t c = 0; c < 3; ++c) negligible_[c] = 0.01 * facing[c];
  }

  void divide(Patches& patches) {
    if (areaOf(corners_) > 0) divide(wholeTriangle, sample(wholeTriangle), 0, patches);
  }

 private:
  // Division ends by size long before.
  static constexpr int mostLevels = 24;

  Values sample(const SubTriangle& part) const {
    Values values;
    for (std::size_t i = 0; i < 6; ++i) {
      const auto [u, v] = inside(part, triangleRule()[i].weights);
      values[i] = irradiance_(geometry_.pointOn(body_, triangle_, {1 - u - v, u, v}));
    }
    return values;
  }

  void divide(const SubTriangle& part, const Values& values, int level, Patches& patches) {
    const std::array<SubTriangle, 4> parts = quarters(part);
    std::array<Values, 4> finer;
    for (std::size_t i = 0; i < 4; ++i) finer[i] = sample(parts[i]);
    const Fit fit = compare(part, values, finer);
    const double edge = longestEdge(cornersOf(corners_, part));
    if (fit.smooth && edge <= options_.largestMm) {
      addSmooth(part, values, fit.error, patches);
    } else if (edge > options_.smallestMm && level < mostLevels) {
      const std::size_t before = patches.size();
      const std::size_t borders = patches.withBorders;
      for (std::size_t i = 0; i < 4; ++i) divide(parts[i], finer[i], level + 1, patches);
      const bool whole = patches.withBorders == borders;
      if (fit.smooth && whole) join(part, values, fit.error, before, patches);
    } else {
      addBorder(part, finer, patches);
    }
  }

  struct Fit {
    bool smooth = true;
    Colour error{};  ///< of the flux, Σ |E - interpolated E| dA
  };

  Fit compare(const SubTriangle& part, const Values& values,
              const std::array<Values, 4>& finer) const {
    const QuadraticE polynomial(values);
    const double area = areaOf(cornersOf(corners_, part));
    const std::array<SubTriangle, 4> parts = quarters(wholeTriangle);
    Fit fit;
    Colour mean{};
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t k = 0; k < 6; ++k) {
        const auto [u, v] = inside(parts[i], triangleRule()[k].weights);
        const Colour guess = polynomial.at(u, v);
        const double weight = 0.25 * triangleRule()[k].part;
        for (std::size_t c = 0; c < 3; ++c) {
          fit.error[c] += weight * area * std::abs(guess[c] - finer[i][k][c]);
          mean[c] += weight * finer[i][k][c];
        }
      }
    }
    for (std::size_t c = 0; c < 3; ++c) {
      const double allowed = options_.tolerance * (mean[c] + negligible_[c]) * area;
      fit.smooth = fit.smooth && fit.error[c] <= allowed;
    }
    return fit;
  }

  static void add(const Patch& patch, const Moments& moments, Patches& patches) {
    if (moments.isDark()) return;
    patches.patches.push_back(patch);
    patches.moments.push_back(moments);
  }

  void addSmooth(const SubTriangle& part, const Values& values, const Colour& error,
                 Patches& patches) const {
    const Patch patch{cornersOf(corners_, part), QuadraticE(values)};
    Moments moments = momentsOf(patch, wholeTriangle);
    for (std::size_t c = 0; c < 3; ++c) moments.channels[c].smoothError = error[c];
    add(patch, moments, patches);
  }

  // Undoes a division that was made for its size only.
  void join(const SubTriangle& part, const Values& values, Colour error, std::size_t before,
            Patches& patches) const {
    if (patches.size() > before + 4) return;
    for (std::size_t i = before; i < patches.size(); ++i) {
      for (std::size_t c = 0; c < 3; ++c) error[c] += patches.moments[i].channels[c].smoothError;
    }
    patches.patches.resize(before);
    patches.moments.resize(before);
    addSmooth(part, values, error, patches);
  }

  // Each of the pieces of 24 samples is wholly on one side of the border or the other, so the
  // border's error is about a tenth of the patch. Errors of patches are independent.
  void addBorder(const SubTriangle& part, const std::array<Values, 4>& finer,
                 Patches& patches) const {
    constexpr double uncertainPart = 0.1;
    const std::array<Vector, 3> corners = cornersOf(corners_, part);
    const double area = areaOf(corners);
    const std::array<SubTriangle, 4> parts = quarters(wholeTriangle);
    std::array<FluxSample, 24> samples;
    Colour mean{};
    Colour least = finer[0][0];
    Colour most = finer[0][0];
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const RulePoint& point = triangleRule()[i % 6];
      const Colour& value = finer[i / 6][i % 6];
      samples[i].position = pointOf(corners, inside(parts[i / 6], point.weights));
      for (std::size_t c = 0; c < 3; ++c) {
        mean[c] += 0.25 * point.part * value[c];
        samples[i].flux[c] = 0.25 * point.part * area * value[c];
        least[c] = std::min(least[c], value[c]);
        most[c] = std::max(most[c], value[c]);
      }
    }
    Moments moments = opaline::reference::momentsOf(samples, corners);
    for (std::size_t c = 0; c < 3; ++c) {
      const double error = uncertainPart * area * (most[c] - least[c]);
      moments.channels[c].borderVariance = error * error;
    }
    const std::size_t before = patches.size();
    add({corners, QuadraticE(mean)}, moments, patches);
    patches.withBorders += patches.size() - before;
  }

  const Geometry& geometry_;
  const Irradiance& irradiance_;
  const PatchOptions& options_;
  std::uint32_t body_;
  std::uint32_t triangle_;
  std::array<Vector, 3> corners_{};
  Colour negligible_{};
};

}  // namespace

std::array<SubTriangle, 4> quarters(const SubTriangle& t) {
  const auto middle = [](const std::array<double, 2>& a, const std::array<double, 2>& b) {
    return std::array<double, 2>{0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])};
  };
  const auto ab = middle(t[0], t[1]);
  const auto bc = middle(t[1], t[2]);
  const auto ca = middle(t[2], t[0]);
  return {SubTriangle{t[0], ab, ca}, {ab, t[1], bc}, {ca, bc, t[2]}, {ab, bc, ca}};
}

const std::array<RulePoint, 6>& triangleRule() {
  constexpr double outer = 1 - 2 * outerPlace;
  constexpr double inner = 1 - 2 * innerPlace;
  static constexpr std::array<RulePoint, 6> rule{{{{outer, outerPlace, outerPlace}, outerWeight},
                                                  {{outerPlace, outer, outerPlace}, outerWeight},
                                                  {{outerPlace, outerPlace, outer}, outerWeight},
                                                  {{inner, innerPlace, innerPlace}, innerWeight},
                                                  {{innerPlace, inner, innerPlace}, innerWeight},
                                                  {{innerPlace, innerPlace, inner}, innerWeight}}};
  return rule;
}

QuadraticE::QuadraticE(const std::array<Colour, 6>& atRulePoints) {
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t k = 0; k < 6; ++k) {
      for (std::size_t c = 0; c < 3; ++c) {
        coefficients_[i][c] += interpolation()[i][k] * atRulePoints[k][c];
      }
    }
  }
}

QuadraticE::QuadraticE(const Colour& everywhere) {
  coefficients_[0] = everywhere;
}

Colour QuadraticE::at(double second, double third) const {
  const std::array<double, 6> basis = monomials(second, third);
  Colour value{};
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t c = 0; c < 3; ++c) value[c] += basis[i] * coefficients_[i][c];
  }
  return value;
}

Moments momentsOf(const Patch& patch, const SubTriangle& part) {
  const std::array<Vector, 3> corners = cornersOf(patch.corners, part);
  const double area = areaOf(corners);
  std::array<FluxSample, 6> samples;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const RulePoint& point = triangleRule()[i];
    const std::array<double, 2> place = inside(part, point.weights);
    const Colour value = patch.irradiance.at(place[0], place[1]);
    samples[i].position = pointOf(patch.corners, place);
    for (std::size_t c = 0; c < 3; ++c) samples[i].flux[c] = point.part * area * value[c];
  }
  return momentsOf(samples, corners);
}

std::optional<Patches> makePatches(const Geometry& geometry, const Irradiance& irradiance,
                                   std::uint32_t body, const PatchOptions& options) {
  constexpr std::size_t blockSize = 256;
  const std::size_t triangles = geometry.scene().bodies[body].triangles.size();
  std::vector<Patches> blocks((triangles + blockSize - 1) / blockSize);
  std::atomic<std::size_t> count = 0;
  tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t block) {
    const std::size_t last = std::min((block + 1) * blockSize, triangles);
    for (std::size_t i = block * blockSize; i < last && count <= options.most; ++i) {
      throwIfStopped(options.stop);
      const std::size_t before = blocks[block].size();
      Divider(geometry, irradiance, options, body, static_cast<std::uint32_t>(i))
          .divide(blocks[block]);
      count += blocks[block].size() - before;
    }
  });
  if (count > options.most) return std::nullopt;
  Patches all;
  all.patches.reserve(count);
  all.moments.reserve(count);
  for (Patches& block : blocks) {
    all.patches.insert(all.patches.end(), block.patches.begin(), block.patches.end());
    all.moments.insert(all.moments.end(), block.moments.begin(), block.moments.end());
    all.withBorders += block.withBorders;
    block = {};
  }
  return all;
}

}  // namespace opaline::reference
