#pragma once

#include <cstddef>
#include <deque>
#include <vector>

namespace opaline::app::viewer {

/// Something that was done with keyboard or mouse.
struct Input {
  enum class Kind { Key, Text, Button, Wheel, Pointer, Left };
  Kind kind = Kind::Key;
  int code = 0;        ///< the key's or button's, by GLFW
  int scanCode = 0;    ///< the key's, by the system
  int action = 0;      ///< of key or button: GLFW_PRESS, GLFW_REPEAT or GLFW_RELEASE
  int modifiers = 0;   ///< GLFW_MOD_...
  char32_t typed = 0;  ///< of Text
  double x = 0;        ///< of the pointer, or of the wheel
  double y = 0;

  bool isPress() const;  ///< of a key or a button, repeated or not
  bool isUse() const;    ///< of a key, a button or the wheel
};

/// A key that went down or repeats, or a character that was typed.
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

/// Inputs in their order, until the interface takes them. It sees the state of keys and mouse once
/// a frame: a key that went down and up again between two frames would be lost to it.
class InputQueue {
 public:
  void add(const Input& input) { waiting_.push_back(input); }
  bool empty() const { return waiting_.empty(); }

  /// As many of the first inputs as one frame can tell apart: one press, whose release comes with a
  /// later frame, and no movement after a button was used.
  std::vector<Input> takeFrame();

 private:
  std::deque<Input> waiting_;
};

}  // namespace opaline::app::viewer
