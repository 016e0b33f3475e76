#include "cli/json.h"

#include <fmt/format.h>

#include <string>

#include "cli/medium_options.h"
#include "opaline/half_space.h"

namespace opaline::app {

Json rgbJson(const std::array<double, 3>& rgb) {
  return {{"r", rgb[0]}, {"g", rgb[1]}, {"b", rgb[2]}};
}

Json mediumJson(const Medium& medium) {
  const MediumLengths lengths = lengthsOf(medium);
  return {{"name", medium.name},
          {"sigma_s_per_mm", rgbJson(medium.sigmaSPrimePerMm)},
          {"sigma_a_per_mm", rgbJson(medium.sigmaAPerMm)},
          {"eta", medium.eta},
          {"g", medium.g},
          {"mean_free_path_mm", rgbJson(lengths.meanFreePathMm)},
          {"diffusion_length_mm", rgbJson(lengths.diffusionMm)}};
}

Json shortJson(float value) {
  return std::stod(fmt::format("{}", value));
}

Json deviceJson(const DeviceDescription& device) {
  return {{"name", device.name}, {"type", device.type}, {"driver", device.driver}};
}

std::string toText(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace opaline::app
