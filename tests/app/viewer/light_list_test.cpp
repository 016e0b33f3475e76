#include "viewer/session/light_list.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace opaline::app::viewer {
namespace {

TEST(LightList, LightsAreNumberedByKindAndAreaLightsByShape) {
  Lighting lighting;
  lighting.points.resize(2);
  lighting.spots.resize(1);
  lighting.areas = {RectangleLight{}, DiscLight{}, TubeLight{}, DiscLight{}, RectangleLight{}};
  std::vector<std::string> names;
  for (std::size_t i = 0; i < countOf(lighting); ++i)
    names.push_back(nameOf(lighting, entryOf(lighting, i)));
  EXPECT_EQ(names, (std::vector<std::string>{"point 1", "point 2", "spot 1", "rectangle 1",
                                             "disc 1", "tube 1", "disc 2", "rectangle 2"}));
}

}  // namespace
}  // namespace opaline::app::viewer
