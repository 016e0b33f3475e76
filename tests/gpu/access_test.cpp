#include "gpu/access.h"

#include <gtest/gtest.h>

namespace opaline::gpu {
namespace {

constexpr VkPipelineStageFlags2 shaders = VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT |
                                          VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT |
                                          VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
constexpr VkPipelineStageFlags2 depthTests =
    VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT;

AccessScope ofBuffer(Access access) {
  AccessScope scope = scopeOf(access);
  scope.layout = VK_IMAGE_LAYOUT_UNDEFINED;
  return scope;
}

// Stages, accesses and layouts from the tables of the Vulkan specification: "Supported access
// types" and "Image layouts".
TEST(Access, StandsForTheStagesAccessesAndLayoutOfTheSpecification) {
  struct Row {
    Access access;
    VkPipelineStageFlags2 stages;
    VkAccessFlags2 accesses;
    VkImageLayout layout;
    bool writes;
  };
  const Row rows[] = {
      {Access::None, 0, 0, VK_IMAGE_LAYOUT_UNDEFINED, false},
      {Access::ColorWrite, VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
       VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT,
       VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL, true},
      {Access::DepthWrite, depthTests,
       VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT |
           VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT,
       VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL, true},
      {Access::DepthTest, depthTests, VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT,
       VK_IMAGE_LAYOUT_READ_ONLY_OPTIMAL, false},
      {Access::Sampled, shaders, VK_ACCESS_2_SHADER_SAMPLED_READ_BIT,
       VK_IMAGE_LAYOUT_READ_ONLY_OPTIMAL, false},
      {Access::StorageRead, shaders, VK_ACCESS_2_SHADER_STORAGE_READ_BIT, VK_IMAGE_LAYOUT_GENERAL,
       false},
      {Access::StorageWrite, shaders,
       VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
       VK_IMAGE_LAYOUT_GENERAL, true},
      {Access::Uniform, shaders, VK_ACCESS_2_UNIFORM_READ_BIT, VK_IMAGE_LAYOUT_UNDEFINED, false},
      {Access::Index, VK_PIPELINE_STAGE_2_INDEX_INPUT_BIT, VK_ACCESS_2_INDEX_READ_BIT,
       VK_IMAGE_LAYOUT_UNDEFINED, false},
      {Access::TransferRead, VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_READ_BIT,
       VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, false},
      {Access::TransferWrite, VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
       VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, true},
      {Access::HostRead, VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT,
       VK_IMAGE_LAYOUT_GENERAL, false},
  };
  for (const Row& row : rows) {
    const AccessScope scope = scopeOf(row.access);
    const int which = static_cast<int>(row.access);
    EXPECT_EQ(scope.stages, row.stages) << which;
    EXPECT_EQ(scope.accesses, row.accesses) << which;
    EXPECT_EQ(scope.layout, row.layout) << which;
    EXPECT_EQ(scope.writes, row.writes) << which;
  }
}

TEST(Access, FirstUseOfABufferNeedsNoBarrier) {
  for (const Access access : {Access::StorageWrite, Access::StorageRead, Access::Uniform}) {
    AccessState state;
    EXPECT_FALSE(advance(state, ofBuffer(access)));
  }
}

TEST(Access, FirstUseOfAnImageDiscardsItsContents) {
  AccessState state;
  const auto barrier = advance(state, scopeOf(Access::ColorWrite));
  ASSERT_TRUE(barrier);
  EXPECT_EQ(barrier->oldLayout, VK_IMAGE_LAYOUT_UNDEFINED);
  EXPECT_EQ(barrier->newLayout, VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL);
  EXPECT_EQ(barrier->fromStages, 0U);
}

TEST(Access, ReadAfterWriteWaitsForTheWriteAndMakesItVisible) {
  AccessState state;
  advance(state, ofBuffer(Access::StorageWrite));
  const auto barrier = advance(state, ofBuffer(Access::StorageRead));
  ASSERT_TRUE(barrier);
  EXPECT_EQ(barrier->fromStages, shaders);
  EXPECT_NE(barrier->fromAccesses & VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT, 0U);
  EXPECT_EQ(barrier->toStages, shaders);
  EXPECT_EQ(barrier->toAccesses, VK_ACCESS_2_SHADER_STORAGE_READ_BIT);
}

TEST(Access, SecondReadOfTheSameKindNeedsNoBarrier) {
  AccessState state;
  advance(state, scopeOf(Access::ColorWrite));
  EXPECT_TRUE(advance(state, scopeOf(Access::Sampled)));
  EXPECT_FALSE(advance(state, scopeOf(Access::Sampled)));
}

TEST(Access, ReadOfAnotherKindSeesTheWriteToo) {
  AccessState state;
  advance(state, ofBuffer(Access::TransferWrite));
  advance(state, ofBuffer(Access::StorageRead));
  const auto barrier = advance(state, ofBuffer(Access::Index));
  ASSERT_TRUE(barrier);
  EXPECT_EQ(barrier->fromStages, VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT);
  EXPECT_NE(barrier->fromAccesses & VK_ACCESS_2_TRANSFER_WRITE_BIT, 0U);
  EXPECT_EQ(barrier->toStages, VK_PIPELINE_STAGE_2_INDEX_INPUT_BIT);
  EXPECT_FALSE(advance(state, ofBuffer(Access::Index)));
  EXPECT_FALSE(advance(state, ofBuffer(Access::StorageRead)));
}

TEST(Access, ADispatchThatWritesHowLargeTheNextIsWaitsForTheOneThatWroteItsOwn) {
  AccessState state;
  advance(state, ofBuffer(Access::StorageWriteIndirect));
  for (int i = 0; i < 2; ++i) {
    const auto barrier = advance(state, ofBuffer(Access::StorageWriteIndirect));
    ASSERT_TRUE(barrier);
    EXPECT_EQ(barrier->fromStages & shaders, shaders);
    EXPECT_NE(barrier->fromAccesses & VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT, 0U);
    EXPECT_EQ(barrier->toStages, shaders | VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT);
    EXPECT_NE(barrier->toAccesses & VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT, 0U);
  }
}

TEST(Access, WriteAfterReadsWaitsForAllOfThem) {
  AccessState state;
  advance(state, ofBuffer(Access::TransferWrite));
  advance(state, ofBuffer(Access::StorageRead));
  advance(state, ofBuffer(Access::Index));
  const auto barrier = advance(state, ofBuffer(Access::TransferWrite));
  ASSERT_TRUE(barrier);
  EXPECT_EQ(barrier->fromStages & (shaders | VK_PIPELINE_STAGE_2_INDEX_INPUT_BIT),
            shaders | VK_PIPELINE_STAGE_2_INDEX_INPUT_BIT);
}

TEST(Access, ReadsOfHostWrittenBuffersNeedNoBarrierButAreRemembered) {
  AccessState state;
  EXPECT_FALSE(advance(state, ofBuffer(Access::Uniform)));
  EXPECT_FALSE(advance(state, ofBuffer(Access::TransferRead)));
  const auto barrier = advance(state, ofBuffer(Access::StorageWrite));
  ASSERT_TRUE(barrier);
  EXPECT_EQ(barrier->fromStages, shaders | VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT);
}

TEST(Access, WriteAfterWriteIsOrdered) {
  AccessState state;
  advance(state, ofBuffer(Access::StorageWrite));
  EXPECT_TRUE(advance(state, ofBuffer(Access::StorageWrite)));
}

TEST(Access, ChangeOfLayoutBetweenReadsWaitsForTheEarlierReads) {
  AccessState state;
  advance(state, scopeOf(Access::TransferWrite));
  advance(state, scopeOf(Access::TransferRead));
  const auto barrier = advance(state, scopeOf(Access::Sampled));
  ASSERT_TRUE(barrier);
  EXPECT_EQ(barrier->fromStages, VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT);
  EXPECT_EQ(barrier->oldLayout, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
  EXPECT_EQ(barrier->newLayout, VK_IMAGE_LAYOUT_READ_ONLY_OPTIMAL);
  // The depth test reads in the same layout, but has to wait until the layout has changed.
  const auto test = advance(state, scopeOf(Access::DepthTest));
  ASSERT_TRUE(test);
  EXPECT_EQ(test->fromStages, shaders);
  EXPECT_EQ(test->oldLayout, test->newLayout);
}

TEST(Access, DiscardForgetsTheContentsButStillWaits) {
  AccessState state;
  advance(state, scopeOf(Access::ColorWrite));
  advance(state, scopeOf(Access::Sampled));
  EXPECT_FALSE(advance(state, scopeOf(Access::None)));
  const auto barrier = advance(state, scopeOf(Access::ColorWrite));
  ASSERT_TRUE(barrier);
  EXPECT_EQ(barrier->oldLayout, VK_IMAGE_LAYOUT_UNDEFINED);
  EXPECT_EQ(barrier->fromStages, shaders);
}

TEST(Access, TwoAccessesOfOneCommandAddUp) {
  const AccessScope both = together(ofBuffer(Access::StorageRead), ofBuffer(Access::StorageWrite));
  EXPECT_TRUE(both.writes);
  EXPECT_EQ(both.accesses,
            VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT);
  const AccessScope reads = together(ofBuffer(Access::StorageRead), ofBuffer(Access::Uniform));
  EXPECT_FALSE(reads.writes);
  EXPECT_EQ(reads.accesses, VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_UNIFORM_READ_BIT);
}

TEST(Access, AWriteThatWasPreparedHasNoBarrierOfItsOwn) {
  AccessState state;
  advance(state, scopeOf(Access::Sampled));
  const auto barrier = prepare(state, scopeOf(Access::StorageWrite));
  ASSERT_TRUE(barrier);
  EXPECT_EQ(barrier->fromStages, shaders);
  EXPECT_EQ(barrier->newLayout, VK_IMAGE_LAYOUT_GENERAL);
  EXPECT_FALSE(advance(state, scopeOf(Access::StorageWrite)));
  EXPECT_TRUE(advance(state, scopeOf(Access::StorageWrite)));
}

TEST(Access, AnotherAccessThanWasPreparedWaits) {
  AccessState state;
  prepare(state, scopeOf(Access::StorageWrite));
  EXPECT_TRUE(advance(state, scopeOf(Access::TransferWrite)));
  EXPECT_TRUE(advance(state, scopeOf(Access::StorageWrite)));
}

}  // namespace
}  // namespace opaline::gpu
