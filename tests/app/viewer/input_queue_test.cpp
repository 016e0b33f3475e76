#include "viewer/window/input_queue.h"

#include <gtest/gtest.h>

#include <GLFW/glfw3.h>

namespace opaline::app::viewer {
namespace {

using Kind = Input::Kind;

Input key(int code, int action) {
  return {.kind = Kind::Key, .code = code, .action = action};
}

Input button(int action) {
  return {.kind = Kind::Button, .code = GLFW_MOUSE_BUTTON_LEFT, .action = action};
}

Input pointer(double x) {
  return {.kind = Kind::Pointer, .x = x};
}

std::vector<std::size_t> sizesOfFrames(const std::vector<Input>& inputs) {
  InputQueue queue;
  for (const Input& input : inputs) queue.add(input);
  std::vector<std::size_t> sizes;
  while (!queue.empty()) sizes.push_back(queue.takeFrame().size());
  return sizes;
}

using Sizes = std::vector<std::size_t>;

TEST(InputQueueTest, AKeyIsDownForAFrame) {
  EXPECT_EQ(sizesOfFrames({key(GLFW_KEY_ENTER, GLFW_PRESS), key(GLFW_KEY_ENTER, GLFW_RELEASE)}),
            (Sizes{1, 1}));
}

TEST(InputQueueTest, WhatIsTypedFastKeepsItsOrder) {
  // "6", Enter and "p" within one frame: the last is no part of the text.
  const std::vector<Input> typed{
      key(GLFW_KEY_6, GLFW_PRESS),         {.kind = Kind::Text, .typed = U'6'},
      key(GLFW_KEY_6, GLFW_RELEASE),       key(GLFW_KEY_ENTER, GLFW_PRESS),
      key(GLFW_KEY_ENTER, GLFW_RELEASE),   key(GLFW_KEY_P, GLFW_PRESS),
      {.kind = Kind::Text, .typed = U'p'}, key(GLFW_KEY_P, GLFW_RELEASE)};
  EXPECT_EQ(sizesOfFrames(typed), (Sizes{2, 2, 3, 1}));
}

TEST(InputQueueTest, AButtonIsUsedWhereThePointerWas) {
  EXPECT_EQ(sizesOfFrames({pointer(1), pointer(2), button(GLFW_PRESS), pointer(3),
                           button(GLFW_RELEASE), pointer(4)}),
            (Sizes{3, 2, 1}));
}

TEST(InputQueueTest, MovesAndWheelAreOneFrame) {
  EXPECT_EQ(
      sizesOfFrames(
          {pointer(1), {.kind = Kind::Wheel, .y = 1}, {.kind = Kind::Wheel, .y = 1}, pointer(2)}),
      (Sizes{4}));
}

TEST(InputQueueTest, KeysThatAreHeldRepeat) {
  EXPECT_EQ(sizesOfFrames({key(GLFW_KEY_LEFT, GLFW_PRESS), key(GLFW_KEY_LEFT, GLFW_REPEAT),
                           key(GLFW_KEY_LEFT, GLFW_REPEAT), key(GLFW_KEY_LEFT, GLFW_RELEASE)}),
            (Sizes{1, 1, 1, 1}));
}

}  // namespace
}  // namespace opaline::app::viewer
