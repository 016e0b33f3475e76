#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "renderer/renderer_fixture.h"
#include "renderer/shapes.h"
#include "renderer/sums.h"

namespace opaline::test {

/// Uses fewer sources than usual, since most of the time is spent summing over them.
inline RenderOptions boundaryOptions(int edge, int bounces = 0) {
  RenderOptions options = finelyDivided(smallOptions());
  options.width = options.height = edge;
  options.transport = Transport::Boundary;
  options.bounces = bounces;
  options.maxSurfels = 16'384;
  return options;
}

inline RenderResult renderBoundary(const Scene& scene, const RenderOptions& options,
                                   const std::vector<Aov>& aovs) {
  sharedRenderer().renderer->setScene(scene);
  return sharedRenderer().renderer->render(options, aovs);
}

/// A star-shaped body around the origin, given by its radius in each direction.
template <typename RadiusMm>
Mesh starShaped(const RadiusMm& radiusMm, int levels) {
  Mesh mesh = sphere({0, 0, 0}, 1, levels);
  std::vector<Vector> normals(mesh.positionsMm.size(), Vector{});
  for (Vec3& position : mesh.positionsMm) {
    const Vector direction = unit(toVector(position));
    position = toVec3(radiusMm(direction) * direction);
  }
  for (const Triangle& t : mesh.triangles) {
    const Vector a = toVector(mesh.positionsMm[t[0]]);
    const Vector area =
        cross(toVector(mesh.positionsMm[t[1]]) - a, toVector(mesh.positionsMm[t[2]]) - a);
    for (const std::uint32_t corner : t) normals[corner] = normals[corner] + area;
  }
  for (std::size_t i = 0; i < normals.size(); ++i) mesh.normals[i] = toVec3(unit(normals[i]));
  return mesh;
}

/// Two lobes along y with a waist half as wide as a lobe between them.
inline Mesh peanut(double lengthMm, int levels = 4) {
  return starShaped([&](const Vector& d) { return lengthMm / 2 * (0.25 + 0.75 * d[1] * d[1]); },
                    levels);
}

/// A ball around the origin with a hollow: the intersection with another ball is removed. Its
/// middle is 1.1 radii towards +z, its radius ¾ as large.
struct Bowl {
  double radiusMm;

  double hollowRadiusMm() const { return 0.75 * radiusMm; }
  double hollowCentreMm() const { return 1.1 * radiusMm; }
  double bottomMm() const { return hollowCentreMm() - hollowRadiusMm(); }
  /// The radius at which the two spheres meet.
  double rimMm() const {
    const double c = hollowCentreMm();
    const double h = hollowRadiusMm();
    return (radiusMm * radiusMm + c * c - h * h) / (2 * c);
  }
  double rimRadiusMm() const { return std::sqrt(radiusMm * radiusMm - rimMm() * rimMm()); }

  Mesh mesh(int levels = 4) const {
    return starShaped(
        [this](const Vector& d) {
          const double along = hollowCentreMm() * d[2];
          const double squared = along * along - hollowCentreMm() * hollowCentreMm() +
                                 hollowRadiusMm() * hollowRadiusMm();
          if (d[2] < 0 || squared < 0) return radiusMm;
          return std::min(radiusMm, along - std::sqrt(squared));
        },
        levels);
  }
};

/// A sphere around the origin, seen from +z, with a different medium in each channel.
inline Scene ballOf(float radiusMm, const Medium& medium, int levels = 4) {
  return sceneOf(sphere({0, 0, 0}, radiusMm, levels), medium, {0, 0, 4 * radiusMm},
                 1.02F * radiusMm);
}

/// Exitance in bands of equal area by the cosine to +x, from the far side to the near side. The
/// ball is rotated about the x axis, so that all bands are visible from +z.
template <std::size_t bands>
std::array<std::array<double, 3>, bands> exitanceOfBands(const Image& exitance,
                                                         const Image& position,
                                                         const Vec3& cameraMm) {
  std::array<std::array<double, 3>, bands> sums{};
  std::array<double, bands> areas{};
  forEachCovered(exitance, [&](std::size_t i) {
    const Vector at = toVector(&position.rgba[i]);
    const Vector outward = unit(at);
    const Vector toCamera = toVector(cameraMm) - at;
    const double seen = dot(outward, unit(toCamera));
    if (seen < 0.1) return;
    // The ball's area within the pixel, up to a factor.
    const double axial = dot(unit(toCamera), unit(toVector(cameraMm)));
    const double area = dot(toCamera, toCamera) * std::pow(axial, 3) / seen;
    const auto band = static_cast<std::size_t>(
        std::clamp((outward[0] + 1) / 2 * static_cast<double>(bands), 0.0, bands - 0.5));
    areas[band] += area;
    for (std::size_t c = 0; c < 3; ++c)
      sums[band][c] += area * static_cast<double>(exitance.rgba[i + c]);
  });
  for (std::size_t band = 0; band < bands; ++band) {
    EXPECT_GT(areas[band], 0);
    for (double& sum : sums[band]) sum /= areas[band];
  }
  return sums;
}

/// Mean over the pixels for whose place `counts` is true.
template <typename Counts>
std::array<double, 3> meanWhere(const Image& image, const Image& position, const Counts& counts) {
  std::array<double, 3> sum{};
  int count = 0;
  forEachCovered(image, [&](std::size_t i) {
    if (!counts(toVector(&position.rgba[i]))) return;
    ++count;
    for (std::size_t c = 0; c < 3; ++c) sum[c] += static_cast<double>(image.rgba[i + c]);
  });
  EXPECT_GT(count, 0);
  for (double& value : sum) value /= std::max(count, 1);
  return sum;
}

}  // namespace opaline::test
