#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "input.h"
#include "surfels/clusters.h"
#include "surfels/surfels.h"
#include "surfels/thickness.h"
#include "surfels/treelets.h"

namespace {

using namespace opaline;

/// Each object has surfels, and each surfel its pieces.
void expectWhole(const surfels::SurfelDivision& division, std::size_t triangles) {
  EXPECT_EQ(division.pieces.size(), std::size_t{division.piecesPerSurfel} * division.count());
  std::vector<double> area(triangles, 0);
  for (const surfels::Piece& piece : division.pieces)
    area.at(piece.triangle) += static_cast<double>(piece.fraction);
  for (const double part : area) EXPECT_NEAR(part, 1, 1e-5);
}

}  // namespace

// Surfels, their thickness, and clusters of them.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Input input(data, size);
  std::vector<double> spacingMm(4);
  for (double& mm : spacingMm) mm = static_cast<double>(input.magnitude());
  const std::size_t most = 1024U << input.below(4);
  const std::size_t mostClusters = 64U << input.below(5);
  const double largestMm = input.below(4) == 0 ? INFINITY : static_cast<double>(input.magnitude());
  const awkward::Shape shape = fuzz::repairedMeshFrom(input);
  if (shape.triangles.empty()) return 0;
  const core::RestSurface surface{shape.positions, shape.triangles, shape.objects};
  spacingMm.resize(*std::max_element(shape.objects.begin(), shape.objects.end()) + 1);
  const surfels::SurfelDivision division = surfels::makeSurfels(surface, spacingMm, most);
  expectWhole(division, shape.triangles.size());
  for (const double mm : surfels::thicknessMm(surface, division)) EXPECT_GE(mm, 0);
  surfels::makeTreelets(division.tree);
  const bool bothSides = input.below(2) == 0;
  const std::vector<surfels::ClusterOrder> orders(spacingMm.size(), {largestMm, bothSides});
  const surfels::ClusterDivision clusters =
      surfels::makeClusters(surface, division, orders, mostClusters);
  const std::size_t least = spacingMm.size() * (bothSides ? 2 : 1);
  EXPECT_GE(clusters.count(), least);
  EXPECT_LE(clusters.count(), std::max(mostClusters, least));
  EXPECT_EQ(clusters.clusters.back().endSurfel, division.count());
  return 0;
}
