#include "surfels/layers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "core/disjoint_sets.h"
#include "core/equal_positions.h"
#include "surfels/vector.h"

namespace opaline::surfels {

namespace {

// Area of the smallest part that is told from others, in closeMm²: that of a few clusters.
constexpr double leastArea = 4;

// The most parts that are told apart in one cell of the grid.
constexpr std::size_t mostPartsOfCell = 16;

// Each pair in both orders.
using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

using Cell = std::array<std::int64_t, 3>;

struct HashOfCell {
  std::size_t operator()(const Cell& cell) const {
    std::uint64_t hash = 0;
    for (const std::int64_t at : cell)
      hash = (hash ^ static_cast<std::uint64_t>(at)) * 0x9E3779B97F4A7C15U;
    return static_cast<std::size_t>(hash ^ (hash >> 32U));
  }
};

// A part of the surface that faces one of six ways.
struct Facing {
  std::uint32_t part = 0;
  std::uint8_t way = 0;

  bool operator==(const Facing&) const = default;
};

// The axis to which a normal is closest, and its sign.
std::uint8_t wayOf(const Vector& normal) {
  std::uint8_t way = 0;
  double most = -1;
  for (std::uint8_t axis = 0; axis < 3; ++axis) {
    if (std::abs(normal[axis]) <= most) continue;
    most = std::abs(normal[axis]);
    way = static_cast<std::uint8_t>(2 * axis + (normal[axis] < 0 ? 1 : 0));
  }
  return way;
}

// What lies where, in cells as wide as parts are close.
class Grid {
 public:
  explicit Grid(double edgeMm) : edgeMm_(edgeMm) {}

  void add(const Vec3& placeMm, const Facing& facing) {
    std::vector<Facing>& here = cells_[cellOf(placeMm)];
    if (here.size() < mostPartsOfCell && std::find(here.begin(), here.end(), facing) == here.end())
      here.push_back(facing);
  }

  // Pairs of parts that face the same way in one cell or in neighbouring ones.
  Pairs neighbours() const {
    Pairs pairs;
    for (const auto& [cell, facings] : cells_) {
      for (std::int64_t step = 0; step < 27; ++step) {
        const auto other = cells_.find(
            {cell[0] + step % 3 - 1, cell[1] + step / 3 % 3 - 1, cell[2] + step / 9 - 1});
        if (other == cells_.end()) continue;
        for (const Facing& a : facings)
          for (const Facing& b : other->second)
            if (a.part != b.part && a.way == b.way) pairs.insert({a.part, b.part});
      }
    }
    return pairs;
  }

 private:
  Cell cellOf(const Vec3& placeMm) const {
    Cell cell{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      cell[axis] = std::llround(static_cast<double>(placeMm[axis]) / edgeMm_);
    return cell;
  }

  double edgeMm_;
  std::unordered_map<Cell, std::vector<Facing>, HashOfCell> cells_;
};

// Gives each part, one after the other, the first number that no neighbour has; 0 if none is left.
std::unordered_map<std::uint32_t, std::uint8_t> numbered(const std::vector<std::uint32_t>& parts,
                                                         const Pairs& neighbours) {
  std::unordered_map<std::uint32_t, std::uint8_t> numbers;
  for (const std::uint32_t part : parts) {
    std::array<bool, Layers::mostLayers> taken{};
    for (auto pair = neighbours.lower_bound({part, 0});
         pair != neighbours.end() && pair->first == part; ++pair)
      if (const auto other = numbers.find(pair->second); other != numbers.end())
        taken[other->second] = true;
    const auto free = std::find(taken.begin(), taken.end(), false) - taken.begin();
    numbers[part] = free < Layers::mostLayers ? static_cast<std::uint8_t>(free) : std::uint8_t{0};
  }
  return numbers;
}

}  // namespace

Layers::Layers(const core::RestSurface& surface) : surface_(surface) {
  const std::vector<std::uint32_t> points = core::equalPositions(surface.positionsMm);
  core::DisjointSets parts(points.size());
  for (const Triangle& triangle : surface.triangles)
    for (std::size_t corner = 1; corner < 3; ++corner)
      parts.join(points[triangle[0]], points[triangle[corner]]);
  partOfTriangle_.reserve(surface.triangles.size());
  for (const Triangle& triangle : surface.triangles)
    partOfTriangle_.push_back(parts.find(points[triangle[0]]));
}

std::vector<std::uint32_t> Layers::largestFirst(std::span<const Piece> pieces,
                                                std::span<const TreeItem> items,
                                                double leastMm2) const {
  std::unordered_map<std::uint32_t, double> areaOfPart;
  for (const TreeItem& item : items) {
    const Piece& piece = pieces[item.index];
    areaOfPart[partOf(piece)] += areaMm2(surface_, piece);
  }
  std::vector<std::pair<double, std::uint32_t>> sorted;
  for (const auto& [part, area] : areaOfPart)
    if (area >= leastMm2) sorted.emplace_back(-area, part);
  std::sort(sorted.begin(), sorted.end());
  std::vector<std::uint32_t> parts;
  parts.reserve(sorted.size());
  for (const auto& [area, part] : sorted) parts.push_back(part);
  return parts;
}

std::vector<std::uint8_t> Layers::ofItems(std::span<const Piece> pieces,
                                          std::span<const TreeItem> items, double closeMm) const {
  std::vector<std::uint8_t> layers(items.size(), 0);
  if (!(closeMm > 0)) return layers;
  const std::vector<std::uint32_t> parts =
      largestFirst(pieces, items, leastArea * closeMm * closeMm);
  if (parts.size() < 2) return layers;

  const std::unordered_set<std::uint32_t> isLarge(parts.begin(), parts.end());
  Grid grid(closeMm);
  for (const TreeItem& item : items) {
    const Piece& piece = pieces[item.index];
    if (isLarge.contains(partOf(piece)))
      grid.add(item.placeMm, {partOf(piece), wayOf(crossOf(surface_, piece.triangle))});
  }

  const auto layerOfPart = numbered(parts, grid.neighbours());
  for (std::size_t i = 0; i < items.size(); ++i)
    if (const auto found = layerOfPart.find(partOf(pieces[items[i].index]));
        found != layerOfPart.end())
      layers[i] = found->second;
  return layers;
}

}  // namespace opaline::surfels
