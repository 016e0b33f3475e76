#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "methods.h"
#include "picture_options.h"

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

  void addRow(const MethodRow& row) {
    if (!row.frameMilliseconds) return;
    const char* const colour = row.transport == Transport::Dipole ? "#2b5fc0" : "#c8372d";
    const auto mark = [&](const std::optional<double>& error, bool full) {
      if (!error || !(*error > 0)) return;
      text_ += fmt::format(
          "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"5\" stroke=\"{}\" stroke-width=\"1.5\" "
          "fill=\"{}\"/>\n<text x=\"{:.1f}\" y=\"{:.1f}\" fill=\"{}\">{}, {}, {}</text>\n",
          x(*row.frameMilliseconds), y(*error), colour, full ? colour : "white",
          x(*row.frameMilliseconds) + 9, y(*error) + (full ? 4 : -6), colour,
          nameOf(row.transport, transports()), row.sum, row.site);
    };
    mark(row.integralError, true);
    mark(row.truthError, false);
  }

  std::string finished() && { return std::move(text_) + "</svg>\n"; }

 private:
  double x(double milliseconds) const {
    return left + (sheetWidth - left - right) * cost_.share(milliseconds);
  }
  double y(double error) const {
    return sheetHeight - bottom - (sheetHeight - top - bottom) * error_.share(error);
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
  }
  return std::move(sheet).finished();
}

}  // namespace opaline::app
