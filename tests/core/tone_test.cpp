#include "opaline/tone.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <limits>

#include "opaline/error.h"
#include "opaline/image_file.h"

namespace opaline::core {
namespace {

Image onePixel(float r, float g, float b, float a) {
  Image image(1, 1);
  image.rgba = {r, g, b, a};
  return image;
}

/// Inverse of the sRGB transfer function, IEC 61966-2-1.
double decodeSrgb(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

TEST(EncodeSrgb, InvertsTheStandardsDecoding) {
  for (int i = 0; i <= 1000; ++i) {
    const double linear = i / 1000.0;
    EXPECT_NEAR(decodeSrgb(static_cast<double>(encodeSrgb(static_cast<float>(linear)))), linear,
                2e-6);
  }
  EXPECT_FLOAT_EQ(encodeSrgb(0.0F), 0.0F);
  EXPECT_FLOAT_EQ(encodeSrgb(1.0F), 1.0F);
}

// Incomplete images are not written either.
TEST(ToneMap, ImagesThatAreNotWholeAreRefused) {
  Image image(2, 2);
  image.rgba.pop_back();
  EXPECT_THROW(toneMap(image), UsageError);
  EXPECT_THROW(writeExr({"never.exr"}, image), UsageError);
  EXPECT_THROW(writeExr({"never.exr"}, Image()), UsageError);
  EXPECT_THROW(writePng({"never.png"}, Image8{1, 1, {0, 0, 0}}), UsageError);
  EXPECT_FALSE(std::filesystem::exists("never.exr"));
}

TEST(ToneMap, NoneClipsAndEncodes) {
  ToneOptions options;
  options.curve = ToneCurve::None;
  // Linear 0.5 is 188 in sRGB; 0.2140 is 127 or 128.
  const Image8 image = toneMap(onePixel(0.5F, 2.0F, 0.0F, 0.5F), options);
  EXPECT_EQ(image.rgba, (std::vector<std::uint8_t>{188, 255, 0, 128}));
}

TEST(ToneMap, AnUnknownCurveIsRefused) {
  EXPECT_THROW(toneMap(onePixel(1, 1, 1, 1), {.curve = static_cast<ToneCurve>(2)}), UsageError);
}

TEST(ToneMap, ExposureIsInStops) {
  ToneOptions options;
  options.curve = ToneCurve::None;
  options.exposureStops = -2;
  EXPECT_EQ(toneMap(onePixel(2.0F, 4.0F, 0, 1), options).rgba,
            (std::vector<std::uint8_t>{188, 255, 0, 255}));
  options.exposureStops = 33;
  EXPECT_THROW(toneMap(onePixel(1, 1, 1, 1), options), UsageError);
  options.exposureStops = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(toneMap(onePixel(1, 1, 1, 1), options), UsageError);
}

// The specification promises that base colours up to 0.8 under neutral light come out unchanged,
// less the 0.04 of Fresnel reflection that it subtracts.
TEST(ToneMap, NeutralKeepsColoursBelowItsShoulder) {
  for (const std::array<float, 3> color : {std::array{0.5F, 0.3F, 0.2F}, {0.75F, 0.1F, 0.5F}}) {
    const Image8 image = toneMap(onePixel(color[0] + 0.04F, color[1] + 0.04F, color[2] + 0.04F, 1));
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_EQ(image.rgba[c], std::lround(255 * encodeSrgb(color[c])));
    }
  }
}

// Computed by hand from the published function for (2, 1, 0.5): offset .04, peak 1.96, new peak 1 -
// .0576/1.44 = .96, scale .96/1.96, g = 1 - 1/(.15·1 + 1).
TEST(ToneMap, NeutralCompressesHighlights) {
  const double g = 1.0 - 1.0 / 1.15;
  const Image8 image = toneMap(onePixel(2.0F, 1.0F, 0.5F, 1));
  const std::array<double, 3> in = {1.96, 0.96, 0.46};
  for (std::size_t c = 0; c < 3; ++c) {
    const double expected = (1 - g) * in[c] * 0.96 / 1.96 + g * 0.96;
    EXPECT_NEAR(image.rgba[c], 255 * encodeSrgb(static_cast<float>(expected)), 0.51);
  }
}

TEST(ToneMap, NeutralIsMonotonousOnGreys) {
  int last = 0;
  for (float value = 0; value < 100; value += 0.01F) {
    const int now = toneMap(onePixel(value, value, value, 1)).rgba[0];
    EXPECT_GE(now, last) << value;
    last = now;
  }
}

TEST(ToneMap, SurvivesAnything) {
  const float infinity = std::numeric_limits<float>::infinity();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const ToneCurve curve : {ToneCurve::None, ToneCurve::Neutral}) {
    ToneOptions options;
    options.curve = curve;
    options.exposureStops = 32;
    EXPECT_EQ(toneMap(onePixel(infinity, infinity, infinity, infinity), options).rgba,
              (std::vector<std::uint8_t>{255, 255, 255, 255}));
    EXPECT_EQ(toneMap(onePixel(nan, -1, -infinity, nan), options).rgba,
              (std::vector<std::uint8_t>{0, 0, 0, 0}));
    EXPECT_EQ(toneMap(onePixel(3e38F, 3e38F, 3e38F, 1), options).rgba[1], 255);
  }
}

TEST(ToneMap, BackgroundLiesUnderThePicture) {
  ToneOptions options;
  options.curve = ToneCurve::None;
  options.background = Rgb{0.0F, 0.5F, 1.0F};
  EXPECT_EQ(toneMap(onePixel(1, 1, 1, 0), options).rgba,
            (std::vector<std::uint8_t>{0, 188, 255, 255}));
  EXPECT_EQ(toneMap(onePixel(1, 0.5F, 0, 0.5F), options).rgba,
            (std::vector<std::uint8_t>{188, 188, 188, 255}));
}

}  // namespace
}  // namespace opaline::core
