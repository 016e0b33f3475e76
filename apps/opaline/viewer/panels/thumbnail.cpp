#include "viewer/panels/thumbnail.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>

#include "viewer/panels/controls.h"

namespace opaline::app::viewer {

namespace {

// Few enough cells to be drawn as rectangles.
constexpr int cellsOfEdge = 20;
using Cells = std::array<ImU32, std::size_t{cellsOfEdge} * cellsOfEdge>;

ImU32 meanOf(const TexturePixels& pixels, int left, int top, int right, int bottom) {
  std::array<double, 3> sum{};
  for (int y = top; y < bottom; ++y)
    for (int x = left; x < right; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        sum[c] +=
            pixels.rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(pixels.width) +
                             static_cast<std::size_t>(x)) +
                        c];
  const double count = (right - left) * (bottom - top);
  const auto byte = [&](std::size_t c) { return static_cast<int>(sum[c] / count / 257 + 0.5); };
  return IM_COL32(byte(0), byte(1), byte(2), 255);
}

Cells cellsOf(const TexturePixels& pixels) {
  Cells cells{};
  const auto begin = [](int cell, int edge) { return cell * edge / cellsOfEdge; };
  const auto end = [&](int cell, int edge) {
    return std::max(begin(cell + 1, edge), begin(cell, edge) + 1);
  };
  for (int y = 0; y < cellsOfEdge; ++y)
    for (int x = 0; x < cellsOfEdge; ++x)
      cells[static_cast<std::size_t>(y * cellsOfEdge + x)] =
          meanOf(pixels, begin(x, pixels.width), begin(y, pixels.height), end(x, pixels.width),
                 end(y, pixels.height));
  return cells;
}

// The cells of a texture, kept as long as the texture exists.
const Cells& known(const std::shared_ptr<const TexturePixels>& pixels) {
  static std::map<std::weak_ptr<const TexturePixels>, Cells, std::owner_less<>> all;
  const auto found = all.find(pixels);
  if (found != all.end()) return found->second;
  std::erase_if(all, [](const auto& entry) { return entry.first.expired(); });
  return all.emplace(pixels, cellsOf(*pixels)).first->second;
}

}  // namespace

void drawThumbnail(const std::shared_ptr<const TexturePixels>& pixels, const char* about) {
  const float edge = 4 * ImGui::GetFontSize();
  const Cells& cells = known(pixels);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::Dummy({edge, edge});
  controls::tip(about);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (int y = 0; y < cellsOfEdge; ++y)
    for (int x = 0; x < cellsOfEdge; ++x) {
      const auto place = [&](int i, float from) {
        return from + edge * static_cast<float>(i) / cellsOfEdge;
      };
      list.AddRectFilled({place(x, corner.x), place(y, corner.y)},
                         {place(x + 1, corner.x), place(y + 1, corner.y)},
                         cells[static_cast<std::size_t>(y * cellsOfEdge + x)]);
    }
}

}  // namespace opaline::app::viewer
