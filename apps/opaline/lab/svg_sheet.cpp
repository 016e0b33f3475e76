#include "lab/svg_sheet.h"

#include <fmt/format.h>

#include <cstddef>

namespace opaline::app {

namespace {

const char* codeOf(SvgColour colour) {
  constexpr std::array codes{"#2b5fc0", "#c8372d", "#2c8a4b", "#555"};
  return codes[static_cast<std::size_t>(colour)];
}

std::string gridLine(double x1, double y1, double x2, double y2) {
  return fmt::format(
      "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"#ccc\"/>\n", x1, y1,
      x2, y2);
}

}  // namespace

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '&') {
      result += "&amp;";
    } else if (c == '<') {
      result += "&lt;";
    } else {
      result += c;
    }
  }
  return result;
}

SvgSheet::SvgSheet(const SvgFrame& frame, const std::string& title)
    : frame_(frame),
      text_(fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" "
                        "font-family=\"sans-serif\" font-size=\"13\">\n"
                        "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
                        "<text x=\"{}\" y=\"26\" font-size=\"15\">{}</text>\n",
                        frame.width, frame.height, frame.left, escaped(title))) {}

void SvgSheet::addText(double x, double y, const char* anchor, const std::string& text) {
  text_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y,
                       anchor, escaped(text));
}

void SvgSheet::addMark(double x, double y, const SvgMark& mark) {
  const char* const code = codeOf(mark.colour);
  const std::string style = fmt::format("stroke=\"{}\" stroke-width=\"1.5\" fill=\"{}\"", code,
                                        mark.full ? code : "none");
  text_ += mark.shape == SvgShape::Diamond
               ? fmt::format("<path d=\"M{:.1f} {:.1f}l6 6l-6 6l-6 -6z\" {}/>\n", x, y - 6, style)
               : fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"5\" {}/>\n", x, y, style);
}

void SvgSheet::addLine(std::array<double, 2> from, std::array<double, 2> to, SvgColour colour,
                       bool dashed) {
  text_ += fmt::format(
      "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\"{}/>\n", from[0],
      from[1], to[0], to[1], codeOf(colour), dashed ? " stroke-dasharray=\"5 4\"" : "");
}

void SvgSheet::addUprightGridLine(double share, const std::string& label) {
  const double x = frame_.x(share);
  text_ += gridLine(x, frame_.y(1), x, frame_.y(0));
  addText(x, frame_.y(0) + 20, "middle", label);
}

void SvgSheet::addLevelGridLine(double share, const std::string& label) {
  const double y = frame_.y(share);
  text_ += gridLine(frame_.x(0), y, frame_.x(1), y);
  addText(frame_.x(0) - 8, y + 4, "end", label);
}

}  // namespace opaline::app
