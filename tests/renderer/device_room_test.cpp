// What fits on a device, and the messages about the rest, with the limits of imaginary devices.

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "opaline/error.h"
#include "renderer/scene/device_room.h"
#include "renderer/scene/division.h"
#include "renderer/shapes.h"

namespace opaline {
namespace {

using namespace test;

DeviceRoom roomWith(std::uint32_t bytes, std::uint32_t texels = UINT32_MAX) {
  VkPhysicalDeviceLimits limits{};
  limits.maxStorageBufferRange = bytes;
  limits.maxTexelBufferElements = texels;
  return roomOf(limits);
}

TEST(DeviceRoomTest, FollowsTheSmallerLimit) {
  // 128 MiB hold three corners of 16 bytes, three sources of 32, and 33 points of light of 48.
  constexpr std::uint32_t bytes = 1U << 27U;
  const DeviceRoom room = roomWith(bytes);
  EXPECT_EQ(room.triangles, bytes / 48);
  EXPECT_EQ(room.surfels, bytes / 96);
  EXPECT_EQ(room.clusters, bytes / (33 * 48));
  const DeviceRoom ofTexels = roomWith(bytes, bytes / 32);
  EXPECT_EQ(ofTexels.triangles, bytes / 96);
  EXPECT_EQ(ofTexels.surfels, bytes / 192);
}

TEST(DeviceRoomTest, TooManyTrianglesAreRefusedWithACure) {
  const DeviceRoom room = roomWith(48'000);
  EXPECT_NO_THROW(requireRoom(1000, room, "a device"));
  try {
    requireRoom(1001, room, "a device");
    FAIL() << "more triangles than there is room for";
  } catch (const Error& error) {
    const std::string said = error.what();
    for (const char* part : {"1001 triangles", "a device", "1000;", "simplify"})
      EXPECT_NE(said.find(part), std::string::npos) << said;
  }
}

std::vector<std::string> notesOf(const Division& division, const DeviceRoom& room) {
  std::vector<std::string> notes;
  noteCoarseness(division, room,
                 [&](LogLevel, std::string_view message) { notes.emplace_back(message); });
  return notes;
}

TEST(DeviceRoomTest, ABudgetThatFillsTheDeviceIsNotToBeRaised) {
  constexpr std::size_t surfels = 1024;
  constexpr std::size_t clusters = 64;
  Scene scene = sceneOf(sphere({0, 0, 0}, 6, 3), marble(), {0, 3, 24}, 7);
  const scene::MergedMesh merged = scene::mergedMesh(scene);
  const Division division =
      divide(merged, divisionFor(scene, merged, {{true}, {false}}, surfels, clusters));
  const std::vector<std::string> full = notesOf(division, {10'000, surfels, clusters});
  const std::vector<std::string> more = notesOf(division, {10'000, 2 * surfels, 2 * clusters});
  ASSERT_EQ(full.size(), 2U);
  ASSERT_EQ(more.size(), 2U);
  EXPECT_LE(division.surfels.count(), surfels);
  EXPECT_LE(division.clusters->count(), clusters);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NE(full[i].find("no room for more"), std::string::npos) << full[i];
    EXPECT_NE(more[i].find("raise RenderOptions::max"), std::string::npos) << more[i];
  }
}

}  // namespace
}  // namespace opaline
