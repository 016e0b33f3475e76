#include <imgui.h>

#include <cmath>

#include "viewer/panels/controls.h"
#include "viewer/panels/panels.h"

namespace opaline::app::viewer {

namespace {

const Choices<Shown>& shownPictures() {
  static const Choices<Shown> table{
      {"picture", Shown::Picture}, {"truth", Shown::Truth}, {"heat map", Shown::HeatMap}};
  return table;
}

void showAll(const TruthView& truth) {
  ImGui::TextWrapped("%s", truth.legend().c_str());
  if (!truth.figures()) return;
  ImGui::TextWrapped("pixels off by %.2f %% (RMSE / mean)", 100 * truth.figures()->all.relRmse);
  const double bias = 100 * truth.figures()->all.relBias;
  ImGui::TextWrapped("%s by %.2f %% in the mean", bias < 0 ? "darker" : "brighter", std::abs(bias));
}

// Paler once the picture is another.
void showFigures(const TruthView& truth) {
  ImGui::PushStyleColor(
      ImGuiCol_Text,
      ImGui::GetStyleColorVec4(truth.isOfNow() ? ImGuiCol_Text : ImGuiCol_TextDisabled));
  showAll(truth);
  ImGui::PopStyleColor();
}

void drawSaving(Session& session) {
  const auto button = [&](const char* name, TruthFile file, const char* about) {
    if (controls::button(name, about)) session.wantedTruthFile = file;
  };
  button("save truth", TruthFile::Png, "NAME_truth.png: as it is shown, at this exposure.");
  controls::sameLineFor("as EXR");
  button("as EXR", TruthFile::Exr, "NAME_truth.exr: linear light, 32-bit floats.");
  controls::sameLineFor("save heat map");
  button("save heat map", TruthFile::HeatMap,
         "NAME_heat_map.png, with its scale. opaline compare draws others of the two EXR files.");
}

}  // namespace

void drawTruthPanel(Session& session, const TruthView& truth) {
  if (!controls::section("Truth", false)) return;
  if (controls::button("path tracing",
                       "Follows light through the bodies until blocks of 8 x 8 pixels are within 2 "
                       "%. Takes minutes.")) {
    session.wantedTruth = TruthOrder::Method::Path;
  }
  controls::sameLineFor("dipole's integral");
  if (controls::button("dipole's integral",
                       "Sums the dipole exactly over the surface, which the tree approximates. The "
                       "dipole is wrong in thin parts.")) {
    session.wantedTruth = TruthOrder::Method::Integral;
  }
  if (truth.running()) {
    ImGui::ProgressBar(static_cast<float>(truth.progress()));
    if (controls::button("cancel", "Keeps the result so far.")) session.cancelTruth = true;
  }
  const std::string error = truth.error();
  if (!error.empty()) controls::text(error);
  if (!truth.hasPicture()) return;
  controls::choice("shown", session.shown, shownPictures(),
                   "Shows the picture, its truth, or their difference. Edits change the picture; "
                   "the truth shows the scene as it was at the start.");
  showFigures(truth);
  drawSaving(session);
}

}  // namespace opaline::app::viewer
