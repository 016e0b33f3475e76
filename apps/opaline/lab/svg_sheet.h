#pragma once

#include <array>
#include <string>

namespace opaline::app {

/// With the characters that XML keeps for itself written as entities.
std::string escaped(const std::string& text);

/// Where a plot's axes run on its sheet, in SVG units; the legend stands to the right of them.
struct SvgFrame {
  double width = 720;
  double height = 480;
  double left = 84;
  double right = 180;
  double top = 44;
  double bottom = 60;

  /// From shares of the axes, 0 at the left and at the bottom.
  double x(double share) const { return left + (width - left - right) * share; }
  double y(double share) const { return height - bottom - (height - top - bottom) * share; }
};

/// Colours that series of a plot have, and grey for what belongs to all.
enum class SvgColour { Blue, Red, Green, Grey };
enum class SvgShape { Disc, Diamond };

/// A mark as legends and points show it.
struct SvgMark {
  SvgColour colour = SvgColour::Grey;
  SvgShape shape = SvgShape::Disc;
  bool full = true;
};

/// A sheet that is drawn on from back to front.
class SvgSheet {
 public:
  SvgSheet(const SvgFrame& frame, const std::string& title);

  void addText(double x, double y, const char* anchor, const std::string& text);
  void addMark(double x, double y, const SvgMark& mark);
  /// From one point to another.
  void addLine(std::array<double, 2> from, std::array<double, 2> to, SvgColour colour,
               bool dashed = false);
  /// Across the frame at that share of an axis, with a label where it begins.
  void addUprightGridLine(double share, const std::string& label);
  void addLevelGridLine(double share, const std::string& label);

  std::string finished() && { return std::move(text_) + "</svg>\n"; }

 private:
  SvgFrame frame_;
  std::string text_;
};

}  // namespace opaline::app
