#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "gpu/command_list.h"
#include "gpu/gpu_fixture.h"
#include "gpu/helpers.h"
#include "gpu/pipeline.h"
#include "gpu/transfer.h"
#include "shaders/cubes.comp.h"
#include "shaders/layers.comp.h"

namespace opaline::gpu {
namespace {

using SamplingTest = GpuTest;
using Color = std::array<float, 4>;

constexpr VkFormat color32 = VK_FORMAT_R32G32B32A32_SFLOAT;

Buffer resultBuffer(Device& device, std::size_t floats) {
  return makeBuffer(device, "results", std::vector<float>(floats, -1.0F),
                    VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
}

TEST_F(SamplingTest, LayersThatWereDrawnOneByOneAreSampledTogether) {
  ImageOptions options;
  options.name = "layers";
  options.width = 8;
  options.height = 8;
  options.layers = 3;
  options.format = color32;
  options.usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;
  options.kind = ImageKind::Array;
  GpuImage image(device(), options);
  Buffer results = resultBuffer(device(), 12);
  const Compute<shaders::Layers> pipeline(device(), "layers");
  const Sampler sampler(device(), Filter::Nearest);
  CommandList list(device(), "frame");
  list.begin();
  for (std::uint32_t layer = 0; layer < 3; ++layer) {
    const auto value = static_cast<float>(layer);
    list.beginRendering({ColorTarget{&image, layer, true, {value, 10 + value, 20 + value, 1}}});
    list.endRendering();
  }
  list.bind(pipeline, {.image = {image, sampler}, .results = results});
  list.dispatch(3);
  list.submit();
  EXPECT_EQ(readAs<Color>(device(), results),
            (std::vector<Color>{{0, 10, 20, 1}, {1, 11, 21, 1}, {2, 12, 22, 1}}));
}

TEST_F(SamplingTest, LevelsAreSampledEachOnItsOwn) {
  ImageOptions options;
  options.name = "levels";
  options.width = 4;
  options.height = 4;
  options.layers = 2;
  options.mipLevels = 3;
  options.format = color32;
  options.usage = VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;
  options.kind = ImageKind::Array;
  GpuImage image(device(), options);
  for (std::uint32_t level = 0; level < 3; ++level) {
    for (std::uint32_t layer = 0; layer < 2; ++layer) {
      const std::size_t texels = std::size_t{4U >> level} * (4U >> level);
      const Color color{static_cast<float>(layer), static_cast<float>(level), 0, 1};
      uploadImage(device(), image, bytesOf(std::vector<Color>(texels, color)), layer, level);
    }
  }
  Buffer results = resultBuffer(device(), 24);
  const Compute<shaders::Layers> pipeline(device(), "levels");
  const Sampler sampler(device(), Filter::Linear, Wrap::Repeat, Wrap::Clamp);
  CommandList list(device(), "frame");
  list.begin();
  list.bind(pipeline, {.image = {image, sampler}, .results = results});
  list.dispatch(2, 3);
  list.submit();
  EXPECT_EQ(
      readAs<Color>(device(), results),
      (std::vector<Color>{
          {0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}, {1, 1, 0, 1}, {0, 2, 0, 1}, {1, 2, 0, 1}}));
}

// The order of faces is that of the Vulkan specification, "Cube Map Face Selection".
TEST_F(SamplingTest, DepthOfEveryFaceOfACubeArrayIsFoundAlongItsAxis) {
  ImageOptions options;
  options.name = "cubes";
  options.width = 4;
  options.height = 4;
  options.layers = 12;
  options.format = VK_FORMAT_D32_SFLOAT;
  options.usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;
  options.kind = ImageKind::CubeArray;
  GpuImage image(device(), options);
  Buffer results = resultBuffer(device(), 12);
  const Compute<shaders::Cubes> pipeline(device(), "cubes");
  const Sampler sampler(device(), Filter::Nearest);
  CommandList list(device(), "frame");
  list.begin();
  for (std::uint32_t layer = 0; layer < 12; ++layer) {
    const DepthTarget target{&image, layer, true, static_cast<float>(layer) / 16, true};
    list.beginRendering({}, &target);
    list.endRendering();
  }
  list.bind(pipeline, {.cubes = {image, sampler}, .results = results});
  list.dispatch(6, 2);
  list.submit();
  const auto depths = readAs<float>(device(), results);
  for (std::size_t i = 0; i < 12; ++i) EXPECT_EQ(depths[i], static_cast<float>(i) / 16) << i;
}

// Repeat and clamp, nearest and linear, on an image of two texels.
TEST_F(SamplingTest, SamplerFiltersAsAsked) {
  ImageOptions options;
  options.name = "two texels";
  options.width = 2;
  options.height = 1;
  options.layers = 1;
  options.format = color32;
  options.usage = VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;
  options.kind = ImageKind::Array;
  GpuImage image(device(), options);
  uploadImage(device(), image, bytesOf(std::vector<Color>{{0, 0, 0, 0}, {1, 1, 1, 1}}));
  const Compute<shaders::Layers> pipeline(device(), "two texels");
  // The shader reads at u = 1/2, the border of the two texels.
  for (const Filter filter : {Filter::Linear, Filter::Nearest}) {
    Buffer results = resultBuffer(device(), 4);
    const Sampler sampler(device(), filter);
    CommandList list(device(), "frame");
    list.begin();
    list.bind(pipeline, {.image = {image, sampler}, .results = results});
    list.dispatch(1);
    list.submit();
    const Color seen = readAs<Color>(device(), results).front();
    EXPECT_EQ(seen[0], filter == Filter::Linear ? 0.5F : 1.0F);
  }
}

}  // namespace
}  // namespace opaline::gpu
