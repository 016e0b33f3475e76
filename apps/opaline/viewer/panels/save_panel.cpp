#include <imgui.h>
#include <imgui_stdlib.h>

#include "viewer/controls.h"
#include "viewer/panels/panels.h"

namespace opaline::app::viewer {

void drawSavePanel(Session& session, const Saver& saver) {
  if (!controls::section("Save", false)) return;
  ImGui::SetNextItemWidth(-0.38F * ImGui::GetWindowContentRegionMax().x);
  ImGui::InputText("name", &session.saveName);
  controls::note("name");
  controls::tip(
      "Without its ending; in the folder that the window was opened from, or with a "
      "folder of its own. A file that has that name stays: NAME-2 is saved, and so on.");
  if (controls::button("picture", "NAME.png: what is seen. Key: P."))
    session.wanted = Save::Picture;
  ImGui::SameLine();
  if (controls::button("EXR", "NAME.exr: linear light, 32-bit floats.")) session.wanted = Save::Exr;
  ImGui::SameLine();
  if (controls::button("scene", "NAME.toml: opaline render draws the same of it. Key: S.")) {
    session.wanted = Save::Scene;
  }
  ImGui::SameLine();
  if (saver.filming()) {
    ImGui::NewLine();
    ImGui::ProgressBar(static_cast<float>(saver.progress()));
    if (controls::button("stop the film", "Leaves no film.")) session.wanted = Save::NoFilm;
  } else if (controls::button("film", "NAME.mp4: the motion once, 30 frames a second.")) {
    session.wanted = Save::Film;
  }
}

}  // namespace opaline::app::viewer
