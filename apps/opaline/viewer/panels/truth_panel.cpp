#include <imgui.h>

#include "viewer/controls.h"
#include "viewer/panels/panels.h"

namespace opaline::app::viewer {

namespace {

const Choices<Shown>& shownPictures() {
  static const Choices<Shown> table{
      {"picture", Shown::Picture}, {"truth", Shown::Truth}, {"heat map", Shown::HeatMap}};
  return table;
}

void showFigures(const TruthView& truth) {
  const TruthPicture& latest = *truth.latest();
  ImGui::Text("%.1f s, truth itself within %.2g %%", latest.seconds, 100 * latest.error);
  if (truth.figures()) {
    ImGui::Text("pixels off by %.2f %% (RMSE / mean)", 100 * truth.figures()->all.relRmse);
    ImGui::Text("brighter by %.2f %% in the mean", 100 * truth.figures()->all.relBias);
  }
  if (truth.blocks()) {
    ImGui::Text("blocks of 8 x 8 off by %.2f %%", 100 * truth.blocks()->relRmse);
  }
}

}  // namespace

void drawTruthPanel(Session& session, const TruthView& truth) {
  if (!controls::section("Truth", false)) return;
  if (controls::button("path tracing",
                       "Particles from the lights through the bodies, until blocks of 8 x 8 "
                       "pixels are within 2 %: what light does. Minutes.")) {
    session.wantedTruth = TruthOrder::Method::Path;
  }
  ImGui::SameLine();
  if (controls::button("dipole's integral",
                       "The dipole summed exactly over the surface: what the tree approximates. "
                       "Not what light does in thin parts.")) {
    session.wantedTruth = TruthOrder::Method::Integral;
  }
  if (truth.running()) {
    ImGui::ProgressBar(static_cast<float>(truth.progress()));
    if (controls::button("cancel", "Keeps what there is.")) session.cancelTruth = true;
  }
  const std::string error = truth.error();
  if (!error.empty()) ImGui::TextWrapped("%s", error.c_str());
  if (!truth.hasPicture()) return;
  controls::choice("shown", session.shown, shownPictures(),
                   "The picture, the truth of it, or how far they are apart. Edits go on on the "
                   "picture; the truth is of when it was started.");
  showFigures(truth);
}

}  // namespace opaline::app::viewer
