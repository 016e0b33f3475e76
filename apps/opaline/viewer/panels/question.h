#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "viewer/window/window.h"

namespace opaline::app::viewer {

/// Asks before something is lost, over everything else of the window.
class Question {
 public:
  struct Text {
    std::string question;
    std::string yes;  ///< what the button does
    std::string no;
  };

  /// `whenYes` is called where that is the answer. Another question that is open is taken back.
  void ask(Text text, std::function<void()> whenYes);
  bool isOpen() const { return text_.has_value(); }

  /// All keys are the question's while it is open: Enter is yes, Escape is no.
  void useKeys(const std::vector<KeyPress>& presses);
  /// Draws it with Dear ImGui's functions.
  void draw();

 private:
  void answer(bool yes);

  std::optional<Text> text_;
  std::function<void()> whenYes_;
};

}  // namespace opaline::app::viewer
