#include "viewer/controls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace opaline::app::viewer::controls {

namespace {

std::vector<Place> noted;
std::string within;
Sections sections;

// Room for the names to the right of the controls.
void leaveRoomForNames() {
  ImGui::SetNextItemWidth(-0.38F * ImGui::GetWindowContentRegionMax().x);
}

}  // namespace

void beginFrame() {
  noted.clear();
  within.clear();
}

const std::vector<Place>& places() {
  return noted;
}

void note(const char* name) {
  if (!ImGui::IsItemVisible()) return;
  const ImVec2 low = ImGui::GetItemRectMin();
  const ImVec2 size = ImGui::GetItemRectSize();
  noted.push_back({within.empty() ? name : within + "/" + name, low.x, low.y, size.x, size.y});
}

void tip(const char* text) {
  if (text == nullptr || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(22 * ImGui::GetFontSize());
  ImGui::TextUnformatted(text);
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

bool section(const char* name, bool open) {
  within.clear();
  const auto known = sections.try_emplace(name, open).first;
  ImGui::SetNextItemOpen(known->second, ImGuiCond_Once);
  known->second = ImGui::CollapsingHeader(name);
  note(name);
  within = name;
  return known->second;
}

Sections openSections() {
  return sections;
}

void setOpenSections(const Sections& open) {
  sections = open;
}

Group::Group(const char* name) : before_(std::exchange(within, name)) {}

Group::~Group() {
  within = std::move(before_);
}

bool button(const char* name, const char* about) {
  const bool pressed = ImGui::Button(name);
  note(name);
  tip(about);
  return pressed;
}

bool checkbox(const char* name, bool& on, const char* about) {
  const bool changed = ImGui::Checkbox(name, &on);
  note(name);
  tip(about);
  return changed;
}

bool slider(const char* name, float& value, float low, float high, const char* format,
            const char* about) {
  leaveRoomForNames();
  const bool wide = low > 0 && high >= 1000 * low;
  const bool changed = ImGui::SliderFloat(
      name, &value, low, high, format, wide ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None);
  note(name);
  tip(about);
  // A number that was typed may lie outside.
  if (changed) value = std::isfinite(value) ? std::clamp(value, low, high) : low;
  return changed;
}

bool integer(const char* name, int& value, int low, int high, const char* about) {
  leaveRoomForNames();
  const bool changed = ImGui::SliderInt(name, &value, low, high);
  note(name);
  tip(about);
  if (changed) value = std::clamp(value, low, high);
  return changed;
}

bool typed(const char* name, int& value, int low, int high, const char* about) {
  static int held = 0;  // of the one field that is typed in
  leaveRoomForNames();
  int now = value;
  ImGui::InputInt(name, &now, 0, 0);
  note(name);
  if (ImGui::IsItemActive()) held = now;
  const bool done = ImGui::IsItemDeactivatedAfterEdit();
  tip(about);
  if (!done) return false;
  const int wanted = std::clamp(now == value ? held : now, low, high);
  const bool changed = wanted != value;
  value = wanted;
  return changed;
}

bool light(const char* name, Rgb& value, const char* about) {
  leaveRoomForNames();
  constexpr ImGuiColorEditFlags flags =
      ImGuiColorEditFlags_HDR | ImGuiColorEditFlags_Float | ImGuiColorEditFlags_NoOptions;
  const bool changed = ImGui::ColorEdit3(name, value.data(), flags);
  note(name);
  tip(about);
  if (changed) {
    for (float& channel : value) {
      channel = std::isfinite(channel) ? std::clamp(channel, 0.0F, 1e6F) : 0;
    }
  }
  return changed;
}

bool choice(const char* name, int& chosen, const std::vector<std::string>& names,
            const char* about) {
  leaveRoomForNames();
  const auto count = static_cast<int>(names.size());
  const char* present =
      chosen >= 0 && chosen < count ? names[static_cast<std::size_t>(chosen)].c_str() : "";
  const bool open = ImGui::BeginCombo(name, present, ImGuiComboFlags_HeightLarge);
  note(name);
  if (!open) {
    tip(about);
    return false;
  }
  bool changed = false;
  for (int i = 0; i < count; ++i) {
    const std::string& text = names[static_cast<std::size_t>(i)];
    if (ImGui::Selectable(text.c_str(), i == chosen)) {
      changed = i != chosen;
      chosen = i;
    }
    note((std::string(name) + "/" + text).c_str());
  }
  ImGui::EndCombo();
  return changed;
}

}  // namespace opaline::app::viewer::controls
