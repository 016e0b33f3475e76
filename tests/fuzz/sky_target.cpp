#include "environment/sky.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "environment/suns.h"
#include "input.h"
#include "opaline/environment.h"

// The suns of any picture, which may be turned.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace opaline;
  fuzz::Input input(data, size);
  const int width = 1 + static_cast<int>(input.below(64));
  const int height = 1 + static_cast<int>(input.below(32));
  const double degrees = input.take<std::int16_t>();
  Image picture(width, height);
  for (float& value : picture.rgba) value = std::abs(static_cast<float>(input.take<std::int8_t>()));
  for (std::uint32_t suns = input.below(8); suns > 0; --suns)
    picture.rgba[input.take<std::uint16_t>() % picture.rgba.size()] = std::abs(input.finite());
  const auto sky = std::make_shared<const Image>(turned(picture, degrees));
  const Suns suns = findSuns(sky);
  EXPECT_LE(suns.lights.size(), maxSuns);
  Lighting lighting;
  lighting.environment = suns.rest;
  separate(suns, lighting);
  for (const SkyParts::Part& part : partsOfSky(lighting).parts) EXPECT_GE(part.solidAngle, 0);
  return 0;
}
