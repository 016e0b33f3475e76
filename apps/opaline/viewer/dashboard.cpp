#include "viewer/dashboard.h"

#include <imgui.h>

#include <algorithm>

#include <GLFW/glfw3.h>

#include "viewer/controls.h"
#include "viewer/label_layout.h"
#include "viewer/overlay.h"
#include "viewer/panels/panels.h"
#include "viewer/picture_input.h"
#include "viewer/projection.h"

namespace opaline::app::viewer {

void Dashboard::layOut() {
  const ImGuiIO& io = ImGui::GetIO();
  const auto width = static_cast<int>(io.DisplaySize.x);
  const auto height = static_cast<int>(io.DisplaySize.y);
  const int panel = panels_ ? std::min(static_cast<int>(24 * ImGui::GetFontSize()), width / 2) : 0;
  area_ = {0, 0, width - panel, height};
}

void Dashboard::useKeys(const std::vector<KeyPress>& presses, Window& window, Session& session,
                        bool hasScene) {
  const bool typing = ImGui::GetIO().WantTextInput;
  if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) keyList_ = false;
  for (const KeyPress& press : presses) {
    if (press.control && press.key == GLFW_KEY_Q) window.close();
    if (typing) continue;
    if (press.typed == U'?') keyList_ = !keyList_;
    if (press.key == GLFW_KEY_ESCAPE) keyList_ = false;
    if (!hasScene) continue;
    if (!press.control && !press.repeated) {
      if (press.key == GLFW_KEY_TAB) panels_ = !panels_;
      if (press.key == GLFW_KEY_P) session.wanted = Save::Picture;
      if (press.key == GLFW_KEY_S) session.wanted = Save::Scene;
    }
    PictureInput::useKey(press, session, area_);
  }
}

void Dashboard::drawPanels(Session& session, const TruthView& truth, const TimingHistory& history,
                           const Saver& saver) const {
  if (!panels_) return;
  const ImGuiIO& io = ImGui::GetIO();
  ImGui::SetNextWindowPos({static_cast<float>(area_.width), 0});
  ImGui::SetNextWindowSize({io.DisplaySize.x - static_cast<float>(area_.width), io.DisplaySize.y});
  // Without NoNavInputs, Tab would also go from one control to the next.
  constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                                     ImGuiWindowFlags_NoNavInputs;
  ImGui::Begin("panels", nullptr, flags);
  controls::text(session.name);
  controls::sameLineFor("? lists the keys");
  ImGui::TextDisabled("? lists the keys");
  for (const std::string& note : session.notes) controls::text(note);
  drawMediumPanel(session);
  drawLightPanel(session);
  drawMethodPanel(session);
  drawMotionPanel(session);
  drawTruthPanel(session, truth);
  drawViewPanel(session);
  drawTimePanel(session, history);
  drawSavePanel(session, saver);
  ImGui::End();
}

void Dashboard::drawOverPicture(const Session& session, const TruthView& truth,
                                const LightHandles& handles,
                                const std::vector<Caption>& captions) const {
  LabelLayout labels({static_cast<float>(area_.x), static_cast<float>(area_.y),
                      static_cast<float>(area_.width), static_cast<float>(area_.height)});
  labels.take(boxOf(captions, area_));
  if (session.shown != Shown::Picture) return drawLegend(truth.legend(), area_, labels);
  const Projection projection(session.scene.camera, area_);
  if (showsScene(session)) {
    if (session.scaleBar) drawScaleBar(session, projection, area_, labels);
    if (session.gizmos) handles.draw(session, projection, *ImGui::GetBackgroundDrawList());
  }
  if (session.divided) drawDivider(session, area_, labels);
}

void Dashboard::drawKeyList() const {
  if (keyList_) drawKeys(area_);
}

}  // namespace opaline::app::viewer
