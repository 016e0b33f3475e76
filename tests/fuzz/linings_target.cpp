#include "surfels/linings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "input.h"
#include "surfels/clusters.h"
#include "surfels/surfels.h"

namespace {

using namespace opaline;
using surfels::Substance;

/// Each is a solid's triangle, turned round, as a part of a body.
void expectTurned(const surfels::Linings& linings, const core::RestSurface& surface,
                  const std::vector<Substance>& substances) {
  const core::RestSurface lined = linings.lined(surface);
  const std::vector<std::uint32_t>& solids = linings.triangleOfSolid();
  ASSERT_EQ(linings.firstTriangle(), surface.triangles.size());
  ASSERT_EQ(lined.triangles.size(), surface.triangles.size() + solids.size());
  for (std::size_t i = 0; i < solids.size(); ++i) {
    const Triangle& solid = surface.triangles[solids[i]];
    EXPECT_EQ(substances.at(solids[i]), Substance::Solid);
    EXPECT_EQ(lined.triangles[surface.triangles.size() + i],
              (Triangle{solid[0], solid[2], solid[1]}));
  }
}

}  // namespace

// Bodies, solids and sheets, through each other.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Input input(data, size);
  std::array<Substance, 4> ofObjects{};
  for (Substance& one : ofObjects) one = static_cast<Substance>(input.below(4));
  const bool mixed = input.below(4) == 0;
  const awkward::Shape shape = fuzz::repairedMeshFrom(input);
  if (shape.triangles.empty()) return 0;
  std::vector<Substance> substances;
  for (std::size_t t = 0; t < shape.triangles.size(); ++t)
    substances.push_back(ofObjects.at((shape.objects[t] + (mixed ? t : 0)) % ofObjects.size()));
  const core::RestSurface surface{shape.positions, shape.triangles, shape.objects};
  const surfels::Linings linings(surface, substances);
  EXPECT_EQ(linings.any(), !linings.triangleOfSolid().empty());
  for (const std::uint32_t sheet : linings.sheetsInside()) EXPECT_LT(sheet, ofObjects.size());
  if (!linings.any()) return 0;
  expectTurned(linings, surface, substances);

  const core::RestSurface lined = linings.lined(surface);
  std::vector<double> area(lined.triangles.size(), 0);
  for (const surfels::Piece& piece : linings.pieces()) {
    EXPECT_GE(piece.triangle, linings.firstTriangle());
    area.at(piece.triangle) += static_cast<double>(piece.fraction);
    const surfels::Vector place = surfels::vectorOf(surfels::middleOfMm(lined, piece));
    for (const double axis : place) EXPECT_TRUE(std::isfinite(axis));
  }
  for (const double part : area) EXPECT_LT(part, 1 + 1e-5);
  for (const std::uint32_t solid : linings.triangleOfSolid()) {
    const surfels::Vector corner = surfels::vectorOf(shape.positions[shape.triangles[solid][0]]);
    for (std::uint32_t object = 0; object < ofObjects.size(); ++object)
      linings.isCovered(object, corner, {0, 0, 1});
  }

  constexpr double coarseMm = 1e30;  // not what is tested here
  const std::vector<double> spacingMm(ofObjects.size(), coarseMm);
  const std::size_t objects = 1 + *std::max_element(shape.objects.begin(), shape.objects.end());
  constexpr std::size_t most = 1U << 20;
  const surfels::SurfelDivision division =
      surfels::makeSurfels(lined, std::span(spacingMm).first(objects), most, linings);
  EXPECT_GE(division.pieces.size(), linings.pieces().size());
  constexpr std::size_t mostClusters = 256;
  const std::vector<surfels::ClusterOrder> orders(objects, {INFINITY, false});
  const surfels::ClusterDivision clusters =
      surfels::makeClusters(lined, division, orders, mostClusters);
  EXPECT_EQ(clusters.clusters.back().endSurfel, division.count());
  return 0;
}
