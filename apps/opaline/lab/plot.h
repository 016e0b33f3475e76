#pragma once

#include <array>
#include <string>
#include <vector>

namespace opaline::app {

/// R_d of the three channels over the radius.
struct ProfileSamples {
  std::vector<double> radiusMm;
  std::vector<std::array<double, 3>> reflectancePerMm2;
};

/// A plot as SVG: radius in mm, R_d in mm⁻² on a logarithmic scale, one curve per channel.
std::string plotSvg(const ProfileSamples& samples, const std::string& title);

}  // namespace opaline::app
