#include "film/kept_positions.h"

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <string>

#include "core/temporary_folder.h"
#include "film/framing.h"
#include "film/sequence_frames.h"

namespace opaline::app {
namespace {

TEST(KeptPositions, AreTakenOnceAndKeepToTheirMemory) {
  KeptPositions kept(3 * sizeof(Vec3));
  kept.keep(1, {{1, 2, 3}, {4, 5, 6}});
  kept.keep(2, {{7, 8, 9}, {7, 8, 9}});
  kept.keep(3, {{0, 0, 0}});
  std::vector<Vec3> positionsMm;
  EXPECT_FALSE(kept.take(2, positionsMm)) << "there was no room";
  EXPECT_TRUE(kept.take(1, positionsMm));
  EXPECT_EQ(positionsMm, (std::vector<Vec3>{{1, 2, 3}, {4, 5, 6}}));
  EXPECT_FALSE(kept.take(1, positionsMm));
  kept.keep(2, {{7, 8, 9}, {7, 8, 9}});
  EXPECT_TRUE(kept.take(2, positionsMm)) << "there is room again";
}

// Of the files that the camera was placed by, none is needed again.
TEST(KeptPositions, AFilmReadsEachOfItsFilesOnce) {
  const test::TemporaryFolder folder;
  constexpr int count = 4;
  const auto file = [&](int number) { return folder / ("f" + std::to_string(number) + ".obj"); };
  for (int number = 0; number < count; ++number) {
    const std::string x = std::to_string(number);
    std::ofstream(file(number)) << "v " << x << " 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\n"
                                << "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  }
  const auto sequence = std::make_shared<const MeshSequence>(folder / "f%d.obj");
  std::map<int, std::vector<Vec3>> expected;
  for (int number = 0; number < count; ++number) sequence->read(number, expected[number]);

  const auto kept = std::make_shared<KeptPositions>();
  Scene scene = sequence->scene();
  showAll(scene, {0, 1, sequence.get(), momentsOf({0, count - 1, 30}, sequence.get()), kept.get()});
  for (int number = 0; number < count; ++number) std::filesystem::remove(file(number));
  PositionsAhead positions = positionsOf(sequence, count - 1, 1, kept);
  for (int number = 0; number < count; ++number) EXPECT_EQ(positions.of(number), expected[number]);
}

}  // namespace
}  // namespace opaline::app
