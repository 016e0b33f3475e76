#include "viewer/panels/question.h"

#include <imgui.h>

#include <algorithm>
#include <utility>

#include <GLFW/glfw3.h>

#include "viewer/panels/controls.h"
#include "viewer/window/glyphs.h"

namespace opaline::app::viewer {

namespace {

constexpr const char* popup = "question";

}  // namespace

void Question::ask(Text text, std::function<void()> whenYes) {
  text_ = std::move(text);
  whenYes_ = std::move(whenYes);
}

void Question::answer(bool yes) {
  text_.reset();
  const std::function<void()> then = std::exchange(whenYes_, nullptr);
  if (yes && then) then();
}

void Question::useKeys(const std::vector<KeyPress>& presses) {
  for (const KeyPress& press : presses) {
    if (!isOpen() || press.repeated) continue;
    if (press.key == GLFW_KEY_ESCAPE) answer(false);
    if (press.key == GLFW_KEY_ENTER || press.key == GLFW_KEY_KP_ENTER) answer(true);
  }
}

void Question::draw() {
  if (!text_ && !ImGui::IsPopupOpen(popup)) return;
  if (!ImGui::IsPopupOpen(popup)) ImGui::OpenPopup(popup);
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float font = ImGui::GetFontSize();
  ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Always, {0.5F, 0.5F});
  constexpr ImGuiWindowFlags flags =
      ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoTitleBar |
      ImGuiWindowFlags_NoNav | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings;
  if (!ImGui::BeginPopupModal(popup, nullptr, flags)) return;
  std::optional<bool> given;
  if (text_) {
    const controls::Group group("Question");
    ImGui::PushTextWrapPos(std::min(28 * font, 0.9F * screen.x));
    glyphs::want(text_->question);
    ImGui::TextUnformatted(text_->question.c_str());
    ImGui::PopTextWrapPos();
    ImGui::Spacing();
    if (controls::button(text_->yes.c_str(), "Key: Enter.")) given = true;
    ImGui::SameLine();
    if (controls::button(text_->no.c_str(), "Key: Escape.")) given = false;
  }
  if (!text_ || given) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
  if (given) answer(*given);
}

}  // namespace opaline::app::viewer
