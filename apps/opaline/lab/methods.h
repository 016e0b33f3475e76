#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/json.h"
#include "cli/output.h"
#include "opaline/image.h"
#include "opaline/log.h"
#include "opaline/renderer.h"
#include "opaline/scene.h"

namespace opaline::app {

/// What is measured for every method of rendering a scene: time on the device, and the error of
/// exitance against the exact integral and against a picture of the truth.
struct MethodsOrder {
  Scene scene;
  int edgePixels = 256;
  int every = 1;     ///< measure only every so many pixels each way; requires truthSeconds of 0
  int frames = 3;    ///< of each measurement of time
  bool all = false;  ///< measure the sum over all surfels too, which takes minutes without a GPU
  std::string device;
  std::optional<Image> truth;  ///< exitance of the same view, edgePixels square
  double truthSeconds = 30;    ///< time to trace the truth where it is not given; 0: no truth
  LogCallback log;
  StatusCallback status = statusTaker(true);
};

/// One method of rendering, or the exact integral by itself.
struct MethodRow {
  Transport transport = Transport::Dipole;
  std::string sum;   ///< pattern, tree, all or integral
  std::string site;  ///< vertex, fragment or exact
  std::optional<double> frameMilliseconds;
  std::optional<double> integralError;  ///< rms over the mean, pixels; none for Transport::Boundary
  std::optional<double> truthError;     ///< the same, blocks of 8×8 pixels
  std::optional<double> evaluations;    ///< of the profile in the sum, mean over covered pixels
};

struct Methods {
  DeviceDescription device;
  std::string scene;
  int edgePixels = 0;
  bool hasTruth = false;
  /// Standard errors of the truth, if it was traced here: as MethodRow::truthError, and rms over
  /// the mean block.
  std::optional<double> truthsOwnError;
  std::optional<double> truthsBlockError;
  std::vector<MethodRow> rows;
};

Methods measureMethods(const MethodsOrder& order);

Json toJson(const Methods& methods);
std::string toReadable(const Methods& methods);

/// Error against cost as SVG, both logarithmic: full marks for errors against the integral, open
/// ones against the truth.
std::string plotSvg(const Methods& methods);

}  // namespace opaline::app
