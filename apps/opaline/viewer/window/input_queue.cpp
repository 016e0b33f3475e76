#include "viewer/window/input_queue.h"

#include <algorithm>

#include <GLFW/glfw3.h>

namespace opaline::app::viewer {

namespace {

// GLFW names keys by their place on a US keyboard. The letter printed on the user's key is what
// counts, as far as it is Latin.
int letterOf(int key, int scanCode) {
  const char* const name = glfwGetKeyName(key, scanCode);
  if (name == nullptr || name[0] == 0 || name[1] != 0) return key;
  if (name[0] >= 'a' && name[0] <= 'z') return GLFW_KEY_A + (name[0] - 'a');
  return key;
}

bool blursWith(const Input& earlier, const Input& later) {
  using Kind = Input::Kind;
  if (later.isPress()) return earlier.isPress();
  if (later.kind == Kind::Key || later.kind == Kind::Button)
    return earlier.isPress() && earlier.kind == later.kind && earlier.code == later.code;
  if (later.kind == Kind::Pointer || later.kind == Kind::Left) return earlier.kind == Kind::Button;
  return false;
}

}  // namespace

bool Input::isPress() const {
  return (kind == Kind::Key || kind == Kind::Button) && action != GLFW_RELEASE;
}

bool Input::isUse() const {
  return kind == Kind::Key || kind == Kind::Button || kind == Kind::Wheel;
}

std::vector<KeyPress> keyPressesOf(const std::vector<Input>& inputs) {
  std::vector<KeyPress> presses;
  for (const Input& input : inputs) {
    if (input.kind == Input::Kind::Text) presses.push_back({.typed = input.typed});
    if (input.kind != Input::Kind::Key || !input.isPress()) continue;
    const auto held = [&](int modifier) { return (input.modifiers & modifier) != 0; };
    presses.push_back({letterOf(input.code, input.scanCode), 0, held(GLFW_MOD_CONTROL),
                       held(GLFW_MOD_SHIFT), held(GLFW_MOD_ALT), input.action == GLFW_REPEAT});
  }
  return presses;
}

std::vector<Input> InputQueue::takeFrame() {
  std::vector<Input> frame;
  const auto blurs = [&](const Input& later) {
    return std::any_of(frame.begin(), frame.end(),
                       [&](const Input& earlier) { return blursWith(earlier, later); });
  };
  while (!waiting_.empty() && !blurs(waiting_.front())) {
    frame.push_back(waiting_.front());
    waiting_.pop_front();
  }
  return frame;
}

}  // namespace opaline::app::viewer
