#include "lab/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "lab/svg_sheet.h"

namespace opaline::app {

namespace {

// Size of the sheet, in SVG units.
constexpr double sheetWidth = 720;
constexpr double sheetHeight = 480;
constexpr double left = 84;
constexpr double right = 24;
constexpr double top = 44;
constexpr double bottom = 60;
/// Values further below the peak are not shown.
constexpr double mostDecades = 8;
constexpr std::array<const char*, 3> colours{"#c8372d", "#2c8a4b", "#2b5fc0"};
constexpr std::array<const char*, 3> colourNames{"red", "green", "blue"};

struct Axes {
  double mostRadiusMm = 1;
  double leastDecade = -1;
  double mostDecade = 0;

  double x(double radiusMm) const {
    return left + (sheetWidth - left - right) * radiusMm / mostRadiusMm;
  }
  double y(double decade) const {
    const double up = (decade - leastDecade) / (mostDecade - leastDecade);
    return sheetHeight - bottom - (sheetHeight - top - bottom) * std::clamp(up, 0.0, 1.0);
  }
};

Axes axesFor(const ProfileSamples& samples) {
  double least = std::numeric_limits<double>::infinity();
  double most = 0;
  for (const auto& rgb : samples.reflectancePerMm2) {
    for (const double value : rgb) {
      if (value > 0) least = std::min(least, value);
      most = std::max(most, value);
    }
  }
  Axes axes;
  axes.mostRadiusMm = samples.radiusMm.back();
  if (most > 0) {
    axes.mostDecade = std::ceil(std::log10(most));
    axes.leastDecade = std::clamp(std::floor(std::log10(least)), axes.mostDecade - mostDecades,
                                  axes.mostDecade - 1);
  }
  return axes;
}

/// 1, 2 or 5 times a power of ten, chosen so that four to ten steps fit.
double gridStep(double length) {
  const double power = std::pow(10, std::floor(std::log10(length / 4)));
  for (const double factor : {5.0, 2.0}) {
    if (length / (factor * power) >= 4) return factor * power;
  }
  return power;
}

std::string grid(const Axes& axes) {
  std::string svg;
  for (double decade = axes.leastDecade; decade <= axes.mostDecade; decade += 1) {
    svg += fmt::format(
        "<line class=\"g\" x1=\"{}\" x2=\"{}\" y1=\"{:.1f}\" y2=\"{:.1f}\"/>"
        "<text x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">10<tspan dy=\"-5\" font-size=\"10\">{}"
        "</tspan></text>\n",
        left, sheetWidth - right, axes.y(decade), axes.y(decade), left - 10, axes.y(decade) + 5,
        decade);
  }
  const double step = gridStep(axes.mostRadiusMm);
  for (int i = 0; i * step <= axes.mostRadiusMm * (1 + 1e-9); ++i) {
    svg += fmt::format(
        "<line class=\"g\" x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1}\" y2=\"{2}\"/>"
        "<text x=\"{0:.1f}\" y=\"{3}\" text-anchor=\"middle\">{4:.6g}</text>\n",
        axes.x(i * step), top, sheetHeight - bottom, sheetHeight - bottom + 20, i * step);
  }
  return svg;
}

std::string curve(const ProfileSamples& samples, const Axes& axes, std::size_t channel) {
  std::string points;
  for (std::size_t i = 0; i < samples.radiusMm.size(); ++i) {
    const double value = samples.reflectancePerMm2[i][channel];
    if (value <= 0 || std::log10(value) < axes.leastDecade) continue;
    points += fmt::format("{:.2f},{:.2f} ", axes.x(samples.radiusMm[i]), axes.y(std::log10(value)));
  }
  const double height = top + 20 + 18 * static_cast<double>(channel);
  return fmt::format(
      "<polyline fill=\"none\" stroke=\"{0}\" stroke-width=\"2\" points=\"{1}\"/>"
      "<text x=\"{2}\" y=\"{3}\" text-anchor=\"end\" style=\"fill:{0}\">{4}</text>\n",
      colours[channel], points, sheetWidth - right - 10, height, colourNames[channel]);
}

}  // namespace

std::string plotSvg(const ProfileSamples& samples, const std::string& title) {
  const Axes axes = axesFor(samples);
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
      "height=\"{1}\" font-family=\"sans-serif\" font-size=\"13\">\n"
      "<style>text{{fill:#222}}.g{{stroke:#ddd}}</style>\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
      "<text x=\"{2}\" y=\"26\" font-size=\"16\">{3}</text>\n",
      sheetWidth, sheetHeight, left, escaped(title));
  svg += grid(axes);
  for (std::size_t channel = 0; channel < 3; ++channel) svg += curve(samples, axes, channel);
  return svg + fmt::format(
                   "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">radius, mm</text>\n"
                   "<text transform=\"translate(24 {}) rotate(-90)\" text-anchor=\"middle\">"
                   "diffuse reflectance, mm<tspan dy=\"-5\" font-size=\"10\">-2</tspan></text>\n"
                   "</svg>\n",
                   (left + sheetWidth - right) / 2, sheetHeight - 16,
                   (top + sheetHeight - bottom) / 2);
}

}  // namespace opaline::app
