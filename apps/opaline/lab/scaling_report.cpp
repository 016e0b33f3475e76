#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lab/scaling.h"

namespace opaline::app {

namespace {

/// How much longer the sum over the tree may take where σ_tr is 100 times smaller.
constexpr double mostForSmallSigmaTr = 1.3;

double ratio(double value, double first) {
  return first > 0 ? value / first : 0;
}

/// How much time each doubling of the value since the previous row adds to the sum, as a share of
/// the first row's time. It is constant where time grows like a logarithm.
std::optional<double> growthPerDoubling(const std::vector<ScalingRow>& rows, std::size_t row) {
  if (row == 0) return std::nullopt;
  const double doublings = std::log2(static_cast<double>(rows[row].surfels) /
                                     static_cast<double>(rows[row - 1].surfels));
  if (doublings == 0) return std::nullopt;
  return ratio(rows[row].scatterMilliseconds - rows[row - 1].scatterMilliseconds,
               rows[0].scatterMilliseconds) /
         doublings;
}

Json exponentJson(const std::optional<double>& exponent) {
  return exponent ? Json(*exponent) : Json(nullptr);
}

Json framesJson(const std::vector<FrameScaling>& all) {
  Json frames = Json::array();
  for (const FrameScaling& series : all) {
    Json rows = Json::array();
    for (const FrameScalingRow& row : series.rows)
      rows.push_back({{"value", row.value},
                      {"part_ms", row.partMilliseconds},
                      {"frame_ms", row.frameMilliseconds}});
    frames.push_back({{"varied", series.varied},
                      {"part_exponent", exponentJson(series.partExponent)},
                      {"frame_exponent", exponentJson(series.frameExponent)},
                      {"rows", std::move(rows)}});
  }
  return frames;
}

std::string readable(const FrameScaling& series) {
  const auto exponent = [](const std::optional<double>& found) {
    return found ? fmt::format("^{:.2f}", *found) : std::string("-");
  };
  std::string text =
      fmt::format("\n{:<12}{:>10}{:>10}\n", series.varied, "its passes", "the frame");
  for (const FrameScalingRow& row : series.rows)
    text += fmt::format("{:<12.7g}{:>10.2f}{:>10.2f}\n", row.value,
                        ratio(row.partMilliseconds, series.rows[0].partMilliseconds),
                        ratio(row.frameMilliseconds, series.rows[0].frameMilliseconds));
  return text + fmt::format("{:<12}{:>10}{:>10}\n", "grows like", exponent(series.partExponent),
                            exponent(series.frameExponent));
}

Json rowJson(const std::vector<ScalingRow>& rows, std::size_t at, const char* value) {
  const ScalingRow& row = rows[at];
  return {{value, row.value},
          {"surfels", row.surfels},
          {"gather_ms", row.gatherMilliseconds},
          {"scatter_ms", row.scatterMilliseconds},
          {"nearby_ms", row.nearbyMilliseconds},
          {"frame_ms", row.frameMilliseconds},
          {"scatter_ratio", ratio(row.scatterMilliseconds, rows[0].scatterMilliseconds)},
          {"frame_ratio", ratio(row.frameMilliseconds, rows[0].frameMilliseconds)},
          {"evaluations", row.evaluations}};
}

Json seriesJson(const std::vector<ScalingRow>& rows, const char* value) {
  Json series = Json::array();
  for (std::size_t i = 0; i < rows.size(); ++i) series.push_back(rowJson(rows, i, value));
  return series;
}

std::string head(const char* value, const char* last) {
  return fmt::format("{:<12}{:>9}{:>10}{:>10}{:>10}{:>10}{:>12}{:>13}\n", value, "surfels",
                     "gathering", "the sum", "nearby", "the frame", "evaluations", last);
}

std::string line(const std::vector<ScalingRow>& rows, std::size_t at, const std::string& last) {
  const ScalingRow& row = rows[at];
  const double first = rows[0].scatterMilliseconds;
  const auto times = [&](double milliseconds) {
    return fmt::format("{:.2f}", ratio(milliseconds, first));
  };
  return fmt::format("{:<12}{:>9}{:>10}{:>10}{:>10}{:>10}{:>12.1f}{:>13}\n",
                     fmt::format("{:.7g}", row.value), row.surfels, times(row.gatherMilliseconds),
                     times(row.scatterMilliseconds), times(row.nearbyMilliseconds),
                     times(row.frameMilliseconds), row.evaluations, last);
}

}  // namespace

Json toJson(const Scaling& scaling) {
  Json budgets = seriesJson(scaling.budgets, "max_surfels");
  for (std::size_t i = 0; i < scaling.budgets.size(); ++i) {
    const auto growth = growthPerDoubling(scaling.budgets, i);
    budgets[i]["scatter_growth_per_doubling"] = growth ? Json(*growth) : Json(nullptr);
  }
  Json tolerances = seriesJson(scaling.tolerances, "tolerance");
  for (std::size_t i = 0; i < scaling.tolerances.size(); ++i) {
    const std::optional<double>& error = scaling.tolerances[i].error;
    tolerances[i]["rel_rmse"] = error ? Json(*error) : Json(nullptr);
  }
  Json diffusion = seriesJson(scaling.diffusion, "divisor");
  for (std::size_t i = 0; i < scaling.diffusion.size(); ++i)
    diffusion[i]["medium"] = mediumJson(scaling.diffusion[i].medium);
  return {{"scene", scaling.scene},
          {"size", {scaling.edgePixels, scaling.edgePixels}},
          {"device", deviceJson(scaling.device)},
          {"surfels", {{"coefficients_factor", scaling.denserBy}, {"rows", std::move(budgets)}}},
          {"sigma_tr", {{"rows", std::move(diffusion)}}},
          {"tolerance", {{"finest", scaling.finestTolerance}, {"rows", std::move(tolerances)}}},
          {"frames", framesJson(scaling.frames)}};
}

std::string toReadable(const Scaling& scaling) {
  std::string text = fmt::format(
      "{0}, tree at fragments, {1}x{1} on {2} ({3})\n"
      "Times are multiples of the first row's sum in the same table; evaluations are of a pixel.\n",
      scaling.scene, scaling.edgePixels, scaling.device.name, scaling.device.type);
  text +=
      fmt::format("\nMore surfels, coefficients times {:.3g} so that every budget is too small\n",
                  scaling.denserBy);
  text += head("budget", "per doubling");
  for (std::size_t i = 0; i < scaling.budgets.size(); ++i) {
    const auto growth = growthPerDoubling(scaling.budgets, i);
    text += line(scaling.budgets, i, growth ? fmt::format("{:+.1f} %", 100 * *growth) : "-");
  }
  text += "\nLight that travels further, by less absorption\n" + head("sigma_tr /", "at most");
  for (std::size_t i = 0; i < scaling.diffusion.size(); ++i)
    text +=
        line(scaling.diffusion, i,
             i + 1 == scaling.diffusion.size() ? fmt::format("{:.2f}", mostForSmallSigmaTr) : "-");
  text += fmt::format("\nSmaller tolerance; error is rms over the mean, to tolerance {:g}\n",
                      scaling.finestTolerance) +
          head("tolerance", "error");
  for (std::size_t i = 0; i < scaling.tolerances.size(); ++i) {
    const std::optional<double>& error = scaling.tolerances[i].error;
    text += line(scaling.tolerances, i, error ? fmt::format("{:.3f} %", 100 * *error) : "-");
  }
  text += fmt::format("\nFrames of {}, as multiples of each table's first\n",
                      scaling.hasInside
                          ? "boundary transport"
                          : "better-dipole, as nothing has an inside for boundary transport");
  for (const FrameScaling& series : scaling.frames) text += readable(series);
  return text;
}

}  // namespace opaline::app
