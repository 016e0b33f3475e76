#pragma once

#include <array>
#include <string>

namespace opaline::app {

/// The text with XML's special characters written as entities.
std::string escaped(const std::string& text);

/// Where a plot's axes lie on its sheet, in SVG units. The legend is to the right of them.
struct SvgFrame {
  double width = 720;
  double height = 480;
  double left = 84;
  double right = 180;
  double top = 44;
  double bottom = 60;

  /// Maps a share of an axis to the sheet; 0 is left or bottom.
  double x(double share) const { return left + (width - left - right) * share; }
  double y(double share) const { return height - bottom - (height - top - bottom) * share; }
};

/// Colours for the series of a plot, and grey for everything they share.
enum class SvgColour { Blue, Red, Green, Grey };
enum class SvgShape { Disc, Diamond };

/// A mark in a legend or at a point.
struct SvgMark {
  SvgColour colour = SvgColour::Grey;
  SvgShape shape = SvgShape::Disc;
  bool full = true;
};

/// A drawing surface. Later elements cover earlier ones.
class SvgSheet {
 public:
  SvgSheet(const SvgFrame& frame, const std::string& title);

  void addText(double x, double y, const char* anchor, const std::string& text);
  void addMark(double x, double y, const SvgMark& mark);
  void addLine(std::array<double, 2> from, std::array<double, 2> to, SvgColour colour,
               bool dashed = false);
  /// Each draws a line across the frame at that share of an axis, labelled where it begins.
  void addUprightGridLine(double share, const std::string& label);
  void addLevelGridLine(double share, const std::string& label);

  std::string finished() && { return std::move(text_) + "</svg>\n"; }

 private:
  SvgFrame frame_;
  std::string text_;
};

}  // namespace opaline::app
