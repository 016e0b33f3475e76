#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "gpu/command_list.h"
#include "gpu/gpu_fixture.h"
#include "gpu/helpers.h"
#include "gpu/pipeline.h"
#include "gpu/transfer.h"
#include "shaders/colors.frag.h"
#include "shaders/triangles.vert.h"
#include "shaders/two_targets.frag.h"

namespace opaline::gpu {
namespace {

constexpr std::uint32_t side = 16;
constexpr VkFormat color32 = VK_FORMAT_R32G32B32A32_SFLOAT;
constexpr VkFormat depth32 = VK_FORMAT_D32_SFLOAT;

using Color = std::array<float, 4>;
struct Vertex {
  std::array<float, 4> position;
  Color color;
};

constexpr Color red{1, 0, 0, 1};
constexpr Color green{0, 2, 0, 1};
constexpr Color none{0, 0, 0, 0};

/// A triangle that covers the upper left half of the picture, as seen: corners at the upper left,
/// the lower left and the upper right, in this order counter-clockwise as seen on the screen.
std::vector<Vertex> upperLeft(float depth, Color color) {
  return {{{-1, -1, depth, 1}, color}, {{-1, 1, depth, 1}, color}, {{1, -1, depth, 1}, color}};
}

std::vector<Vertex> everywhere(float depth, Color color) {
  return {{{-1, -1, depth, 1}, color}, {{-1, 3, depth, 1}, color}, {{3, -1, depth, 1}, color}};
}

using Triangles = Graphics<shaders::TrianglesVert, shaders::ColorsFrag>;

class GraphicsTest : public GpuTest {
 protected:
  static GpuImage image(const char* name, VkFormat format) {
    ImageOptions options;
    options.name = name;
    options.width = side;
    options.height = side;
    options.format = format;
    options.usage = VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
    options.usage |= format == depth32 ? VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT
                                       : VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
    return {device(), options};
  }

  static Buffer vertices(const std::vector<Vertex>& triangles) {
    return makeBuffer(device(), "vertices", triangles, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
  }

  static std::vector<Color> colors(GpuImage& image) { return readAs<Color>(device(), image, 16); }
};

Color at(const std::vector<Color>& colors, std::uint32_t x, std::uint32_t y) {
  return colors.at(std::size_t{y} * side + x);
}

TEST_F(GraphicsTest, TriangleLandsWhereItBelongsInColorAndDepth) {
  GpuImage color = image("color", color32);
  GpuImage depth = image("depth", depth32);
  Buffer triangle = vertices(upperLeft(0.25F, green));
  GraphicsOptions pipelineOptions{.colorFormats = {color32}};
  pipelineOptions.depthFormat = depth32;
  pipelineOptions.depth = DepthMode::Write;
  const Triangles pipeline(device(), "triangles", pipelineOptions);
  CommandList list(device(), "frame");
  list.begin();
  list.bind(pipeline, {.vertices = triangle}, {});
  const DepthTarget depthTarget{&depth};
  list.beginRendering({ColorTarget{&color}}, &depthTarget);
  list.draw(3);
  list.endRendering();
  list.submit();
  const auto seen = colors(color);
  const auto depths = readAs<float>(device(), depth, 4);
  for (std::uint32_t y = 0; y < side; ++y) {
    for (std::uint32_t x = 0; x < side; ++x) {
      if (x + y + 1 == side) continue;  // centres on the edge
      const bool inside = x + y + 1 < side;
      EXPECT_EQ(at(seen, x, y), inside ? green : none) << x << ' ' << y;
      EXPECT_EQ(depths[std::size_t{y} * side + x], inside ? 0.25F : 0.0F) << x << ' ' << y;
    }
  }
}

TEST_F(GraphicsTest, FrontIsCounterClockwiseAsSeen) {
  struct Case {
    CullMode cull;
    bool counterClockwiseIsDrawn;
    bool clockwiseIsDrawn;
  };
  // Row 0 of the picture is the upper one, so upperLeft() runs down the left side first.
  std::vector<Vertex> clockwise = upperLeft(0.5F, red);
  std::swap(clockwise[1], clockwise[2]);
  Buffer counterClockwiseBuffer = vertices(upperLeft(0.5F, red));
  Buffer clockwiseBuffer = vertices(clockwise);
  for (const Case& row : {Case{CullMode::None, true, true}, Case{CullMode::Back, true, false},
                          Case{CullMode::Front, false, true}}) {
    GraphicsOptions pipelineOptions{.colorFormats = {color32}};
    pipelineOptions.cull = row.cull;
    const Triangles pipeline(device(), "triangles", pipelineOptions);
    const auto isDrawn = [&](Buffer& triangle) {
      GpuImage color = image("color", color32);
      CommandList list(device(), "frame");
      list.begin();
      list.bind(pipeline, {.vertices = triangle}, {});
      list.beginRendering({ColorTarget{&color}});
      list.draw(3);
      list.endRendering();
      list.submit();
      return at(colors(color), 1, 1) == red;
    };
    const int which = static_cast<int>(row.cull);
    EXPECT_EQ(isDrawn(counterClockwiseBuffer), row.counterClockwiseIsDrawn) << which;
    EXPECT_EQ(isDrawn(clockwiseBuffer), row.clockwiseIsDrawn) << which;
  }
}

// Reversed depth: the larger value is nearer. One full-screen triangle is laid down at 0.5, then
// another one comes at the given depth.
TEST_F(GraphicsTest, DepthModesCompareAndWriteAsTheyAreNamed) {
  struct Case {
    DepthMode mode;
    float depth;
    bool isSeen;
    float depthAfter;
  };
  const Case cases[] = {
      {DepthMode::Write, 0.75F, true, 0.75F},     {DepthMode::Write, 0.5F, false, 0.5F},
      {DepthMode::Write, 0.25F, false, 0.5F},     {DepthMode::Test, 0.75F, true, 0.5F},
      {DepthMode::Test, 0.5F, true, 0.5F},        {DepthMode::Test, 0.25F, false, 0.5F},
      {DepthMode::TestEqual, 0.75F, false, 0.5F}, {DepthMode::TestEqual, 0.5F, true, 0.5F},
      {DepthMode::TestEqual, 0.25F, false, 0.5F}, {DepthMode::Off, 0.25F, true, 0.5F},
  };
  GraphicsOptions firstOptions{.colorFormats = {color32}};
  firstOptions.depthFormat = depth32;
  firstOptions.depth = DepthMode::Write;
  const Triangles first(device(), "triangles", firstOptions);
  Buffer ground = vertices(everywhere(0.5F, red));
  GpuImage color = image("color", color32);
  GpuImage depth = image("depth", depth32);
  CommandList list(device(), "frame");
  for (const Case& row : cases) {
    GraphicsOptions secondOptions = firstOptions;
    secondOptions.depth = row.mode;
    const Triangles second(device(), "triangles", secondOptions);
    Buffer cover = vertices(everywhere(row.depth, green));
    list.begin();
    list.bind(first, {.vertices = ground}, {});
    const DepthTarget cleared{&depth};
    list.beginRendering({ColorTarget{&color}}, &cleared);
    list.draw(3);
    list.endRendering();
    list.bind(second, {.vertices = cover}, {});
    DepthTarget kept{&depth};
    kept.clear = false;
    kept.write = row.mode == DepthMode::Write;
    ColorTarget colorKept{&color};
    colorKept.clear = false;
    list.beginRendering({colorKept}, &kept);
    list.draw(3);
    list.endRendering();
    list.submit();
    const int which = static_cast<int>(row.mode);
    EXPECT_EQ(at(colors(color), 5, 5), row.isSeen ? green : red) << which << ' ' << row.depth;
    EXPECT_EQ(readAs<float>(device(), depth, 4)[0], row.depthAfter) << which << ' ' << row.depth;
  }
}

TEST_F(GraphicsTest, SeveralTargetsHaveTheirOwnClearValuesAndOutputs) {
  const Graphics<shaders::TrianglesVert, shaders::TwoTargetsFrag> pipeline(
      device(), "two targets", {.colorFormats = {color32, VK_FORMAT_R32G32_SFLOAT}},
      {.scale = 3.0F});
  Buffer triangle = vertices(upperLeft(0, Color{0.5F, 0.25F, 0, 1}));
  GpuImage first = image("first", color32);
  GpuImage second = image("second", VK_FORMAT_R32G32_SFLOAT);
  CommandList list(device(), "frame");
  list.begin();
  list.bind(pipeline, {.vertices = triangle}, {});
  const ColorTarget targets[] = {{&first, 0, true, {1, 2, 3, 4}}, {&second, 0, true, {5, 6, 0, 0}}};
  list.beginRendering(targets);
  list.draw(3);
  list.endRendering();
  list.submit();
  using Pair = std::array<float, 2>;
  const auto firstSeen = colors(first);
  const auto secondSeen = readAs<Pair>(device(), second, 8);
  EXPECT_EQ(at(firstSeen, 0, 0), (Color{0.5F, 0.25F, 0, 1}));
  EXPECT_EQ(secondSeen.front(), (Pair{1.5F, 0.75F}));
  EXPECT_EQ(firstSeen.back(), (Color{1, 2, 3, 4}));
  EXPECT_EQ(secondSeen.back(), (Pair{5, 6}));
}

TEST_F(GraphicsTest, DepthAloneNeedsNoFragmentShader) {
  const Graphics<shaders::TrianglesVert> pipeline(
      device(), "depth", {.depthFormat = depth32, .depth = DepthMode::Write});
  Buffer triangle = vertices(upperLeft(0.125F, none));
  GpuImage depth = image("depth", depth32);
  CommandList list(device(), "frame");
  list.begin();
  list.bind(pipeline, {.vertices = triangle}, {});
  DepthTarget target{&depth};
  target.clearValue = 0.0625F;
  list.beginRendering({}, &target);
  list.draw(3);
  list.endRendering();
  list.submit();
  const auto depths = readAs<float>(device(), depth, 4);
  EXPECT_EQ(depths.front(), 0.125F);
  EXPECT_EQ(depths.back(), 0.0625F);
}

// What needs no barrier may be bound between the draws of one rendering scope.
TEST_F(GraphicsTest, ResourcesCanBeBoundAgainInsideRendering) {
  Buffer left = vertices(upperLeft(0, red));
  Buffer all = vertices(everywhere(0, green));
  GpuImage color = image("color", color32);
  const Triangles pipeline(device(), "triangles", {.colorFormats = {color32}});
  CommandList list(device(), "frame");
  list.begin();
  list.use(left, Access::StorageRead);
  list.use(all, Access::StorageRead);
  list.beginRendering({ColorTarget{&color}});
  list.bind(pipeline, {.vertices = all}, {});
  list.draw(3);
  list.bind(pipeline, {.vertices = left}, {});
  list.draw(3);
  list.endRendering();
  list.submit();
  EXPECT_EQ(colors(color).front(), red);
  EXPECT_EQ(colors(color).back(), green);
}

#ifndef NDEBUG
// Bugs in the order of calls that only asserts find.
TEST_F(GraphicsTest, OrderOfCallsIsAsserted) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  Buffer all = vertices(everywhere(0, green));
  GpuImage color = image("color", color32);
  const Triangles pipeline(device(), "triangles", {.colorFormats = {color32}});
  CommandList list(device(), "frame");
  EXPECT_DEATH(
      {
        list.begin();
        list.beginRendering({ColorTarget{&color}});
        list.bind(pipeline, {.vertices = all}, {});
      },
      "bind before beginRendering");
  EXPECT_DEATH(
      {
        list.begin();
        list.bind(pipeline, {.vertices = all}, {});
        list.use(all, Access::TransferWrite);
        list.beginRendering({ColorTarget{&color}});
        list.draw(3);
      },
      "boundIsCurrent");
}
#endif

}  // namespace
}  // namespace opaline::gpu
