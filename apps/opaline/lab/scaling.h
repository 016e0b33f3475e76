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

/// What costs are measured with: of the sum over the tree at visible pixels, and of whole frames.
struct ScalingOrder {
  Scene scene;
  int edgePixels = 512;
  int mostSurfels = 1 << 20;  ///< the largest budget; before it a sixteenth and a quarter of it
  int frames = 5;             ///< of each measurement
  std::string device;
  LogCallback log;
  StatusCallback status = statusTaker(true);
};

struct ScalingRow {
  double value = 0;  ///< of what the series varies
  Medium medium;     ///< of the first object
  std::size_t surfels = 0;
  double gatherMilliseconds = 0;   ///< light that enters the surfels, and their tree
  double scatterMilliseconds = 0;  ///< the sum over the tree with its rough estimate
  double nearbyMilliseconds = 0;   ///< what coarse surfels want besides
  double frameMilliseconds = 0;
  double evaluations = 0;       ///< of the profile, mean over covered pixels
  std::optional<double> error;  ///< of exitance, rms over the mean, to the finest tolerance
};

struct FrameScalingRow {
  double value = 0;             ///< of what the series varies
  double partMilliseconds = 0;  ///< of the passes that grow with it
  double frameMilliseconds = 0;
};

/// Frames of boundary transport, which the program renders by default.
struct FrameScaling {
  std::string varied;  ///< surfels, clusters, lights or pixels
  std::vector<FrameScalingRow> rows;
  std::optional<double> partExponent{};  ///< p where time grows like the value to the power p
  std::optional<double> frameExponent{};
};

/// The slope of the straight line nearest to the logarithms; none for less than two values.
std::optional<double> fittedExponent(const std::vector<FrameScalingRow>& rows,
                                     double FrameScalingRow::*time);

std::vector<FrameScaling> measureFrames(const ScalingOrder& order);

/// Rows of a series are measured in turns, so that they can be compared.
struct Scaling {
  DeviceDescription device;
  std::string scene;
  int edgePixels = 0;
  double denserBy = 1;         ///< factor on the media's coefficients that makes every budget bind
  double finestTolerance = 0;  ///< that errors are to
  std::vector<ScalingRow> budgets;     ///< value: most surfels that there may be
  std::vector<ScalingRow> diffusion;   ///< value: what σ_tr of every channel is divided by
  std::vector<ScalingRow> tolerances;  ///< value: the tolerance, falling
  std::vector<FrameScaling> frames;
};

Scaling measureScaling(const ScalingOrder& order);

Json toJson(const Scaling& scaling);
std::string toReadable(const Scaling& scaling);

/// Time of the sum and of the frame as multiples of those of each series' first row, as SVG.
std::string plotSvg(const Scaling& scaling);

}  // namespace opaline::app
