// The expansion far from a piece of surface, against the sum over its points.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "bssrdf/profile.h"
#include "reference/bodies.h"
#include "reference/kernel.h"
#include "reference/moments.h"

namespace opaline {
namespace {

using namespace test;
using reference::Kernel;
using reference::Moments;

std::array<Kernel, 3> kernelsOf(const Medium& medium, bssrdf::Model model) {
  return {Kernel(bssrdf::makeProfile(model, bssrdf::coefficients(medium, 0))),
          Kernel(bssrdf::makeProfile(model, bssrdf::coefficients(medium, 1))),
          Kernel(bssrdf::makeProfile(model, bssrdf::coefficients(medium, 2)))};
}

TEST(KernelTest, IsTheProfileOfJensen) {
  const auto kernels = kernelsOf(marble(), bssrdf::Model::Dipole);
  for (std::size_t c = 0; c < 3; ++c) {
    const DipoleByTheBook dipole(marble(), c);
    for (const double r : {0.0, 0.1, 1.0, 10.0, 60.0}) {
      EXPECT_NEAR(kernels[c](r * r)[0] / dipole(r), 1, 1e-12) << c << " " << r;
    }
  }
}

TEST(KernelTest, EachFunctionIsTheDerivativeOfTheOneBefore) {
  for (const auto model : {bssrdf::Model::Dipole, bssrdf::Model::BetterDipole}) {
    const Kernel kernel = kernelsOf(skin(), model)[1];
    for (const double s : {0.0, 0.3, 4.0, 90.0}) {
      const double step = 1e-4 * (s + 1);
      const auto below = kernel(s + 2 * step);
      const auto above = kernel(s + step);
      const auto at = kernel(s);
      const auto least = kernel(s + 3 * step);
      const auto farther = kernel(s + 4 * step);
      for (std::size_t k = 0; k + 1 < at.size(); ++k) {
        // One-sided difference of fourth order.
        const double slope =
            (-25 * at[k] + 48 * above[k] - 36 * below[k] + 16 * least[k] - 3 * farther[k]) /
            (12 * step);
        EXPECT_NEAR(slope / (-0.5 * at[k + 1]), 1, 1e-5) << "G" << k << " at " << s;
      }
    }
  }
}

/// Samples scattered over a patch of that size, and their moments.
struct Piece {
  std::array<reference::FluxSample, 24> samples;
  Moments moments;

  explicit Piece(double size) {
    const std::array<Vector, 3> corners{Vector{-size, -size, 0}, {size, -size, 0}, {0, size, 0}};
    double seed = 0.1;
    for (auto& sample : samples) {
      const auto next = [&] { return seed = std::fmod(seed * 997 + 0.618, 1); };
      const double u = next();
      const double v = next() * (1 - u);
      sample.position = (1 - u - v) * corners[0] + u * corners[1] + v * corners[2];
      sample.flux = {next(), 0.1 + next(), 2 * next()};
    }
    moments = reference::momentsOf(samples, corners);
  }
};

std::array<double, 3> summed(const Piece& piece, const Vector& place,
                             const std::array<Kernel, 3>& kernels) {
  std::array<double, 3> sum{};
  for (const auto& sample : piece.samples) {
    const Vector d = place - sample.position;
    for (std::size_t c = 0; c < 3; ++c) sum[c] += sample.flux[c] * kernels[c](dot(d, d))[0];
  }
  return sum;
}

const std::vector<Vector> places{{0, 0, 0},   {0.4, 0.1, 0}, {0, 0, 1},  {2, 1, 0.5},
                                 {-3, 4, -1}, {0, 15, 6},    {40, 0, 30}};

TEST(ExpansionTest, ErrsLessThanItSays) {
  for (const auto model : {bssrdf::Model::Dipole, bssrdf::Model::BetterDipole}) {
    for (const Medium& medium : {marble(), skin()}) {
      const auto kernels = kernelsOf(medium, model);
      for (const double size : {0.02, 0.1, 0.5, 2.0}) {
        const Piece piece(size);
        for (const Vector& place : places) {
          if (!isExpandable(piece.moments, place, kernels[2].depthMm())) continue;
          const auto found = contribution(piece.moments, place, kernels);
          const auto exact = summed(piece, place, kernels);
          for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_LE(std::abs(found.exitance[c] - exact[c]), found.bound[c] + 1e-12 * exact[c])
                << size << " at " << testing::PrintToString(place);
          }
        }
      }
    }
  }
}

TEST(ExpansionTest, ErrorFallsWithTheFourthPowerOfTheSize) {
  const auto kernels = kernelsOf(marble(), bssrdf::Model::Dipole);
  const Vector place{3, 2, 1};
  const auto error = [&](double size) {
    const Piece piece(size);
    const double exact = summed(piece, place, kernels)[0];
    return std::abs(contribution(piece.moments, place, kernels).exitance[0] / exact - 1);
  };
  const double order = std::log2(error(0.4) / error(0.2));
  EXPECT_GT(order, 3.6);
  EXPECT_LT(order, 4.6);
}

TEST(ExpansionTest, JoinedPiecesAreOnePiece) {
  const Piece whole(0.5);
  std::array<Moments, 4> parts;
  for (std::size_t i = 0; i < 4; ++i) {
    std::array<reference::FluxSample, 6> some;
    std::copy_n(whole.samples.begin() + static_cast<std::ptrdiff_t>(6 * i), 6, some.begin());
    parts[i] = reference::momentsOf(some, {some[0].position, some[1].position, some[2].position});
  }
  const Moments sum = reference::joined(parts.data(), parts.size());
  EXPECT_NEAR(length(sum.centre - whole.moments.centre), 0, 1e-13);
  for (std::size_t c = 0; c < 3; ++c) {
    const auto& found = sum.channels[c];
    const auto& exact = whole.moments.channels[c];
    EXPECT_NEAR(found.flux, exact.flux, 1e-12);
    EXPECT_NEAR(length(found.first - exact.first), 0, 1e-12);
    for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(found.second[k], exact.second[k], 1e-12);
    for (std::size_t k = 0; k < 10; ++k) EXPECT_NEAR(found.third[k], exact.third[k], 1e-12);
    EXPECT_GE(found.fourth, exact.fourth);
  }
}

}  // namespace
}  // namespace opaline
