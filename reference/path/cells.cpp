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
constexpr double mostPartsOfGround = 16;  // along the edge of a triangle

/// A part's row and column in the triangle's grid, and whether it is upside down. Weights 1 and 2
/// are the coordinates.
struct PlaceOfPart {
  std::uint32_t row = 0;
  std::uint32_t column = 0;
  bool flipped = false;
};

std::uint32_t indexOf(const PlaceOfPart& part, std::uint32_t n) {
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

// Weights 1 and 2 of the middle of the k-th part in a row.
std::array<double, 2> middleOfPart(std::uint32_t row, std::uint32_t k, double parts) {
  const double third = k % 2 == 0 ? 1.0 / 3 : 2.0 / 3;
  return {(k / 2 + third) / parts, (row + third) / parts};
}

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
  PlaceOfPart part{whole(weights[2]), whole(weights[1]), false};
  part.column = std::min(part.column, edgeParts - 1 - part.row);
  const double along = weights[1] * n - part.column;
  const double up = weights[2] * n - part.row;
  part.flipped = along + up > 1 && part.column + part.row + 1 < edgeParts;
  return indexOf(part, edgeParts);
}

Cells::Cells(const Scene& scene, double edgeMm, Of of) {
  const Box box = boxOf(scene);
  std::unordered_map<CubeKey, std::uint32_t, CubeHash> known;
  std::uint32_t number = 0;
  for (const Body& body : scene.bodies) {
    std::vector<Division>& divisions = divisions_.emplace_back();
    for (const Triangle& t : body.triangles) {
      if (body.opaque.has_value() != (of == Of::Opaque)) break;
      const Vector& a = body.positionsMm[t[0]];
      const Vector ab = body.positionsMm[t[1]] - a;
      const Vector ac = body.positionsMm[t[2]] - a;
      const double longest = std::max({length(ab), length(ac), length(ac - ab)});
      const Vector areaVector = cross(ab, ac);
      const double wanted = std::max(std::ceil(2 * longest / edgeMm), 1.0);
      const double parts = body.isGround ? std::min(wanted, mostPartsOfGround) : wanted;
      if (static_cast<double>(cellOfPart_.size()) + parts * parts > mostParts)
        throw Error(fmt::format(
            "cells of {:.3g} mm are too small for so large a surface; make them larger", edgeMm));
      const auto n = static_cast<std::uint32_t>(parts);
      divisions.push_back({static_cast<std::uint32_t>(cellOfPart_.size()), n});
      const double area = 0.5 * length(areaVector) / (parts * parts);
      for (std::uint32_t row = 0; row < n; ++row) {
        for (std::uint32_t k = 0; k < 2 * (n - row) - 1; ++k) {
          const auto [along, up] = middleOfPart(row, k, parts);
          const Vector middle = a + along * ab + up * ac;
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

void Cells::forEachPart(const Scene& scene, const std::function<void(const Part&)>& visit) const {
  for (std::size_t number = 0; number < scene.bodies.size(); ++number) {
    const Body& body = scene.bodies[number];
    for (std::size_t t = 0; t < divisions_[number].size(); ++t) {
      const Triangle& corners = body.triangles[t];
      const Division& division = divisions_[number][t];
      const Vector& a = body.positionsMm[corners[0]];
      const Vector ab = body.positionsMm[corners[1]] - a;
      const Vector ac = body.positionsMm[corners[2]] - a;
      const Vector areaVector = cross(ab, ac);
      const double parts = division.edgeParts;
      Part part{
          0, number, 0.5 * length(areaVector) / (parts * parts), {}, unitOr(areaVector, {0, 0, 1})};
      std::uint32_t next = division.firstPart;
      for (std::uint32_t row = 0; row < division.edgeParts; ++row) {
        for (std::uint32_t k = 0; k < 2 * (division.edgeParts - row) - 1; ++k) {
          const auto [along, up] = middleOfPart(row, k, parts);
          part.middleMm = a + along * ab + up * ac;
          part.cell = cellOfPart_[next++];
          visit(part);
        }
      }
    }
  }
}

}  // namespace opaline::reference
