#pragma once

#include <cstddef>
#include <deque>
#include <vector>

namespace opaline::app::viewer {

/// One action with keyboard or mouse.
struct Input {
  enum class Kind { Key, Text, Button, Wheel, Pointer, Left };
  Kind kind = Kind::Key;
  int code = 0;        ///< of the key or button, by GLFW
  int scanCode = 0;    ///< of the key, by the system
  int action = 0;      ///< of key or button: GLFW_PRESS, GLFW_REPEAT or GLFW_RELEASE
  int modifiers = 0;   ///< GLFW_MOD_...
  char32_t typed = 0;  ///< with Kind::Text
  double x = 0;        ///< of the pointer or the wheel
  double y = 0;

  bool isPress() const;  ///< of a key or a button, repeated or not
  bool isUse() const;    ///< of a key, a button or the wheel
};

/// A key that was pressed or repeats, or a character that was typed.
struct KeyPress {
  int key = 0;         ///< GLFW's name of it, a letter's where the keyboard's own layout has it;
                       ///< 0 where only `typed` is known
  char32_t typed = 0;  ///< 0 where only `key` is known
  bool control = false;
  bool shift = false;
  bool alt = false;
  bool repeated = false;
};

std::vector<KeyPress> keyPressesOf(const std::vector<Input>& inputs);

/// Keeps inputs in order until the interface takes them. The interface sees the state of keys and
/// mouse once per frame: it would miss a key that is pressed and released between two frames.
class InputQueue {
 public:
  void add(const Input& input) { waiting_.push_back(input); }
  bool empty() const { return waiting_.empty(); }

  /// As many of the first inputs as one frame can tell apart: one press, whose release must wait
  /// for a later frame, and no movement after a button was used.
  std::vector<Input> takeFrame();

 private:
  std::deque<Input> waiting_;
};

}  // namespace opaline::app::viewer
