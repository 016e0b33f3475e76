#include "reference/path/cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include "opaline/error.h"

namespace opaline::reference {

namespace {

constexpr std::size_t mostParts = 64'000'000;

/// Row and column in the triangle's grid and whether it stands on its tip. Weights 1 and 2 are the
/// coordinates.
struct Part {
  std::uint32_t row = 0;
  std::uint32_t column = 0;
  bool flipped = false;
};

std::uint32_t indexOf(const Part& part, std::uint32_t n) {
  // Row r has 2(n − r) − 1 parts.
  const std::uint32_t before = part.row * (2 * n - part.row);
  return before + 2 * part.column + (part.flipped ? 1U : 0U);
}

struct CubeKey {
  std::array<std::int32_t, 3> cube{};
  std::uint32_t side = 0;
  std::uint32_t body = 0;

  bool operator==(const CubeKey&) const = default;
};

struct CubeHash {
  std::size_t operator()(const CubeKey& key) const {
    std::uint64_t hash = (std::uint64_t{key.body} << 3U) | key.side;
    for (const std::int32_t place : key.cube)
      hash = (hash ^ static_cast<std::uint32_t>(place)) * 0x9E3779B97F4A7C15U;
    return hash ^ (hash >> 29U);
  }
};

std::uint32_t sideOf(const Vector& normal) {
  std::uint32_t axis = 0;
  for (std::uint32_t i = 1; i < 3; ++i)
    if (std::abs(normal[i]) > std::abs(normal[axis])) axis = i;
  return 2 * axis + (normal[axis] < 0 ? 1U : 0U);
}

}  // namespace

std::uint32_t Cells::partOf(std::uint32_t edgeParts, const std::array<double, 3>& weights) {
  if (edgeParts == 1) return 0;
  const auto n = static_cast<double>(edgeParts);
  const auto whole = [&](double weight) {
    return std::min(static_cast<std::uint32_t>(std::max(weight * n, 0.0)), edgeParts - 1);
  };
  Part part{whole(weights[2]), whole(weights[1]), false};
  part.column = std::min(part.column, edgeParts - 1 - part.row);
  const double along = weights[1] * n - part.column;
  const double up = weights[2] * n - part.row;
  part.flipped = along + up > 1 && part.column + part.row + 1 < edgeParts;
  return indexOf(part, edgeParts);
}

Cells::Cells(const Scene& scene, double edgeMm) {
  const Box box = boxOf(scene);
  std::unordered_map<CubeKey, std::uint32_t, CubeHash> known;
  std::uint32_t number = 0;
  for (const Body& body : scene.bodies) {
    std::vector<Division>& divisions = divisions_.emplace_back();
    for (const Triangle& t : body.triangles) {
      if (body.opaque) break;
      const Vector& a = body.positionsMm[t[0]];
      const Vector ab = body.positionsMm[t[1]] - a;
      const Vector ac = body.positionsMm[t[2]] - a;
      const double longest = std::max({length(ab), length(ac), length(ac - ab)});
      const Vector areaVector = cross(ab, ac);
      const double parts = std::max(std::ceil(2 * longest / edgeMm), 1.0);
      if (static_cast<double>(cellOfPart_.size()) + parts * parts > mostParts)
        throw Error(fmt::format(
            "cells of {:.3g} mm are too small for so large a surface; make them larger", edgeMm));
      const auto n = static_cast<std::uint32_t>(parts);
      divisions.push_back({static_cast<std::uint32_t>(cellOfPart_.size()), n});
      const double area = 0.5 * length(areaVector) / (parts * parts);
      for (std::uint32_t row = 0; row < n; ++row) {
        for (std::uint32_t k = 0; k < 2 * (n - row) - 1; ++k) {
          const double third = k % 2 == 0 ? 1.0 / 3 : 2.0 / 3;
          const std::uint32_t column = k / 2;
          const Vector middle = a + ((column + third) / parts) * ab + ((row + third) / parts) * ac;
          CubeKey key{{}, sideOf(areaVector), number};
          for (std::size_t axis = 0; axis < 3; ++axis)
            key.cube[axis] =
                static_cast<std::int32_t>(std::floor((middle[axis] - box.minMm[axis]) / edgeMm));
          const auto [cell, isNew] =
              known.try_emplace(key, static_cast<std::uint32_t>(areasMm2_.size()));
          if (isNew) areasMm2_.push_back(0);
          areasMm2_[cell->second] += area;
          cellOfPart_.push_back(cell->second);
        }
      }
    }
    ++number;
  }
}

std::size_t Cells::at(const SurfacePoint& point) const {
  const Division& division = divisions_[point.body][point.triangle];
  return cellOfPart_[division.firstPart + partOf(division.edgeParts, point.weights)];
}

}  // namespace opaline::reference
