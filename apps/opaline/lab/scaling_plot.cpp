#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "lab/scaling.h"
#include "lab/svg_sheet.h"

namespace opaline::app {

namespace {

/// Times of a part and of the frame, and how far the series has gone from its first row.
struct Point {
  double hardness;
  double part;
  double frame;
};
using Series = std::vector<Point>;

Series seriesOf(const std::vector<ScalingRow>& rows) {
  Series series;
  for (const ScalingRow& row : rows)
    series.push_back({std::max(row.value / rows[0].value, rows[0].value / row.value),
                      row.scatterMilliseconds, row.frameMilliseconds});
  return series;
}

Series seriesOf(const FrameScaling& frames) {
  Series series;
  for (const FrameScalingRow& row : frames.rows)
    series.push_back({row.value / std::max(frames.rows[0].value, 1.0), row.partMilliseconds,
                      row.frameMilliseconds});
  return series;
}

/// The horizontal axis shows how far a series has gone from its first row, the vertical one time as
/// a multiple of that row's. Both are logarithmic, so that a power is a straight line.
class ScalingPlot {
 public:
  ScalingPlot(const Scaling& scaling, const std::vector<Series>& all)
      : sheet_(frame_, scaling.scene + ": time against what makes a frame harder") {
    for (const Series& series : all)
      for (const Point& point : series) {
        mostDecades_ = std::max(mostDecades_, std::log10(std::max(point.hardness, 1.0)));
        for (const bool part : {true, false})
          most_ = std::max(most_, timesOf(point, series.front(), part));
      }
    mostDecades_ = std::ceil(mostDecades_ - 1e-9);
    for (double decade = 0; decade <= mostDecades_; decade += 1)
      sheet_.addUprightGridLine(decade / mostDecades_, fmt::format("×{:g}", std::pow(10, decade)));
    for (double times = least; times <= most_ * 2; times *= 2)
      sheet_.addLevelGridLine(height(times), fmt::format("{:g}", times));
    sheet_.addText((frame_.x(0) + frame_.x(1)) / 2, frame_.height - 16, "middle",
                   "more of each, or less");
  }

  void addSeries(const Series& series, const std::string& name, const SvgMark& mark) {
    for (const bool part : {true, false})
      for (std::size_t i = 0; i < series.size(); ++i) {
        const std::array<double, 2> to = place(series[i], series[0], part);
        if (i > 0) sheet_.addLine(place(series[i - 1], series[0], part), to, mark.colour, !part);
        sheet_.addMark(to[0], to[1], {mark.colour, mark.shape, part});
      }
    addEntry(name, mark);
  }

  void addLegend() {
    addEntry("its part", {SvgColour::Grey, SvgShape::Disc, true});
    addEntry("the frame", {SvgColour::Grey, SvgShape::Disc, false});
  }

  std::string finished() && { return std::move(sheet_).finished(); }

 private:
  static constexpr double least = 0.5;

  static double timesOf(const Point& point, const Point& first, bool part) {
    const double times =
        part ? point.part / std::max(first.part, 1e-9) : point.frame / std::max(first.frame, 1e-9);
    return std::max(times, least);
  }
  double height(double times) const {
    return std::log(times / least) / std::log(2 * most_ / least);
  }
  std::array<double, 2> place(const Point& point, const Point& first, bool part) const {
    return {frame_.x(std::log10(std::max(point.hardness, 1.0)) / mostDecades_),
            frame_.y(height(timesOf(point, first, part)))};
  }
  void addEntry(const std::string& label, const SvgMark& mark) {
    sheet_.addMark(frame_.x(1) + 22, line_, mark);
    sheet_.addText(frame_.x(1) + 36, line_ + 4, "start", label);
    line_ += 22;
  }

  SvgFrame frame_;
  SvgSheet sheet_;
  double mostDecades_ = 1;
  double most_ = 1;
  double line_ = frame_.top + 8;  ///< next line of the legend
};

}  // namespace

std::string plotSvg(const Scaling& scaling) {
  const std::array<SvgColour, 4> colours{SvgColour::Blue, SvgColour::Red, SvgColour::Green,
                                         SvgColour::Grey};
  std::vector<Series> all{seriesOf(scaling.budgets), seriesOf(scaling.diffusion),
                          seriesOf(scaling.tolerances)};
  std::vector<std::string> names{"sum: surfels", "sum: smaller σ_tr", "sum: tolerance"};
  for (const FrameScaling& frames : scaling.frames) {
    all.push_back(seriesOf(frames));
    names.push_back(frames.partExponent
                        ? fmt::format("{}: power {:.2f}", frames.varied, *frames.partExponent)
                        : frames.varied);
  }
  ScalingPlot plot(scaling, all);
  constexpr std::size_t sums = 3;
  for (std::size_t i = 0; i < all.size(); ++i)
    plot.addSeries(all[i], names[i],
                   {colours.at(i < sums ? i : (i - sums) % colours.size()),
                    i < sums ? SvgShape::Disc : SvgShape::Diamond});
  plot.addLegend();
  return std::move(plot).finished();
}

}  // namespace opaline::app
