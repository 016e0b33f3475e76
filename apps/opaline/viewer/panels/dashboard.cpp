#include "viewer/panels/dashboard.h"

#include <imgui.h>

#include <algorithm>

#include <GLFW/glfw3.h>

#include "viewer/panels/controls.h"
#include "viewer/panels/panels.h"
#include "viewer/picture/label_layout.h"
#include "viewer/picture/overlay.h"
#include "viewer/picture/picture_input.h"
#include "viewer/picture/projection.h"

namespace opaline::app::viewer {

namespace {

// What the renderer has to say of the picture.
void drawNotes(const Session& session) {
  if (session.renderNotes.empty() || !controls::section("Notes", true)) return;
  for (const std::string& note : session.renderNotes) controls::hint(note);
}

}  // namespace

void Dashboard::layOut(const Session& session) {
  const ImGuiIO& io = ImGui::GetIO();
  const auto width = static_cast<int>(io.DisplaySize.x);
  const auto height = static_cast<int>(io.DisplaySize.y);
  const int panel = panels_ ? std::min(static_cast<int>(24 * ImGui::GetFontSize()), width / 2) : 0;
  right_ = width - panel;
  area_ = {0, 0, right_, height};
  // The picture is shown in the shape in which it is saved.
  if (session.pictureSize && !area_.empty()) {
    area_ = fitted(area_, (*session.pictureSize)[0], (*session.pictureSize)[1]);
  }
}

void Dashboard::useKeys(const std::vector<KeyPress>& presses, Session& session, bool hasScene,
                        bool filming) {
  // A field that lost the focus in the previous frame needs no more keys.
  const bool typing = ImGui::GetIO().WantTextInput && ImGui::IsAnyItemActive();
  if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) keyList_ = false;
  for (const KeyPress& press : presses) {
    if (typing) continue;
    if (press.typed == U'?') keyList_ = !keyList_;
    if (press.key == GLFW_KEY_ESCAPE) keyList_ = false;
    if (press.control && press.key == GLFW_KEY_O) session.wantedFile = FileUse::OpenScene;
    if (!hasScene) continue;
    if (press.control && press.key == GLFW_KEY_Z) session.wantedSteps = press.shift ? 1 : -1;
    if (press.control && press.key == GLFW_KEY_Y) session.wantedSteps = 1;
    if (press.control && press.key == GLFW_KEY_S) session.wantedFile = FileUse::SaveScene;
    if (!press.control && !press.repeated) {
      if (press.key == GLFW_KEY_TAB) panels_ = !panels_;
      if (press.key == GLFW_KEY_P) session.wanted = session.savedByKey;
      if (press.key == GLFW_KEY_S) session.wanted = Save::Scene;
    }
    if (!filming) PictureInput::useKey(press, session, area_);
  }
}

void Dashboard::drawTop(Session& session, const UndoList& undo) {
  if (!session.name.empty()) {
    controls::text(session.name);
    controls::sameLineFor("? lists the keys");
  }
  ImGui::TextDisabled("? lists the keys");
  if (controls::button("open...",
                       "A model or a scene. Or drop its file on the window. Key: Ctrl O.")) {
    session.wantedFile = FileUse::OpenScene;
  }
  const auto step = [&](const char* name, bool possible, int steps, const char* about) {
    ImGui::SameLine();
    ImGui::BeginDisabled(!possible);
    if (controls::button(name, about)) session.wantedSteps = steps;
    ImGui::EndDisabled();
  };
  step("undo", undo.canUndo(), -1,
       "Undoes the last edit; camera moves are not edits. Key: Ctrl Z.");
  step("redo", undo.canRedo(), 1, "Repeats the undone edit. Keys: Ctrl Shift Z, Ctrl Y.");
  ImGui::SameLine();
  ImGui::TextDisabled("or drop a file");
}

void Dashboard::drawPanels(Session& session, bool hasScene, const TruthView& truth,
                           const TimingHistory& history, const Saver& saver,
                           const UndoList& undo) const {
  if (!panels_) return;
  const ImGuiIO& io = ImGui::GetIO();
  ImGui::SetNextWindowPos({static_cast<float>(right_), 0});
  ImGui::SetNextWindowSize({io.DisplaySize.x - static_cast<float>(right_), io.DisplaySize.y});
  // Without NoNavInputs, Tab would also step through the controls.
  constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                                     ImGuiWindowFlags_NoNavInputs;
  ImGui::Begin("panels", nullptr, flags);
  drawTop(session, undo);
  if (!hasScene) return ImGui::End();
  for (const std::string& note : session.notes) controls::text(note);
  // Controls of two panels may share a name.
  int panel = 0;
  const auto apart = [&panel](const auto& draw) {
    ImGui::PushID(++panel);
    draw();
    ImGui::PopID();
  };
  apart([&] { drawMediumPanel(session); });
  apart([&] { drawMaterialPanel(session); });
  apart([&] { drawLightPanel(session, {session.scene.camera, area_}); });
  apart([&] { drawMethodPanel(session); });
  apart([&] { drawMotionPanel(session); });
  apart([&] { drawTruthPanel(session, truth); });
  apart([&] { drawViewPanel(session); });
  apart([&] { drawTimePanel(session, history); });
  apart([&] { drawSavePanel(session, saver); });
  // The last, so that no other panel moves when a note comes.
  apart([&] { drawNotes(session); });
  ImGui::End();
}

void Dashboard::drawOverPicture(const Session& session, const TruthView& truth,
                                const LightHandles& handles,
                                const std::vector<Caption>& captions) const {
  LabelLayout labels({static_cast<float>(area_.x), static_cast<float>(area_.y),
                      static_cast<float>(area_.width), static_cast<float>(area_.height)});
  labels.take(boxOf(captions, area_));
  if (session.shown != Shown::Picture) {
    if (session.shown == Shown::HeatMap && truth.hasPicture())
      drawHeatScale(truth.heatMapTop(), heatMapColors(), area_, labels);
    return drawLegend(truth.legend(), area_, labels);
  }
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
