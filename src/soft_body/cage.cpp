#include "soft_body/cage.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include "soft_body/voxels.h"

namespace opaline::soft_body {

namespace {

constexpr std::uint32_t noNumber = std::numeric_limits<std::uint32_t>::max();

// Numbers corners in the order in which cubes first need them.
class Corners {
 public:
  explicit Corners(const Voxels& voxels)
      : wide_{voxels.counts[0] + 1, voxels.counts[1] + 1},
        numbers_(std::size_t{wide_[0]} * wide_[1] * (voxels.counts[2] + 1), noNumber) {}

  std::uint32_t number(const std::array<std::uint32_t, 3>& at, Cage& cage) {
    std::uint32_t& number = numbers_[at[0] + wide_[0] * (at[1] + std::size_t{wide_[1]} * at[2])];
    if (number == noNumber) {
      number = static_cast<std::uint32_t>(cage.nodes.size());
      cage.nodes.push_back(at);
    }
    return number;
  }

 private:
  std::array<std::uint32_t, 2> wide_;
  std::vector<std::uint32_t> numbers_;
};

Cage cageOf(const Voxels& voxels) {
  Cage cage;
  cage.originMm = voxels.originMm;
  cage.cellMm = voxels.cellMm;
  cage.counts = voxels.counts;
  Corners corners(voxels);
  for (std::uint32_t colour = 0; colour < 8; ++colour) {
    for (std::uint32_t z = colour >> 2; z < voxels.counts[2]; z += 2)
      for (std::uint32_t y = colour >> 1 & 1; y < voxels.counts[1]; y += 2)
        for (std::uint32_t x = colour & 1; x < voxels.counts[0]; x += 2) {
          if (!voxels.filled[voxels.index(x, y, z)]) continue;
          std::array<std::uint32_t, 8>& cell = cage.cells.emplace_back();
          for (std::uint32_t i = 0; i < 8; ++i)
            cell[i] = corners.number({x + (i & 1), y + (i >> 1 & 1), z + (i >> 2)}, cage);
        }
    cage.firstOfColour[colour + 1] = static_cast<std::uint32_t>(cage.cells.size());
  }
  return cage;
}

double heightMm(std::span<const Vec3> positionsMm, std::span<const Triangle> triangles) {
  float low = std::numeric_limits<float>::max();
  float high = std::numeric_limits<float>::lowest();
  for (const Triangle& triangle : triangles)
    for (const std::uint32_t v : triangle) {
      low = std::min(low, positionsMm[v][1]);
      high = std::max(high, positionsMm[v][1]);
    }
  return static_cast<double>(high) - static_cast<double>(low);
}

}  // namespace

Cage makeCage(std::span<const Vec3> positionsMm, std::span<const Triangle> triangles,
              std::uint32_t cells, double heldFraction, std::size_t maxNodes) {
  assert(cells >= 1 && maxNodes >= 8);
  Cage cage;
  for (;; --cells) {
    cage = cageOf(makeVoxels(positionsMm, triangles, cells));
    if (cage.nodes.size() <= maxNodes) break;
  }
  cage.heightCells = std::max(1.0, heightMm(positionsMm, triangles) / cage.cellMm);
  for (const auto& node : cage.nodes)
    cage.held.push_back(node[1] == 0 || node[1] <= heldFraction * cage.heightCells);
  return cage;
}

}  // namespace opaline::soft_body
