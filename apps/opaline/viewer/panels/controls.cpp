#include "viewer/panels/controls.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <utility>

#include "viewer/window/glyphs.h"

namespace opaline::app::viewer::controls {

namespace {

std::vector<Place> noted;
std::string within;
Sections sections;

// Leaves room for the name to the right of the next control. A name that would leave the control
// too little goes above it. The returned label of the control hides the name then.
std::string leaveRoomFor(const char* name) {
  const float line = ImGui::GetContentRegionAvail().x;
  const float usual = 0.38F * line;
  const float needed =
      ImGui::CalcTextSize(name, nullptr, true).x + ImGui::GetStyle().ItemInnerSpacing.x;
  const float least = 7 * ImGui::GetFontSize();
  if (needed > usual && line - needed < least) {
    const std::string_view all = name;
    ImGui::TextWrapped("%s", std::string(all.substr(0, all.find("##"))).c_str());
    ImGui::SetNextItemWidth(line);
    return "##" + std::string(all);
  }
  ImGui::SetNextItemWidth(line - std::max(usual, needed));
  return name;
}

bool escapes() {
  return ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
}

template <typename Number>
bool slide(const char* name, ImGuiDataType type, Number& value, Number low, Number high,
           const char* format, const char* about) {
  const std::string label = leaveRoomFor(name);
  const bool wide = low > 0 && high >= 1000 * low;
  const bool changed =
      ImGui::SliderScalar(label.c_str(), type, &value, &low, &high, format,
                          wide ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None);
  note(name);
  tip(about);
  // A typed number may lie outside the range.
  if (changed) value = std::isfinite(value) ? std::clamp(value, low, high) : low;
  return changed;
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
  if (text == nullptr || ImGui::IsItemActive() ||
      !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) {
    return;
  }
  // The tooltip goes below its control, or above. It covers neither the control nor the way of the
  // mouse.
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const ImVec2 padding = ImGui::GetStyle().WindowPadding;
  const float gap = 0.3F * ImGui::GetFontSize();
  const float wrap = std::min(22 * ImGui::GetFontSize(), screen.x - 2 * (padding.x + gap));
  const ImVec2 written = ImGui::CalcTextSize(text, nullptr, false, wrap);
  const ImVec2 size(written.x + 2 * padding.x, written.y + 2 * padding.y);
  const ImVec2 low = ImGui::GetItemRectMin();
  const float beneath = ImGui::GetItemRectMax().y + gap;
  const float above = low.y - gap - size.y;
  const bool fits = beneath + size.y <= screen.y || above < 0;
  ImGui::SetNextWindowPos(
      {std::max(0.0F, std::min(low.x, screen.x - size.x - gap)), fits ? beneath : above});
  // As clear beside a control that is disabled, which is drawn half transparent.
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 1.0F);
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(padding.x + wrap);
  ImGui::TextUnformatted(text);
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
}

void text(const std::string& shown) {
  glyphs::want(shown);
  ImGui::TextWrapped("%s", shown.c_str());
}

void hint(const std::string& shown) {
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
  text(shown);
  ImGui::PopStyleColor();
}

void sameLineFor(const char* next) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
  const float width = ImGui::CalcTextSize(next, nullptr, true).x + 2 * style.FramePadding.x;
  if (ImGui::GetItemRectMax().x + style.ItemSpacing.x + width <= right) ImGui::SameLine();
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
  return slide(name, ImGuiDataType_Float, value, low, high, format, about);
}

bool slider(const char* name, double& value, double low, double high, const char* format,
            const char* about) {
  return slide(name, ImGuiDataType_Double, value, low, high, format, about);
}

bool length(const char* name, float& mm, float lowMm, float highMm, const char* about) {
  // %g would write it as 1.7658e+05.
  return slider(name, mm, lowMm, highMm, std::abs(mm) < 1e5F ? "%.5g mm" : "%.0f mm", about);
}

bool stops(const char* name, float& value, float low, float high, const char* about) {
  return slider(name, value, low, high, value == 0 ? "%.0f stops" : "%+.3g stops", about);
}

bool integer(const char* name, int& value, int low, int high, const char* about) {
  const std::string label = leaveRoomFor(name);
  const bool changed = ImGui::SliderInt(label.c_str(), &value, low, high);
  note(name);
  tip(about);
  if (changed) value = std::clamp(value, low, high);
  return changed;
}

std::optional<int> wholeNumber(std::string_view text, int low, int high) {
  const std::string whole(text);
  char* rest = nullptr;
  const double number = std::strtod(whole.c_str(), &rest);
  if (whole.empty() || *rest != '\0' || std::isnan(number)) return std::nullopt;
  return static_cast<int>(std::lround(std::clamp<double>(number, low, high)));
}

bool typed(const char* name, int& value, int low, int high, const char* about) {
  static std::array<char, 32> held{};  // text of the one field that is being typed in
  const std::string label = leaveRoomFor(name);
  std::array<char, 32> text{};
  fmt::format_to_n(text.begin(), text.size() - 1, "{}", value);
  const std::array<char, 32> before = text;
  ImGui::InputText(label.c_str(), text.data(), text.size(),
                   ImGuiInputTextFlags_CharsScientific | ImGuiInputTextFlags_AutoSelectAll);
  note(name);
  if (ImGui::IsItemActive()) held = text;
  const bool done = ImGui::IsItemDeactivatedAfterEdit();
  tip(about);
  if (!done || escapes()) return false;
  const auto& entered = text == before ? held : text;
  const int wanted = wholeNumber(entered.data(), low, high).value_or(value);
  const bool changed = wanted != value;
  value = wanted;
  return changed;
}

namespace {

// As many digits as the fields for three channels have room for.
const char* formatOf(float channel) {
  if (channel >= 1000) return "%.0f";
  if (channel >= 100) return "%.1f";
  return channel >= 10 ? "%.2f" : "%.3f";
}

// Three numbers beside each other. A step of the mouse changes a large number by more.
bool dragChannels(Rgb& value, float width, float most) {
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  constexpr std::array<const char*, 3> names{"##red", "##green", "##blue"};
  bool changed = false;
  for (std::size_t c = 0; c < 3; ++c) {
    const float speed = std::max(1.0F / 255, 0.005F * value[c]);
    ImGui::SetNextItemWidth(std::max(1.0F, (width - 3 * gap) / 3));
    changed |= ImGui::DragFloat(names[c], &value[c], speed, 0, most, formatOf(value[c]),
                                ImGuiSliderFlags_NoRoundToFormat);
    ImGui::SameLine(0, gap);
  }
  return changed;
}

bool editColor(const char* name, Rgb& value, ImGuiColorEditFlags flags, float most,
               const char* about) {
  const std::string label = leaveRoomFor(name);
  // Dear ImGui's own numbers have three decimals, for which strong light leaves no room.
  flags |= ImGuiColorEditFlags_Float | ImGuiColorEditFlags_NoOptions | ImGuiColorEditFlags_NoInputs;
  const float width = ImGui::CalcItemWidth() - ImGui::GetFrameHeight();
  ImGui::BeginGroup();
  ImGui::PushID(label.c_str());
  bool changed = dragChannels(value, width, most);
  ImGui::PopID();
  changed |= ImGui::ColorEdit3(label.c_str(), value.data(), flags);
  ImGui::EndGroup();
  note(name);
  tip(about);
  if (changed) {
    for (float& channel : value) {
      channel = std::isfinite(channel) ? std::clamp(channel, 0.0F, most) : 0;
    }
  }
  return changed;
}

}  // namespace

bool light(const char* name, Rgb& value, const char* about) {
  return editColor(name, value, ImGuiColorEditFlags_HDR, 1e6F, about);
}

bool color(const char* name, Rgb& value, const char* about) {
  return editColor(name, value, 0, 1, about);
}

bool choice(const char* name, int& chosen, const std::vector<std::string>& names,
            const char* about) {
  const std::string label = leaveRoomFor(name);
  for (const std::string& entry : names) glyphs::want(entry);
  const auto count = static_cast<int>(names.size());
  const char* present =
      chosen >= 0 && chosen < count ? names[static_cast<std::size_t>(chosen)].c_str() : "";
  const bool open = ImGui::BeginCombo(label.c_str(), present, ImGuiComboFlags_HeightLarge);
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
  if (escapes()) ImGui::CloseCurrentPopup();
  ImGui::EndCombo();
  return changed;
}

}  // namespace opaline::app::viewer::controls
