#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "methods.h"

namespace opaline::app {

namespace {

// The sheet, in SVG units.
constexpr double sheetWidth = 720;
constexpr double sheetHeight = 480;
constexpr double left = 84;
constexpr double right = 180;
constexpr double top = 44;
constexpr double bottom = 60;

/// Whole decades that hold all values.
struct Decades {
  double least = 1e300;
  double most = -1e300;

  void add(double value) {
    if (!(value > 0)) return;
    least = std::min(least, std::floor(std::log10(value)));
    most = std::max(most, std::ceil(std::log10(value) + 1e-9));
  }
  double share(double value) const {
    return (std::log10(std::max(value, 1e-300)) - least) / (most - least);
  }
};

class Sheet {
 public:
  explicit Sheet(const Methods& methods) {
    for (const MethodRow& row : methods.rows) {
      if (!row.frameMilliseconds) continue;
      cost_.add(*row.frameMilliseconds);
      for (const auto& error : {row.integralError, row.truthError})
        if (error) error_.add(*error);
    }
    text_ = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" "
        "font-family=\"sans-serif\" font-size=\"13\">\n"
        "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
        "<text x=\"{}\" y=\"26\" font-size=\"15\">{}: error of exitance against the time of a "
        "frame</text>\n",
        sheetWidth, sheetHeight, left, methods.scene);
  }

  bool empty() const { return cost_.most < cost_.least || error_.most < error_.least; }

  void addGrid() {
    for (double decade = cost_.least; decade <= cost_.most; decade += 1)
      addLine(x(std::pow(10, decade)), top, x(std::pow(10, decade)), sheetHeight - bottom,
              fmt::format("{:g} ms", std::pow(10, decade)), true);
    for (double decade = error_.least; decade <= error_.most; decade += 1)
      addLine(left, y(std::pow(10, decade)), sheetWidth - right, y(std::pow(10, decade)),
              fmt::format("{:g} %", 100 * std::pow(10, decade)), false);
  }

  /// Colour for the transport, shape for the site, full against the integral and open against
  /// truth.
  void addRow(const MethodRow& row) {
    if (!row.frameMilliseconds) return;
    const std::size_t transport = row.transport == Transport::Dipole ? 0 : 1;
    const double at = x(*row.frameMilliseconds);
    if (row.integralError && *row.integralError > 0)
      addMark(at, y(*row.integralError), transport, row.site == "vertex", true);
    if (row.truthError && *row.truthError > 0)
      addMark(at, y(*row.truthError), transport, row.site == "vertex", false);
  }

  void addLegend(const Methods& methods) {
    double line = top + 8;
    const auto entry = [&](const std::string& label, std::size_t transport, bool vertex,
                           bool full) {
      addMark(sheetWidth - right + 22, line, transport, vertex, full);
      addText(sheetWidth - right + 36, line + 4, "start", label);
      line += 22;
    };
    entry("dipole", 0, false, true);
    entry("better-dipole", 1, false, true);
    entry("at fragments", 2, false, true);
    entry("at vertices", 2, true, true);
    entry("to the integral", 2, false, true);
    entry("to the truth", 2, false, false);
    for (const char* const sum : {"pattern", "all"})
      if (const auto found = std::find_if(
              methods.rows.begin(), methods.rows.end(),
              [&](const MethodRow& row) { return row.sum == sum && row.frameMilliseconds; });
          found != methods.rows.end())
        addText(x(*found->frameMilliseconds), top + 16, "middle", sum);
  }

  std::string finished() && { return std::move(text_) + "</svg>\n"; }

 private:
  double x(double milliseconds) const {
    return left + (sheetWidth - left - right) * cost_.share(milliseconds);
  }
  double y(double error) const {
    return sheetHeight - bottom - (sheetHeight - top - bottom) * error_.share(error);
  }
  void addMark(double atX, double atY, std::size_t colour, bool diamond, bool full) {
    constexpr std::array colours{"#2b5fc0", "#c8372d", "#555"};
    const std::string style = fmt::format("stroke=\"{}\" stroke-width=\"1.5\" fill=\"{}\"",
                                          colours[colour], full ? colours[colour] : "none");
    text_ +=
        diamond
            ? fmt::format("<path d=\"M{:.1f} {:.1f}l6 6l-6 6l-6 -6z\" {}/>\n", atX, atY - 6, style)
            : fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"5\" {}/>\n", atX, atY, style);
  }
  void addText(double atX, double atY, const char* anchor, const std::string& text) {
    text_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", atX, atY,
                         anchor, text);
  }
  void addLine(double x1, double y1, double x2, double y2, const std::string& label, bool upright) {
    text_ += fmt::format(
        "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"#ccc\"/>\n"
        "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n",
        x1, y1, x2, y2, upright ? x1 : left - 8, upright ? sheetHeight - bottom + 20 : y1 + 4,
        upright ? "middle" : "end", label);
  }

  Decades cost_;
  Decades error_;
  std::string text_;
};

}  // namespace

std::string plotSvg(const Methods& methods) {
  Sheet sheet(methods);
  if (!sheet.empty()) {
    sheet.addGrid();
    for (const MethodRow& row : methods.rows) sheet.addRow(row);
    sheet.addLegend(methods);
  }
  return std::move(sheet).finished();
}

}  // namespace opaline::app
