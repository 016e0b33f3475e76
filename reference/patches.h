#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "reference/irradiance.h"
#include "reference/moments.h"
#include "reference/run_control.h"

namespace opaline::reference {

/// A triangle in the plane of weights: its corners, each as weights of the second and third corner
/// of a larger triangle.
using SubTriangle = std::array<std::array<double, 2>, 3>;

constexpr SubTriangle wholeTriangle{{{0, 0}, {1, 0}, {0, 1}}};

/// The four equal parts of a triangle.
std::array<SubTriangle, 4> quarters(const SubTriangle& triangle);

/// The six points of the rule of degree 4 (Strang and Fix 1973): their weights of the three
/// corners, and the part of the area that each represents.
struct RulePoint {
  std::array<double, 3> weights;
  double part;
};
const std::array<RulePoint, 6>& triangleRule();

/// E over a triangle as the quadratic polynomial through its values at the rule's six points.
class QuadraticE {
 public:
  QuadraticE() = default;
  explicit QuadraticE(const std::array<Colour, 6>& atRulePoints);
  explicit QuadraticE(const Colour& everywhere);

  /// At weights of the second and third corner.
  Colour at(double second, double third) const;

 private:
  std::array<Colour, 6> coefficients_{};  ///< of 1, u, v, u², uv, v²
};

/// A piece of the surface with known E, so that it can be divided without more rays.
struct Patch {
  std::array<Vector, 3> corners{};
  QuadraticE irradiance;  ///< constant, the mean, where a border of shadow crosses
};

/// The exact moments of a part of a patch.
Moments momentsOf(const Patch& patch, const SubTriangle& part);

/// Patches, and the moments of each as a whole.
struct Patches {
  std::vector<Patch> patches;
  std::vector<Moments> moments;
  std::size_t withBorders = 0;  ///< those that a border of shadow crosses

  std::size_t size() const { return patches.size(); }
};

struct PatchOptions {
  double tolerance = 1e-3;  ///< of E's interpolation, relative
  double largestMm = 0;     ///< edge above which samples could miss a shadow
  double smallestMm = 0;    ///< edge below which borders of shadow are not refined
  std::size_t most = std::numeric_limits<std::size_t>::max();  ///< patches
  std::stop_token stop;
};

/// Divides a body's surface into patches, in the order of its triangles, whatever the number of
/// threads. Dark patches are left out. None when there would be too many patches. Throws Stopped.
std::optional<Patches> makePatches(const Geometry& geometry, const Irradiance& irradiance,
                                   std::uint32_t body, const PatchOptions& options);

}  // namespace opaline::reference
