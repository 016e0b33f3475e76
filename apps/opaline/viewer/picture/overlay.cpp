#include "viewer/picture/overlay.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "cli/measures.h"
#include "cli/medium_options.h"
#include "opaline/half_space.h"
#include "viewer/window/glyphs.h"

namespace opaline::app::viewer {

namespace {

constexpr ImU32 ink = IM_COL32(235, 235, 235, 230);
constexpr ImU32 warning = IM_COL32(255, 138, 101, 255);
constexpr ImU32 shadow = IM_COL32(0, 0, 0, 170);
constexpr std::array<ImU32, 3> channelInk{IM_COL32(235, 96, 84, 255), IM_COL32(110, 200, 96, 255),
                                          IM_COL32(96, 140, 245, 255)};

// Wraps lines at `width`, if it is given.
void write(ImDrawList& list, const ImVec2& place, ImU32 color, const std::string& text,
           float width = 0) {
  const auto add = [&](const ImVec2& at, ImU32 tint) {
    list.AddText(nullptr, 0, at, tint, text.c_str(), nullptr, width);
  };
  add({place.x + 1, place.y + 1}, shadow);
  add(place, color);
}

// The largest of 1, 2 or 5 times a power of ten that is at most `limit`.
double roundBelow(double limit) {
  const double power = std::pow(10, std::floor(std::log10(limit)));
  for (const double step : {5.0, 2.0}) {
    if (step * power <= limit) return step * power;
  }
  return power;
}

void drawBar(ImDrawList& list, const ImVec2& from, float pixels, ImU32 color, float thick) {
  list.AddRectFilled({from.x - 1, from.y - thick / 2 - 1},
                     {from.x + pixels + 1, from.y + thick / 2 + 1}, shadow);
  list.AddRectFilled({from.x, from.y - thick / 2}, {from.x + pixels, from.y + thick / 2}, color);
}

// A dark background that keeps text readable on any picture.
void drawPlate(ImDrawList& list, const Box& text) {
  const float rim = 0.2F * ImGui::GetFontSize();
  list.AddRectFilled({text.x - rim, text.y - rim},
                     {text.x + text.width + rim, text.y + text.height + rim}, shadow, rim);
}

float widthOfCaptions(const Area& area) {
  const float margin = ImGui::GetFontSize();
  return std::max(static_cast<float>(area.width) - 2 * margin, margin);
}

float heightOf(const Caption& caption, float width) {
  return ImGui::CalcTextSize(caption.text.c_str(), nullptr, false, width).y +
         0.2F * ImGui::GetFontSize();
}

struct Key {
  const char* key;
  const char* does;
};

// The list lies over the middle of the picture, but not beyond the window. Where its lines do not
// fit they are wrapped, and the list can be scrolled.
void placeKeys(const Area& area, float naturalWidth) {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float width = std::min(naturalWidth, screen.x);
  const float middle = static_cast<float>(area.x) + 0.5F * static_cast<float>(area.width);
  const float left = std::clamp(middle - 0.5F * width, 0.0F, screen.x - width);
  ImGui::SetNextWindowSizeConstraints({width, 0}, {width, screen.y});
  ImGui::SetNextWindowPos({left, 0.5F * screen.y}, ImGuiCond_Always, {0, 0.5F});
}

}  // namespace

void drawScaleBar(const Session& session, const Projection& projection, const Area& area,
                  LabelLayout& labels) {
  if (session.scene.objects.empty()) return;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const double pixelMm = static_cast<double>(projection.pixelMm(projection.view().distanceMm));
  if (!(pixelMm > 0) || !std::isfinite(pixelMm)) return;
  const double room = 0.3 * area.width;
  const double lengthMm = roundBelow(room * pixelMm);
  const float line = 1.15F * ImGui::GetFontSize();
  const float left = static_cast<float>(area.x) + line;
  float y = static_cast<float>(area.y + area.height) - 3.4F * line;

  const Object& object = session.scene.objects[session.object];
  drawBar(list, {left, y}, static_cast<float>(lengthMm / pixelMm), ink, 3);
  float widest = 0;
  const auto name = [&](float from, const std::string& text) {
    write(list, {from + 8, y - 0.5F * ImGui::GetFontSize()}, ink, text);
    widest = std::max(widest, from + 8 + ImGui::CalcTextSize(text.c_str()).x - left);
  };
  const float top = y - 0.5F * line;
  name(left + static_cast<float>(lengthMm / pixelMm),
       fmt::format("{} of {} across", lengthText(lengthMm),
                   lengthText(static_cast<double>(session.diagonalMm))));
  const auto rows = [&](const char* what, const std::array<double, 3>& mm) {
    y += line;
    float longest = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      if (!std::isfinite(mm[c])) continue;
      const auto pixels = static_cast<float>(std::min(mm[c] / pixelMm, room));
      drawBar(list, {left, y + 4 * (static_cast<float>(c) - 1)}, std::max(pixels, 1.0F),
              channelInk[c], 2);
      longest = std::max(longest, pixels);
    }
    name(left + longest, what);
  };
  if (!object.opaque) {
    const MediumLengths lengths = lengthsOf(object.medium);
    rows("transport mean free path", lengths.meanFreePathMm);
    rows("diffusion length", lengths.diffusionMm);
  }
  labels.take({left, top, widest, y + 0.5F * line - top});
}

void drawDivider(const Session& session, const Area& area, LabelLayout& labels) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const float x = static_cast<float>(area.x) + session.divider * static_cast<float>(area.width);
  const auto top = static_cast<float>(area.y);
  const auto bottom = static_cast<float>(area.y + area.height);
  list.AddLine({x, top}, {x, bottom}, ink, 2);
  list.AddCircleFilled({x, 0.5F * (top + bottom)}, 0.5F * ImGui::GetFontSize(), ink);
  const float y = bottom - 1.5F * ImGui::GetFontSize();
  const auto name = [&](const std::string& text, bool onLeft) {
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    // A label that reached over the divider would name the other side.
    const float room =
        onLeft ? x - static_cast<float>(area.x) : static_cast<float>(area.x + area.width) - x;
    if (room < size.x + 10) return;
    const Box place = labels.place({onLeft ? x - size.x - 10 : x + 10, y, size.x, 1.15F * size.y});
    write(list, {place.x, place.y}, ink, text);
  };
  name("Gong et al. 2008", true);
  name("Opaline", false);
}

void drawLegend(const std::string& text, const Area& area, LabelLayout& labels) {
  const float margin = ImGui::GetFontSize();
  const float width = std::max(static_cast<float>(area.width) - 2 * margin, margin);
  const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, width);
  const float y = static_cast<float>(area.y + area.height) - 0.5F * margin - size.y;
  const Box place = labels.place({static_cast<float>(area.x) + margin, y, size.x, size.y});
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  drawPlate(list, place);
  write(list, {place.x, place.y}, ink, text, width);
}

void drawHeatScale(double top, const std::vector<Rgb>& colors, const Area& area,
                   LabelLayout& labels) {
  const float font = ImGui::GetFontSize();
  constexpr int steps = 2;  // so few that they keep apart in the smallest window
  std::array<std::string, steps + 1> numbers;
  float widest = 0;
  for (int i = 0; i <= steps; ++i) {
    std::string& number = numbers[static_cast<std::size_t>(i)];
    number = fmt::format("{:.4g} %", 100 * top * i / steps);
    widest = std::max(widest, ImGui::CalcTextSize(number.c_str()).x);
  }
  const float bar = 0.8F * font;
  const float width = 1.5F * bar + widest;
  const float height = std::min(12 * font, 0.5F * static_cast<float>(area.height));
  const Box place = labels.place({static_cast<float>(area.x + area.width) - width - font,
                                  static_cast<float>(area.y) + font, width, height + font});
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  drawPlate(list, place);
  const float bottom = place.y + 0.5F * font + height;
  const float step = height / static_cast<float>(colors.size());
  for (std::size_t i = 0; i < colors.size(); ++i) {
    const float low = bottom - step * static_cast<float>(i);
    const ImVec4 color(colors[i][0], colors[i][1], colors[i][2], 1);
    list.AddRectFilled({place.x, low - step}, {place.x + bar, low},
                       ImGui::ColorConvertFloat4ToU32(color));
  }
  for (int i = 0; i <= steps; ++i) {
    const float y = bottom - height * static_cast<float>(i) / steps;
    write(list, {place.x + 1.5F * bar, y - 0.5F * font}, ink, numbers[static_cast<std::size_t>(i)]);
  }
}

void drawCaptions(const std::vector<Caption>& captions, const Area& area) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const float width = widthOfCaptions(area);
  float y = static_cast<float>(area.y) + 0.7F * ImGui::GetFontSize();
  for (const Caption& caption : captions) {
    glyphs::want(caption.text);
    const ImVec2 size = ImGui::CalcTextSize(caption.text.c_str(), nullptr, false, width);
    drawPlate(list, {static_cast<float>(area.x) + ImGui::GetFontSize(), y, size.x, size.y});
    write(list, {static_cast<float>(area.x) + ImGui::GetFontSize(), y},
          caption.isError ? warning : ink, caption.text, width);
    y += heightOf(caption, width);
  }
}

Box boxOf(const std::vector<Caption>& captions, const Area& area) {
  const float width = widthOfCaptions(area);
  float height = 0;
  for (const Caption& caption : captions) height += heightOf(caption, width);
  if (height > 0) height += 0.7F * ImGui::GetFontSize();
  return {static_cast<float>(area.x), static_cast<float>(area.y), static_cast<float>(area.width),
          height};
}

void drawKeys(const Area& area) {
  constexpr std::array keys{Key{"drag", "turn about the scene; move a light by its handle"},
                            Key{"shift drag, middle drag", "move along the picture"},
                            Key{"wheel, right drag", "nearer, further"},
                            Key{"F", "see all of the scene"},
                            Key{"T", "turntable"},
                            Key{"Ctrl drag", "pull at the body; B: without Ctrl"},
                            Key{"space", "play, pause"},
                            Key{"left, right", "a frame back, a frame on"},
                            Key{"C", "compare with the paper's method"},
                            Key{"H", "handles of lights, scale bar"},
                            Key{"Tab", "hide the panels"},
                            Key{"Ctrl O", "open a model or a scene; or drop its file"},
                            Key{"Ctrl S", "save the scene under a name"},
                            Key{"Ctrl Z", "take the last edit back"},
                            Key{"Ctrl Shift Z, Ctrl Y", "do it again"},
                            Key{"S, P", "save the scene, the picture without asking"},
                            Key{"O, X", "exposure up, down by half a stop"},
                            Key{"?", "these keys"},
                            Key{"Ctrl Q", "leave"}};
  const auto longest = [&](const char* Key::*column) {
    float width = 0;
    for (const Key& key : keys) width = std::max(width, ImGui::CalcTextSize(key.*column).x);
    return width + 2 * ImGui::GetStyle().CellPadding.x;
  };
  const float keyWidth = longest(&Key::key);
  const float doesWidth = longest(&Key::does);
  placeKeys(area, keyWidth + doesWidth + 2 * ImGui::GetStyle().WindowPadding.x);
  constexpr ImGuiWindowFlags flags =
      ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
      ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav;
  ImGui::Begin("keys", nullptr, flags);
  if (ImGui::BeginTable("list", 2, ImGuiTableFlags_SizingStretchProp)) {
    ImGui::TableSetupColumn("key", ImGuiTableColumnFlags_WidthStretch, keyWidth);
    ImGui::TableSetupColumn("does", ImGuiTableColumnFlags_WidthStretch, doesWidth);
    for (const Key& key : keys) {
      ImGui::TableNextRow();
      ImGui::TableNextColumn();
      ImGui::TextWrapped("%s", key.key);
      ImGui::TableNextColumn();
      ImGui::TextWrapped("%s", key.does);
    }
    ImGui::EndTable();
  }
  ImGui::End();
}

}  // namespace opaline::app::viewer
