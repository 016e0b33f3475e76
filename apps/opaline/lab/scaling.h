#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cli/json.h"
#include "cli/output.h"
#include "opaline/log.h"
#include "opaline/renderer.h"
#include "opaline/scene.h"

namespace opaline::app {

/// What to measure: the cost of the sum over the tree at visible pixels, and of whole frames.
struct ScalingOrder {
  Scene scene;
  int edgePixels = 512;
  int mostSurfels = 1 << 20;  ///< the largest budget; others are a sixteenth and a quarter of it
  int frames = 5;             ///< of each measurement
  std::string device;
  LogCallback log;
  StatusCallback status = statusTaker(true);
};

struct ScalingRow {
  double value = 0;  ///< the quantity that the series varies
  Medium medium;     ///< of the first object
  std::size_t surfels = 0;
  double gatherMilliseconds = 0;   ///< the light that enters the surfels, and their tree
  double scatterMilliseconds = 0;  ///< the sum over the tree with its rough estimate
  double nearbyMilliseconds = 0;   ///< the extra work for coarse surfels
  double frameMilliseconds = 0;
  double evaluations = 0;       ///< of the profile, mean over covered pixels
  std::optional<double> error;  ///< of exitance, rms over the mean, against the finest tolerance
};

struct FrameScalingRow {
  double value = 0;             ///< the quantity that the series varies
  double partMilliseconds = 0;  ///< passes that grow with it
  double frameMilliseconds = 0;
};

/// Times of frames with boundary transport, the default, or with what stands for it where nothing
/// has an inside.
struct FrameScaling {
  std::string varied;  ///< surfels, clusters, lights or pixels
  std::vector<FrameScalingRow> rows;
  std::optional<double> partExponent{};  ///< p where time grows as the value to the power p
  std::optional<double> frameExponent{};
};

/// The slope of the line fitted to the logarithms; none for fewer than two values.
std::optional<double> fittedExponent(const std::vector<FrameScalingRow>& rows,
                                     double FrameScalingRow::*time);

/// Without clusters where nothing has an inside.
std::vector<FrameScaling> measureFrames(const ScalingOrder& order);

/// The rows of a series are measured in turns, so that they can be compared.
struct Scaling {
  DeviceDescription device;
  std::string scene;
  int edgePixels = 0;
  double denserBy = 1;         ///< factor on the media's coefficients that makes every budget bind
  double finestTolerance = 0;  ///< reference for the errors
  std::vector<ScalingRow> budgets;     ///< value: most surfels allowed
  std::vector<ScalingRow> diffusion;   ///< value: divisor of σ_tr in every channel
  std::vector<ScalingRow> tolerances;  ///< value: the tolerance, falling
  std::vector<FrameScaling> frames;
  bool hasInside = true;  ///< anything, for boundary transport
};

Scaling measureScaling(const ScalingOrder& order);

Json toJson(const Scaling& scaling);
std::string toReadable(const Scaling& scaling);

/// Times of the sum and of the frame, relative to the first row of their series, as SVG.
std::string plotSvg(const Scaling& scaling);

}  // namespace opaline::app
