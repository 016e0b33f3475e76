// Figure 4 of Gong et al. 2008.

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include "environment/lat_long.h"
#include "environment/sky_irradiance.h"
#include "figures.h"
#include "opaline/image_file.h"

namespace opaline::figures {

namespace {

constexpr int facePixels = 192;
constexpr double eta = 1.3;
constexpr float stops = 0;

void cubes(Studio& studio, const char* name) {
  const Image environment = readHdrImage(studio.models / "env" / "venice_sunset_1k.hdr");
  Lighting lighting;
  lighting.environment = std::make_shared<const Image>(environment);
  const SkyIrradiance irradiance = SkyIrradiance::entering(partsOfSky(lighting), eta);
  const Image original = cubeCross(
      2 * facePixels, [&](const Vec3& direction) { return radianceFrom(environment, direction); });
  // Divided by π, so that it is as bright as the mean radiance from which it comes.
  const Image ambient = cubeCross(2 * facePixels, [&](const Vec3& normal) {
    Rgb colour{};
    const std::array<double, 3> entered = irradiance.at(normal);
    for (std::size_t c = 0; c < 3; ++c) {
      colour[c] = static_cast<float>(entered[c] / std::numbers::pi);
    }
    return colour;
  });
  publish(studio, name,
          sheet({develop(halved(original), stops, white), develop(halved(ambient), stops, white)},
                2, 4 * gapPixels, white));
}

}  // namespace

std::span<const Figure> cubeFigures() {
  static constexpr std::array all{Figure{"figure_4", cubes}};
  return all;
}

}  // namespace opaline::figures
