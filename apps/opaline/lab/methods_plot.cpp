#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "lab/methods.h"
#include "lab/svg_sheet.h"

namespace opaline::app {

namespace {

/// The range of values, widened to whole decades.
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

SvgColour colourFor(Transport transport) {
  switch (transport) {
    case Transport::Dipole:
      return SvgColour::Blue;
    case Transport::BetterDipole:
      return SvgColour::Red;
    case Transport::Boundary:
      break;
  }
  return SvgColour::Green;
}

/// The colour shows the transport, the shape the site. Full marks are against the integral, open
/// ones against the truth.
SvgMark markFor(const MethodRow& row, bool full) {
  return {colourFor(row.transport), row.site == "vertex" ? SvgShape::Diamond : SvgShape::Disc,
          full};
}

class MethodsPlot {
 public:
  explicit MethodsPlot(const Methods& methods)
      : sheet_(frame_, methods.scene + ": error of exitance against the time of a frame") {
    for (const MethodRow& row : methods.rows) {
      if (!row.frameMilliseconds) continue;
      cost_.add(*row.frameMilliseconds);
      for (const auto& error : {row.integralError, row.truthError})
        if (error) error_.add(*error);
    }
  }

  bool empty() const { return cost_.most < cost_.least || error_.most < error_.least; }

  void addGrid() {
    for (double decade = cost_.least; decade <= cost_.most; decade += 1) {
      const double value = std::pow(10, decade);
      sheet_.addUprightGridLine(cost_.share(value), fmt::format("{:g} ms", value));
    }
    for (double decade = error_.least; decade <= error_.most; decade += 1) {
      const double value = std::pow(10, decade);
      sheet_.addLevelGridLine(error_.share(value), fmt::format("{:g} %", 100 * value));
    }
  }

  void addRow(const MethodRow& row) {
    if (!row.frameMilliseconds) return;
    for (const auto* error : {&row.integralError, &row.truthError})
      if (*error && **error > 0)
        sheet_.addMark(frame_.x(cost_.share(*row.frameMilliseconds)),
                       frame_.y(error_.share(**error)), markFor(row, error == &row.integralError));
  }

  /// Writes the name of a sum above its marks.
  void addName(const Methods& methods, const char* sum) {
    double x = 0;
    double highest = frame_.height;
    int rows = 0;
    for (const MethodRow& row : methods.rows) {
      if (row.sum != sum || !row.frameMilliseconds || !row.integralError) continue;
      x += frame_.x(cost_.share(*row.frameMilliseconds));
      highest = std::min(highest, frame_.y(error_.share(*row.integralError)));
      ++rows;
    }
    if (rows > 0) sheet_.addText(x / rows, highest - 12, "middle", sum);
  }

  void addLegend() {
    double line = frame_.top + 8;
    const auto entry = [&](const char* label, const SvgMark& mark) {
      sheet_.addMark(frame_.x(1) + 22, line, mark);
      sheet_.addText(frame_.x(1) + 36, line + 4, "start", label);
      line += 22;
    };
    entry("dipole", {SvgColour::Blue});
    entry("better-dipole", {SvgColour::Red});
    entry("boundary", {SvgColour::Green});
    entry("at fragments", {SvgColour::Grey, SvgShape::Disc});
    entry("at vertices", {SvgColour::Grey, SvgShape::Diamond});
    entry("to the integral", {SvgColour::Grey, SvgShape::Disc, true});
    entry("to the truth", {SvgColour::Grey, SvgShape::Disc, false});
  }

  std::string finished() && { return std::move(sheet_).finished(); }

 private:
  SvgFrame frame_;
  SvgSheet sheet_;
  Decades cost_;
  Decades error_;
};

}  // namespace

std::string plotSvg(const Methods& methods) {
  MethodsPlot plot(methods);
  if (!plot.empty()) {
    plot.addGrid();
    for (const MethodRow& row : methods.rows) plot.addRow(row);
    for (const char* const sum : {"pattern", "tree", "all"}) plot.addName(methods, sum);
    plot.addLegend();
  }
  return std::move(plot).finished();
}

}  // namespace opaline::app
