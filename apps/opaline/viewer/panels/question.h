#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "viewer/window/window.h"

namespace opaline::app::viewer {

/// Asks before something is lost, above everything else in the window.
class Question {
 public:
  struct Text {
    std::string question;
    std::string yes;  ///< label of the button that does it
    std::string no;
  };

  /// Calls `whenYes` if the answer is yes. An earlier question that is still open is withdrawn.
  void ask(Text text, std::function<void()> whenYes);
  bool isOpen() const { return text_.has_value(); }

  /// The question takes all keys while it is open: Enter is yes, Escape is no.
  void useKeys(const std::vector<KeyPress>& presses);
  /// Draws it with Dear ImGui.
  void draw();

 private:
  void answer(bool yes);

  std::optional<Text> text_;
  std::function<void()> whenYes_;
};

}  // namespace opaline::app::viewer
