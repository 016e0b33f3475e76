#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "lab/scaling.h"
#include "lab/svg_sheet.h"

namespace opaline::app {

namespace {

/// 1, 2 or 5 times a power of ten, so that at most eight of it reach `most`.
double niceStep(double most) {
  const double power = std::pow(10, std::floor(std::log10(most / 8)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power * 8 >= most) return factor * power;
  return 10 * power;
}

/// Across, how far a series has gone from its first row, logarithmic; upwards, time as a multiple
/// of that row's.
class Plot {
 public:
  explicit Plot(const Scaling& scaling)
      : sheet_(frame_, scaling.scene + ": time against what makes the tree's sum harder") {
    for (const auto* rows : {&scaling.budgets, &scaling.diffusion, &scaling.tolerances})
      for (const ScalingRow& row : *rows) {
        mostDecades_ = std::max(mostDecades_, std::log10(hardness(row, rows->front())));
        for (const double times : timesOf(row, rows->front())) most_ = std::max(most_, times);
      }
    mostDecades_ = std::ceil(mostDecades_ - 1e-9);
    const double step = niceStep(most_);
    most_ = step * std::ceil(most_ / step);
    for (double decade = 0; decade <= mostDecades_; decade += 1)
      sheet_.addUprightGridLine(decade / mostDecades_, fmt::format("×{:g}", std::pow(10, decade)));
    for (int i = 0; i * step <= most_ * (1 + 1e-9); ++i)
      sheet_.addLevelGridLine(i * step / most_, fmt::format("{:g}", i * step));
    sheet_.addText((frame_.x(0) + frame_.x(1)) / 2, frame_.height - 16, "middle",
                   "more surfels, smaller σ_tr, smaller tolerance");
  }

  void addSeries(const std::vector<ScalingRow>& rows, const char* name, SvgColour colour) {
    for (const bool full : {true, false})
      for (std::size_t i = 0; i < rows.size(); ++i) {
        const std::array<double, 2> to = place(rows[i], rows[0], full);
        if (i > 0) sheet_.addLine(place(rows[i - 1], rows[0], full), to, colour, !full);
        sheet_.addMark(to[0], to[1], {colour, SvgShape::Disc, full});
      }
    addEntry(name, {colour});
  }

  void addLegend() {
    addEntry("the sum", {SvgColour::Grey, SvgShape::Disc, true});
    addEntry("the frame", {SvgColour::Grey, SvgShape::Disc, false});
  }

  std::string finished() && { return std::move(sheet_).finished(); }

 private:
  static double hardness(const ScalingRow& row, const ScalingRow& first) {
    const double times = row.value / first.value;
    return std::max(times, 1 / times);
  }
  static std::array<double, 2> timesOf(const ScalingRow& row, const ScalingRow& first) {
    return {row.scatterMilliseconds / std::max(first.scatterMilliseconds, 1e-9),
            row.frameMilliseconds / std::max(first.frameMilliseconds, 1e-9)};
  }
  std::array<double, 2> place(const ScalingRow& row, const ScalingRow& first, bool sum) const {
    return {frame_.x(std::log10(hardness(row, first)) / mostDecades_),
            frame_.y(timesOf(row, first)[sum ? 0 : 1] / most_)};
  }
  void addEntry(const char* label, const SvgMark& mark) {
    sheet_.addMark(frame_.x(1) + 22, line_, mark);
    sheet_.addText(frame_.x(1) + 36, line_ + 4, "start", label);
    line_ += 22;
  }

  SvgFrame frame_;
  SvgSheet sheet_;
  double mostDecades_ = 1;
  double most_ = 1;
  double line_ = frame_.top + 8;  ///< of the legend
};

}  // namespace

std::string plotSvg(const Scaling& scaling) {
  Plot plot(scaling);
  plot.addSeries(scaling.budgets, "surfels", SvgColour::Blue);
  plot.addSeries(scaling.diffusion, "smaller σ_tr", SvgColour::Red);
  plot.addSeries(scaling.tolerances, "tolerance", SvgColour::Green);
  plot.addLegend();
  return std::move(plot).finished();
}

}  // namespace opaline::app
