#include "renderer/scene/background_divider.h"

#include <gtest/gtest.h>

#include <optional>

#include "icosphere.h"

namespace opaline {
namespace {

scene::MergedMesh ball() {
  const test::Icosphere sphere = test::icosphere(3);
  scene::MergedMesh merged;
  for (const auto& d : sphere.directions)
    merged.positionsMm.push_back({static_cast<float>(10 * d[0]), static_cast<float>(10 * d[1]),
                                  static_cast<float>(10 * d[2])});
  merged.triangles.assign(sphere.triangles.begin(), sphere.triangles.end());
  merged.objectOfTriangle.assign(merged.triangles.size(), 0);
  merged.bodyOfTriangle = merged.objectOfTriangle;
  merged.bodyOfObject = merged.firstObjectOfBody = {0};
  return merged;
}

const Within nothingWithin;

DivisionOrder orderOf(int number) {
  return {.spacingOfBodyMm = {1 + 0.2 * number},
          .clustersOfBody = {{4.0}},
          .maxSurfels = 4096,
          .maxClusters = 256};
}

void expectSame(const Division& a, const Division& b) {
  EXPECT_EQ(a.order, b.order);
  EXPECT_EQ(a.surfels.count(), b.surfels.count());
  EXPECT_EQ(a.clusters->count(), b.clusters->count());
}

TEST(BackgroundDivider, GivesThePatientWhatWasWantedLast) {
  const scene::MergedMesh merged = ball();
  BackgroundDivider divider;
  for (int i = 0; i < 20; ++i) {
    divider.want(orderOf(i), merged, nothingWithin);
    if (const auto early = divider.take(false)) expectSame(*early, divide(merged, early->order));
  }
  const std::optional<Division> last = divider.take(true);
  ASSERT_TRUE(last);
  expectSame(*last, divide(merged, orderOf(19)));
  EXPECT_FALSE(divider.take(true));
}

TEST(BackgroundDivider, ForgetsASurfaceBeforeItGoes) {
  BackgroundDivider divider;
  for (int i = 0; i < 10; ++i) {
    const scene::MergedMesh merged = ball();
    divider.want(orderOf(i), merged, nothingWithin);
    divider.want(orderOf(i + 1), merged, nothingWithin);
    divider.forget();
    EXPECT_FALSE(divider.take(true));
  }
}

}  // namespace
}  // namespace opaline
