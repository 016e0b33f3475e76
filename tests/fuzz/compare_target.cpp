#include <gtest/gtest.h>

#include <cmath>

#include "input.h"
#include "opaline/compare.h"
#include "opaline/tone.h"

namespace {

using namespace opaline;

Image imageFrom(fuzz::Input& input, int width, int height) {
  Image image(width, height);
  for (std::size_t i = 0; i < image.rgba.size(); ++i)
    image.rgba[i] = i % 4 == 3 ? static_cast<float>(input.below(3)) / 2 : input.finite();
  return image;
}

}  // namespace

// Two pictures of finite pixels.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Input input(data, size);
  const int width = 1 + static_cast<int>(input.below(12));
  const int height = 1 + static_cast<int>(input.below(12));
  const int edge = 1 + static_cast<int>(input.below(16));
  constexpr std::uint32_t mostPixelsPerDegree = 32;  // more would take most of the time
  const double pixelsPerDegree = 1.0 + input.below(mostPixelsPerDegree);
  const Image a = imageFrom(input, width, height);
  const Image b = imageFrom(input, width, height);
  const compare::Selection common = compare::commonPixels(a, b);
  const auto figures = compare::figuresOver(a, b, common);
  EXPECT_EQ(figures.has_value(), compare::countOf(common) > 0);
  EXPECT_FALSE(figures && std::isnan(figures->all.relRmse));
  compare::blockFiguresOver(a, b, common, edge);
  compare::meanOverCovered(a);
  compare::maskedPixels(a);
  const compare::Plane errors = compare::relativeErrors(a, b, common);
  compare::relativeBlockErrors(a, b, common, edge);
  compare::drawHeatmap(errors, common, compare::heatmapTop(errors, common));
  const ToneOptions tone;
  for (const float seen :
       compare::flipMap(toneMap(a, tone), toneMap(b, tone), pixelsPerDegree).values)
    EXPECT_TRUE(seen >= 0 && seen <= 1.0001F) << seen;
  return 0;
}
