#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "opaline/scene.h"
#include "scene/toml/toml_fixture.h"

namespace opaline {
namespace {

using testing::HasSubstr;

TEST_F(Toml, AreaLights) {
  const Lighting lighting = load(model + R"(
[[lights]]
type = "rectangle"
center_mm = [0, 20, 0]
u_mm = [3, 0, 0]
v_mm = [0, 0, 4]
radiance = 5
two_sided = true
[[lights]]
type = "disc"
center_mm = [0, -20, 0]
normal = [0, 2, 0]
radius_mm = 6
radiance = [1, 2, 3]
[[lights]]
type = "sphere"
center_mm = [30, 0, 0]
radius_mm = 7
radiance = 1
[[lights]]
type = "tube"
from_mm = [0, 0, 10]
to_mm = [0, 5, 10]
radius_mm = 0.5
radiance = 2
)")
                                .scene.lighting;
  ASSERT_EQ(lighting.areas.size(), 4U);  // the cube's middle is 15, 5, 5
  const auto& rectangle = std::get<RectangleLight>(lighting.areas[0]);
  EXPECT_NEAR(rectangle.centreMm[1], 25, 1e-4);
  EXPECT_EQ(rectangle.uMm, (Vec3{3, 0, 0}));
  EXPECT_EQ(rectangle.vMm, (Vec3{0, 0, 4}));
  EXPECT_EQ(rectangle.radiance, (Rgb{5, 5, 5}));
  EXPECT_TRUE(rectangle.twoSided);
  const auto& disc = std::get<DiscLight>(lighting.areas[1]);
  EXPECT_EQ(disc.normal, (Vec3{0, 1, 0}));
  EXPECT_EQ(disc.radiusMm, 6);
  EXPECT_FALSE(disc.twoSided);
  EXPECT_NEAR(std::get<SphereLight>(lighting.areas[2]).centreMm[0], 45, 1e-4);
  const auto& tube = std::get<TubeLight>(lighting.areas[3]);
  EXPECT_NEAR(tube.toMm[1] - tube.fromMm[1], 5, 1e-4);
  EXPECT_EQ(tube.radiusMm, 0.5F);
}

TEST_F(Toml, ADiagonalFromOutsideScalesAreaLights) {
  LoadOptions options;
  options.diagonalMm = 2 * 17.3205081F;
  const Lighting lighting = load(model +
                                     "[[lights]]\ntype = 'disc'\ncenter_mm = [-15, -5, 15]\n"
                                     "normal = [0, 0, -1]\nradius_mm = 3\nradiance = 2\n",
                                 options)
                                .scene.lighting;
  const auto& disc = std::get<DiscLight>(lighting.areas[0]);
  EXPECT_NEAR(disc.centreMm[2], 40, 1e-3);
  EXPECT_NEAR(disc.radiusMm, 6, 1e-4);
  EXPECT_EQ(disc.radiance, (Rgb{2, 2, 2}));
}

TEST_F(Toml, AreaLightsThatMakeNoSense) {
  const auto error = [&](const std::string& keys) {
    return errorOf(model + "[[lights]]\nradiance = 1\n" + keys);
  };
  EXPECT_THAT(error("type = 'disc'\n"), HasSubstr("'center_mm'"));
  EXPECT_THAT(error("type = 'sphere'\ncenter_mm = [0, 0, 9]\nradius_mm = -1\n"),
              HasSubstr("'radius_mm'"));
  EXPECT_THAT(error("type = 'sphere'\ncenter_mm = [0, 0, nan]\nradius_mm = 1\n"),
              HasSubstr("'center_mm'"));
  EXPECT_THAT(error("type = 'rectangle'\ncenter_mm = [0, 0, 9]\nu_mm = [1, 0, 0]\n"
                    "v_mm = [2, 0, 0]\n"),
              HasSubstr("neither be zero nor parallel"));
  EXPECT_THAT(error("type = 'tube'\nfrom_mm = [0, 0, 9]\nto_mm = [0, 0, 9]\nradius_mm = 1\n"),
              HasSubstr("two places"));
  EXPECT_THAT(error("type = 'disc'\ncenter_mm = [0, 0, 9]\nradius_mm = 1\nnormal = [0, 0, 0]\n"),
              HasSubstr("'normal'"));
  EXPECT_THAT(error("type = 'sphere'\nradius = 1\n"), HasSubstr("'radius_mm'"));
  EXPECT_THAT(error("type = 'square'\n"), HasSubstr("rectangle"));
}

TEST_F(Toml, SpotLightsThatMakeNoSense) {
  const std::string light = model + "[[lights]]\ntype = 'spot'\n";
  const std::string whole = light + "position_mm = [0, 0, 9]\nintensity = 1\n";
  EXPECT_THAT(errorOf(light), HasSubstr("'position_mm'"));
  EXPECT_THAT(errorOf(whole), HasSubstr("'direction'"));
  EXPECT_THAT(errorOf(whole + "direction = [0, 0, 0]\n"), HasSubstr("'direction'"));
  const std::string sound = whole + "direction = [0, 0, -1]\n";
  EXPECT_THAT(errorOf(sound + "outer_degrees = 91\n"), HasSubstr("'outer_degrees'"));
  EXPECT_THAT(errorOf(sound + "inner_degrees = 50\n"),
              HasSubstr("inner_degrees 50: must not be above outer_degrees, which is 45"));
  EXPECT_THAT(errorOf(sound + "radius_mm = 1\n"), HasSubstr("'radius_mm'"));
}

}  // namespace
}  // namespace opaline
