// One model as compressed by other programs: gltfpack and glTF-Transform.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "opaline/scene.h"
#include "scene/shapes.h"
#include "shared_files.h"

namespace opaline {
namespace {

std::optional<std::filesystem::path> compressedModel(const std::string& name) {
  return test::sharedModel("../extensions/" + name);
}

constexpr const char* notHere =
    "the compressed models are not here; set OPALINE_MODELS to the folder beside theirs";

std::vector<Vec3> sortedPositions(const Scene& scene) {
  std::vector<Vec3> all;
  for (const Object& object : scene.objects) {
    all.insert(all.end(), object.mesh.positionsMm.begin(), object.mesh.positionsMm.end());
  }
  std::sort(all.begin(), all.end());
  return all;
}

/// The largest distance from a point to the nearest of the others; infinite if beyond `reach`.
double farthest(const std::vector<Vec3>& from, const std::vector<Vec3>& sorted, float reach) {
  double largest = 0;
  for (const Vec3& p : from) {
    double nearest = INFINITY;
    auto q = std::lower_bound(sorted.begin(), sorted.end(), Vec3{p[0] - reach, 0, 0},
                              [](const Vec3& a, const Vec3& b) { return a[0] < b[0]; });
    for (; q != sorted.end() && (*q)[0] <= p[0] + reach; ++q) {
      nearest = std::min(nearest, std::hypot(double{p[0]} - (*q)[0], double{p[1]} - (*q)[1],
                                             double{p[2]} - (*q)[2]));
    }
    largest = std::max(largest, nearest);
  }
  return largest;
}

struct Expected {
  const char* name;
  const char* file;
  double stepMm;           ///< of quantized positions
  double mostSteps = 0.5;  ///< most by which a coordinate is off
};

// The original body is 1610.88 mm high. In the first two files it spans from 305 to 16078, in the
// third from -30323 to 32767 in multiples of 4. In the last, Draco has 14 bits for that height.
const Expected compressed[] = {
    {"EXT_meshopt", "Figure_meshopt.glb", 1610.88 / (16078 - 305)},
    {"KHR_meshopt", "Figure_meshopt_khr.glb", 1610.88 / (16078 - 305)},
    {"quantized", "Figure_quantized.glb", 4 * 1610.88 / (32767 + 30323), 1},
    {"Draco", "Figure_draco.glb", 1610.88 / ((1 << 14) - 1)},
};

class CompressedModels : public testing::TestWithParam<Expected> {};

TEST_P(CompressedModels, HaveThePositionsOfTheOriginal) {
  const auto file = compressedModel(GetParam().file);
  const auto original = test::sharedModel("materials/Figure.glb");
  if (!file || !original) GTEST_SKIP() << notHere;
  const Scene scene = loadScene(*file);
  test::expectSound(scene);
  std::size_t triangles = 0;
  for (const Object& object : scene.objects) triangles += object.mesh.triangles.size();
  EXPECT_EQ(triangles, 33444U);  // by the models' own README
  EXPECT_EQ(scene.clips.size(), 3U);
  const std::vector<Vec3> ours = sortedPositions(scene);
  const std::vector<Vec3> theirs = sortedPositions(loadScene(*original));
  // Along all three axes, plus rounding to 32 bits.
  const double most = std::sqrt(3.0) * GetParam().mostSteps * GetParam().stepMm + 1e-3;
  EXPECT_LE(farthest(ours, theirs, 1), most);
  EXPECT_LE(farthest(theirs, ours, 1), most);
}

INSTANTIATE_TEST_SUITE_P(Figure, CompressedModels, testing::ValuesIn(compressed),
                         [](const auto& of) { return std::string(of.param.name); });

// The same data in both extensions; the second has the newer codec for attributes.
TEST(CompressedModels, MeshoptExtensionsAgreeInEveryBit) {
  const auto ext = compressedModel("Figure_meshopt.glb");
  const auto khr = compressedModel("Figure_meshopt_khr.glb");
  if (!ext || !khr) GTEST_SKIP() << notHere;
  const Scene older = loadScene(*ext);
  const Scene newer = loadScene(*khr);
  ASSERT_EQ(older.objects.size(), newer.objects.size());
  for (std::size_t i = 0; i < older.objects.size(); ++i) {
    EXPECT_EQ(older.objects[i].mesh.positionsMm, newer.objects[i].mesh.positionsMm);
    EXPECT_EQ(older.objects[i].mesh.normals, newer.objects[i].mesh.normals);
    EXPECT_EQ(older.objects[i].mesh.triangles, newer.objects[i].mesh.triangles);
  }
  ASSERT_EQ(older.clips.size(), newer.clips.size());
  for (std::size_t c = 0; c < older.clips.size(); ++c) {
    ASSERT_EQ(older.clips[c].tracks.size(), newer.clips[c].tracks.size());
    for (std::size_t t = 0; t < older.clips[c].tracks.size(); ++t) {
      EXPECT_EQ(older.clips[c].tracks[t].seconds, newer.clips[c].tracks[t].seconds);
      EXPECT_EQ(older.clips[c].tracks[t].values, newer.clips[c].tracks[t].values);
    }
  }
}

}  // namespace
}  // namespace opaline
