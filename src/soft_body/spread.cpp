#include "soft_body/spread.h"

#include <Eigen/Dense>

#include <cmath>
#include <limits>

namespace opaline::soft_body {

namespace {

constexpr std::uint32_t noNode = std::numeric_limits<std::uint32_t>::max();

// Finds the node at a place of the grid.
class Lookup {
 public:
  explicit Lookup(const Cage& cage)
      : size_{static_cast<int>(cage.counts[0]) + 3, static_cast<int>(cage.counts[1]) + 3,
              static_cast<int>(cage.counts[2]) + 3},
        nodes_(static_cast<std::size_t>(size_[0]) * static_cast<std::size_t>(size_[1]) *
                   static_cast<std::size_t>(size_[2]),
               noNode) {
    for (std::uint32_t n = 0; n < cage.nodes.size(); ++n)
      nodes_[index(static_cast<int>(cage.nodes[n][0]) + 1, static_cast<int>(cage.nodes[n][1]) + 1,
                   static_cast<int>(cage.nodes[n][2]) + 1)] = n;
  }

  const std::array<int, 3>& size() const { return size_; }

  std::uint32_t at(int x, int y, int z) const {
    const bool inside = x >= 0 && y >= 0 && z >= 0 && x < size_[0] && y < size_[1] && z < size_[2];
    return inside ? nodes_[index(x, y, z)] : noNode;
  }

 private:
  std::size_t index(int x, int y, int z) const {
    return static_cast<std::size_t>(x + size_[0] * (y + size_[1] * z));
  }

  std::array<int, 3> size_;
  std::vector<std::uint32_t> nodes_;
};

struct Neighbour {
  std::uint32_t node;
  Eigen::Vector4d basis;  // 1 and the offset to it
  double weight;
};

// Nodes at most two cells away along each axis; none if no node touches the cells around the place.
std::vector<Neighbour> neighboursOf(const Lookup& lookup, int x, int y, int z) {
  std::vector<Neighbour> all;
  bool touches = false;
  for (int k = -2; k <= 2; ++k)
    for (int j = -2; j <= 2; ++j)
      for (int i = -2; i <= 2; ++i) {
        const std::uint32_t node = lookup.at(x + i, y + j, z + k);
        if (node == noNode) continue;
        touches = touches || (std::abs(i) <= 1 && std::abs(j) <= 1 && std::abs(k) <= 1);
        all.push_back({node,
                       {1, static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)},
                       std::exp(-static_cast<double>(i * i + j * j + k * k))});
      }
  if (!touches) all.clear();
  return all;
}

void carryOn(const std::vector<Neighbour>& neighbours, std::vector<SpreadPart>& parts) {
  if (neighbours.empty()) return;
  // Nodes in a plane do not determine the slope across it, which then becomes 0.
  constexpr double leastSlope = 1e-3;
  double sum = 0;
  Eigen::Matrix4d moments = Eigen::Matrix4d::Zero();
  for (const Neighbour& n : neighbours) {
    moments += n.weight * n.basis * n.basis.transpose();
    sum += n.weight;
  }
  for (int i = 1; i < 4; ++i) moments(i, i) += leastSlope * sum;
  const Eigen::Vector4d dual = moments.ldlt().solve(Eigen::Vector4d::UnitX());
  for (const Neighbour& n : neighbours)
    parts.push_back({n.node, static_cast<float>(n.weight * dual.dot(n.basis))});
}

}  // namespace

Spread makeSpread(const Cage& cage) {
  const Lookup lookup(cage);
  Spread spread;
  for (std::size_t axis = 0; axis < 3; ++axis) spread.size[axis] = cage.counts[axis] + 3;
  for (int z = 0; z < lookup.size()[2]; ++z)
    for (int y = 0; y < lookup.size()[1]; ++y)
      for (int x = 0; x < lookup.size()[0]; ++x) {
        spread.firstPart.push_back(static_cast<std::uint32_t>(spread.parts.size()));
        const std::uint32_t node = lookup.at(x, y, z);
        if (node != noNode)
          spread.parts.push_back({node, 1});
        else
          carryOn(neighboursOf(lookup, x, y, z), spread.parts);
      }
  spread.firstPart.push_back(static_cast<std::uint32_t>(spread.parts.size()));
  return spread;
}

}  // namespace opaline::soft_body
