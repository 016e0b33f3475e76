#include <imgui.h>

#include <cstddef>

#include "viewer/panels/controls.h"
#include "viewer/panels/panels.h"

namespace opaline::app::viewer {

namespace {

// Distinct colours for neighbouring passes, by the golden angle.
ImU32 colorOf(std::size_t pass) {
  const float turns = 0.381966F * static_cast<float>(pass);
  const float hue = turns - static_cast<float>(static_cast<int>(turns));
  return ImColor::HSV(hue, 0.55F, 0.85F);
}

void drawStacks(const TimingHistory& history) {
  const ImVec2 size(ImGui::GetContentRegionAvail().x, 7 * ImGui::GetFontSize());
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton("stacks", size);
  controls::note("stacks");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(corner, {corner.x + size.x, corner.y + size.y},
                     ImGui::GetColorU32(ImGuiCol_FrameBg));
  const double most = history.largestTotal();
  if (!(most > 0)) return;
  const float width = size.x / static_cast<float>(TimingHistory::kept);
  for (std::size_t frame = 0; frame < history.frames(); ++frame) {
    const float x = corner.x + width * static_cast<float>(frame);
    float y = corner.y + size.y;
    const auto row = history.milliseconds(frame);
    for (std::size_t pass = 0; pass < row.size(); ++pass) {
      const float height = size.y * static_cast<float>(row[pass] / most);
      list.AddRectFilled({x, y - height}, {x + width, y}, colorOf(pass));
      y -= height;
    }
  }
  ImGui::Text("full height: %.1f ms", most);
}

}  // namespace

void drawTimePanel(const Session& session, const TimingHistory& history) {
  if (!controls::section("Time", false)) return;
  drawStacks(history);
  const double total = history.medianTotal();
  ImGui::TextWrapped("%.2f ms on the device, %.1f frames a second", total,
                     total > 0 ? 1000 / total : 0);
  if (session.report) {
    const RenderReport& report = *session.report;
    controls::text(report.device.name);
    ImGui::Text("%zu triangles, %zu sources", report.triangles, report.sources);
    if (report.clusters > 0) ImGui::Text("%zu clusters", report.clusters);
    ImGui::Text("%.0f MB of the device's memory", report.peakMemoryMegabytes);
  }
  if (!ImGui::BeginTable("passes", 3, ImGuiTableFlags_SizingFixedFit)) return;
  for (std::size_t pass = 0; pass < history.passes().size(); ++pass) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushStyleColor(ImGuiCol_Text, colorOf(pass));
    ImGui::TextUnformatted("#");
    ImGui::PopStyleColor();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(history.passes()[pass].c_str());
    ImGui::TableNextColumn();
    ImGui::Text("%8.2f ms", history.median(pass));
  }
  ImGui::EndTable();
}

}  // namespace opaline::app::viewer
