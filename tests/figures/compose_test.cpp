#include "compose.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace opaline::figures {

namespace {

constexpr Paper paper{9, 8, 7};

Image8 uniform(int width, int height, std::uint8_t grey) {
  Image8 image{width, height, {}};
  for (int i = 0; i < width * height; ++i) {
    image.rgba.insert(image.rgba.end(), {grey, grey, grey, 255});
  }
  return image;
}

int redAt(const Image8& image, int x, int y) {
  return image.rgba.at(4 * static_cast<std::size_t>(y * image.width + x));
}

TEST(Padded, KeepsThePictureAndAddsPaperAtTheRight) {
  const Image8 wider = padded(uniform(3, 2, 100), 5, paper);
  ASSERT_EQ(wider.width, 5);
  ASSERT_EQ(wider.height, 2);
  EXPECT_EQ(redAt(wider, 2, 1), 100);
  EXPECT_EQ(redAt(wider, 3, 1), paper[0]);
  EXPECT_EQ(redAt(wider, 4, 0), paper[0]);
}

TEST(Sheet, PlacesPanelsRowByRowWithPaperBetweenAndWhereNoneIsLeft) {
  const Image8 picture =
      sheet({uniform(3, 2, 100), uniform(3, 2, 150), uniform(3, 2, 200)}, 2, 1, paper);
  ASSERT_EQ(picture.width, 7);
  ASSERT_EQ(picture.height, 5);
  EXPECT_EQ(redAt(picture, 0, 0), 100);
  EXPECT_EQ(redAt(picture, 2, 1), 100);
  EXPECT_EQ(redAt(picture, 3, 0), paper[0]);
  EXPECT_EQ(redAt(picture, 4, 0), 150);
  EXPECT_EQ(redAt(picture, 6, 1), 150);
  EXPECT_EQ(redAt(picture, 0, 2), paper[0]);
  EXPECT_EQ(redAt(picture, 0, 3), 200);
  EXPECT_EQ(redAt(picture, 2, 4), 200);
  EXPECT_EQ(redAt(picture, 4, 4), paper[0]);
}

TEST(Sheet, RefusesPanelsOfDifferentSizesAndNone) {
  EXPECT_THROW(sheet({uniform(3, 2, 1), uniform(2, 3, 1)}, 2, 0, paper), std::invalid_argument);
  EXPECT_THROW(sheet({}, 2, 0, paper), std::invalid_argument);
}

TEST(Halved, WeighsByCoverage) {
  Image image(2, 2);
  const std::array<float, 16> pixels{1, 2, 3, 1, 9, 9, 9, 0, 3, 4, 5, 1, 9, 9, 9, 0};
  std::copy(pixels.begin(), pixels.end(), image.rgba.begin());
  const Image half = halved(image);
  ASSERT_EQ(half.rgba.size(), 4U);
  EXPECT_THAT(half.rgba, testing::ElementsAre(2, 3, 4, 0.5F));
}

TEST(Plain, KeepsValuesOverPaper) {
  Image image(2, 1);
  const std::array<float, 8> pixels{0, 0.6F, 2, 1, 5, 5, 5, 0};
  std::copy(pixels.begin(), pixels.end(), image.rgba.begin());
  EXPECT_THAT(plain(image, paper).rgba, testing::ElementsAre(0, 153, 255, 255, 9, 8, 7, 255));
}

TEST(CubeCross, LooksAlongTheAxesInTheMiddleOfItsFaces) {
  const int size = 3;
  const Image cross = cubeCross(size, [](const Vec3& direction) { return direction; });
  const auto middle = [&](int column, int row) {
    const float* p = cross.pixel(column * size + 1, row * size + 1);
    return Vec3{p[0], p[1], p[2]};
  };
  EXPECT_EQ(middle(0, 1), (Vec3{-1, 0, 0}));
  EXPECT_EQ(middle(1, 1), (Vec3{0, 0, 1}));
  EXPECT_EQ(middle(2, 1), (Vec3{1, 0, 0}));
  EXPECT_EQ(middle(3, 1), (Vec3{0, 0, -1}));
  EXPECT_EQ(middle(1, 0), (Vec3{0, 1, 0}));
  EXPECT_EQ(middle(1, 2), (Vec3{0, -1, 0}));
}

TEST(CubeCross, HasNoSeamBetweenNeighbours) {
  const int size = 64;
  const Image cross = cubeCross(size, [](const Vec3& direction) { return direction; });
  const float step = 2.01F / static_cast<float>(size);
  for (int y = 0; y + 1 < cross.height; ++y) {
    for (int x = 0; x + 1 < cross.width; ++x) {
      const float* here = cross.pixel(x, y);
      for (const float* there : {cross.pixel(x + 1, y), cross.pixel(x, y + 1)}) {
        if (here[3] != 1 || there[3] != 1) continue;
        EXPECT_LT(std::hypot(here[0] - there[0], here[1] - there[1], here[2] - there[2]), step)
            << x << " " << y;
      }
    }
  }
}

}  // namespace

}  // namespace opaline::figures
