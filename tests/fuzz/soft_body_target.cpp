#include <gtest/gtest.h>

#include "input.h"
#include "loading.h"
#include "soft_body/cage.h"
#include "soft_body/dynamics.h"
#include "soft_body/spread.h"

// The cage around any mesh.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace opaline;
  fuzz::Input input(data, size);
  const std::uint32_t cells = 2 + input.below(15);
  const double held = input.below(100) / 100.0;
  const std::size_t mostNodes = 64U << input.below(8);
  const awkward::Shape shape = fuzz::repairedMeshFrom(input);
  if (shape.triangles.empty()) return 0;
  fuzz::expectReadOrRefused([&] {
    const soft_body::Cage cage =
        soft_body::makeCage(shape.positions, shape.triangles, cells, held, mostNodes);
    EXPECT_LE(cage.nodes.size(), mostNodes);
    EXPECT_EQ(cage.held.size(), cage.nodes.size());
    for (const auto& cell : cage.cells)
      for (const std::uint32_t node : cell) EXPECT_LT(node, cage.nodes.size());
    for (const soft_body::SpreadPart& part : soft_body::makeSpread(cage).parts)
      EXPECT_TRUE(std::isfinite(part.weight));
    EXPECT_GT(soft_body::makeDynamics(cage, 3, 0.5).substepSeconds, 0);
  });
  return 0;
}
