#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/measures.h"
#include "opaline/half_space.h"
#include "opaline/media.h"
#include "opaline/tone.h"
#include "viewer/panels/controls.h"
#include "viewer/panels/panels.h"

namespace opaline::app::viewer {

namespace {

struct Chip {
  Medium medium;
  ImVec4 color;  ///< reflected colour of a thick piece in white light, sRGB
};

ImVec4 chipColorOf(const Medium& medium) {
  const std::array<double, 3> reflectance = reflectanceWithin(medium, Transport::BetterDipole);
  std::array<float, 3> encoded{};
  for (std::size_t c = 0; c < 3; ++c) {
    encoded[c] = encodeSrgb(std::clamp(static_cast<float>(reflectance[c]), 0.0F, 1.0F));
  }
  return {encoded[0], encoded[1], encoded[2], 1};
}

const std::vector<Chip>& chips() {
  static const std::vector<Chip> made = [] {
    std::vector<Chip> list;
    for (const Medium& medium : artisticMedia()) list.push_back({medium, chipColorOf(medium)});
    for (const auto& row : measuredMedia()) {
      list.push_back({row.medium, chipColorOf(row.medium)});
    }
    return list;
  }();
  return made;
}

bool isOf(const Chip& chip, const Medium& medium) {
  return chip.medium == medium;
}

// Draws a ring around the control drawn last.
void drawRing() {
  const float gap = 0.14F * ImGui::GetFontSize();
  const ImVec2 low = ImGui::GetItemRectMin();
  const ImVec2 high = ImGui::GetItemRectMax();
  ImGui::GetWindowDrawList()->AddRect({low.x - gap, low.y - gap}, {high.x + gap, high.y + gap},
                                      IM_COL32(255, 255, 255, 255),
                                      ImGui::GetStyle().FrameRounding + gap, 0, 0.75F * gap);
}

bool drawChips(Medium& medium) {
  bool chosen = false;
  const float edge = 1.35F * ImGui::GetFontSize();
  const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
  for (const Chip& chip : chips()) {
    ImGui::PushID(chip.medium.name.c_str());
    if (ImGui::ColorButton(chip.medium.name.c_str(), chip.color,
                           ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_NoDragDrop,
                           {edge, edge})) {
      medium = chip.medium;
      chosen = true;
    }
    if (isOf(chip, medium)) drawRing();
    controls::note(chip.medium.name.c_str());
    controls::tip(chip.medium.name.c_str());
    ImGui::PopID();
    const float next = ImGui::GetItemRectMax().x + ImGui::GetStyle().ItemSpacing.x + edge;
    if (&chip != &chips().back() && next < right) ImGui::SameLine();
  }
  return chosen;
}

bool drawCoefficients(const char* name, std::array<double, 3>& perMm, double low, double high,
                      const char* about) {
  constexpr std::array<const char*, 3> channels{"red", "green", "blue"};
  bool changed = false;
  ImGui::TextUnformatted(name);
  controls::tip(about);
  for (std::size_t c = 0; c < 3; ++c) {
    const std::string label = fmt::format("{}##{}", channels[c], name);
    changed |= controls::slider(label.c_str(), perMm[c], low, high, "%.4g /mm", about);
  }
  return changed;
}

// The size takes effect when the mouse lets go, since every size means loading the scene anew.
void drawBodySize(Session& session) {
  float mm = session.draggedDiagonalMm.value_or(session.diagonalMm);
  const float least = std::min(1.0F, session.diagonalMm / 10);
  const float most = std::max(10'000.0F, 10 * session.diagonalMm);
  if (controls::length("size", mm, least, most,
                       "Diagonal of the model's box. In one medium light reaches equally far into "
                       "small and large bodies, so size decides how translucent they look.")) {
    session.draggedDiagonalMm = mm;
  }
  if (!session.draggedDiagonalMm || ImGui::IsItemActive()) return;
  session.wantedDiagonalMm = std::exchange(session.draggedDiagonalMm, std::nullopt);
}

void showLengths(const Medium& medium) {
  const MediumLengths lengths = lengthsOf(medium);
  if (!ImGui::BeginTable("lengths", 4, ImGuiTableFlags_SizingStretchSame)) return;
  ImGui::TableSetupColumn("length", ImGuiTableColumnFlags_WidthStretch, 2.4F);
  const auto row = [](const char* name, const std::array<double, 3>& mm) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextWrapped("%s, mm", name);
    for (const double value : mm) {
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(lengthNumber(value).c_str());
    }
  };
  row("transport mean free path", lengths.meanFreePathMm);
  row("diffusion length", lengths.diffusionMm);
  ImGui::EndTable();
}

bool drawMedium(Medium& medium) {
  controls::text(medium.name);
  const bool chosen = drawChips(medium);
  const bool scatters =
      drawCoefficients("scattering", medium.sigmaSPrimePerMm, 1e-3, 1e2,
                       "Reduced scattering coefficient: how often light is deflected within a "
                       "millimetre. More is more opaque. Jensen et al. 2001, Figure 5.");
  const bool absorbs = drawCoefficients(
      "absorption", medium.sigmaAPerMm, 1e-5, 1e1,
      "Absorption coefficient: how much of the light is absorbed within a millimetre. "
      "More is darker, and more saturated where it differs between channels.");
  const bool bent = controls::slider("index of refraction", medium.eta, 1.01, 2.5, "%.3f",
                                     "Of the body relative to what surrounds it: 1.3 is water, "
                                     "1.5 glass. More keeps more light inside.");
  const bool forward = controls::slider("forward scattering", medium.g, -0.99, 0.99, "%.2f",
                                        "Mean cosine of scattering, g: 0 is even, 0.9 is like skin "
                                        "or milk. It changes what scattered a few times; the "
                                        "coefficients above are reduced by it.");
  const bool edited = scatters || absorbs || bent || forward;
  if (edited) medium.name = "custom";
  return chosen || edited;
}

}  // namespace

void chooseObject(Session& session) {
  std::vector<std::string> names;
  for (const Object& object : session.scene.objects)
    if (!object.isGround) names.push_back(object.name);
  if (names.size() < 2) return;
  auto index = static_cast<int>(session.object);
  if (controls::choice("object", index, names, "The object that this panel shows."))
    session.object = static_cast<std::size_t>(index);
}

void drawMediumPanel(Session& session) {
  if (!controls::section("Medium", true) || session.scene.objects.empty()) return;
  chooseObject(session);
  Object& object = session.scene.objects[session.object];
  if (object.opaque)
    controls::text("opaque: see Material");
  else if (drawMedium(object.medium))
    session.edits.material[session.object] = true;
  drawBodySize(session);
  if (!object.opaque) showLengths(object.medium);
}

}  // namespace opaline::app::viewer
