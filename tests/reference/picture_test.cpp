// Which pixels are made, and what they show.

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>

#include "bssrdf/fresnel.h"
#include "opaline/error.h"
#include "reference/bodies.h"
#include "reference/integral.h"
#include "reference/picture.h"

namespace opaline {
namespace {

using namespace test;
using reference::Picture;
using reference::PictureOptions;

/// A ball of marble in front of a smaller one of skin, in the sun.
class PictureTest : public testing::Test {
 protected:
  PictureTest()
      : scene_(sceneOfBodies(
            {bodyOf(sphere({0, 0, 0}, 5, 3)), bodyOf(sphere({6, 3, -4}, 3, 3), skin())})) {
    scene_.lighting.directional = {{{1, 1, 0.5F}, {2, 1, 1}}};
    scene_.lighting.ambient = {0.1F, 0.1F, 0.1F};
  }

  Picture picture(const PictureOptions& options, Transport transport = Transport::Dipole) const {
    const reference::Geometry geometry(scene_);
    const reference::Irradiance irradiance(geometry);
    const reference::Integral integral(geometry, irradiance, {transport, 1e-2});
    return makePicture(geometry, irradiance,
                       {[&](const reference::SurfacePoint& point) { return integral.at(point); },
                        exitFactors(scene_, transport)},
                       options);
  }
  static PictureOptions options(Aov aov) {
    PictureOptions options;
    options.width = 24;
    options.height = 20;
    options.aov = aov;
    return options;
  }

  reference::Scene scene_;
};

TEST_F(PictureTest, PartsAreThoseOfTheWhole) {
  for (const Aov aov : {Aov::Radiance, Aov::Exitance, Aov::Position}) {
    PictureOptions some = options(aov);
    const Picture whole = picture(some);
    some.region = reference::Region{5, 3, 13, 9};
    some.every = 4;
    const Picture part = picture(some);
    std::size_t pixels = 0;
    for (int y = 0; y < 20; ++y) {
      for (int x = 0; x < 24; ++x) {
        const bool asked = x >= 5 && x < 18 && y >= 3 && y < 12 && x % 4 == 0 && y % 4 == 0;
        for (int c = 0; c < 4; ++c) {
          EXPECT_EQ(part.image.pixel(x, y)[c], asked ? whole.image.pixel(x, y)[c] : 0)
              << x << " " << y;
        }
        pixels += part.image.pixel(x, y)[3] > 0 ? 1U : 0U;
      }
    }
    EXPECT_GT(pixels, 2U);
    EXPECT_EQ(part.pixels, pixels);
  }
}

TEST_F(PictureTest, NumberOfThreadsChangesNothing) {
  const Picture many = picture(options(Aov::Radiance));
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(many.image.rgba, picture(options(Aov::Radiance)).image.rgba);
}

// Jensen et al. 2001, Eq. 5, and d'Eon 2012.
TEST_F(PictureTest, RadianceIsWhatTheBoundaryLetsThrough) {
  PictureOptions some = options(Aov::Radiance);
  some.antialias = 1;
  for (const Transport transport : {Transport::Dipole, Transport::BetterDipole}) {
    const Picture radiance = picture(some, transport);
    const Picture exitance = picture(options(Aov::Exitance), transport);
    const Picture position = picture(options(Aov::Position), transport);
    const Picture normal = picture(options(Aov::Normal), transport);
    const Picture object = picture(options(Aov::Object), transport);
    int checked = 0;
    for (std::size_t i = 0; i < radiance.image.rgba.size(); i += 4) {
      EXPECT_EQ(radiance.image.rgba[i + 3], exitance.image.rgba[i + 3]);
      if (radiance.image.rgba[i + 3] == 0) continue;
      const Vector toCamera = unit(Vector{0, 0, 40} - toVector(&position.image.rgba[i]));
      const double cosine = dot(toVector(&normal.image.rgba[i]), toCamera);
      if (cosine < 0.05) continue;
      const double eta = object.image.rgba[i] == 0 ? 1.5 : 1.3;
      const double factor = fresnelTransmittance(eta, cosine) / std::numbers::pi /
                            (transport == Transport::Dipole ? 1 : bssrdf::meanTransmittance(eta));
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(
            double{radiance.image.rgba[i + c]} / (factor * double{exitance.image.rgba[i + c]}), 1,
            1e-5);
      }
      ++checked;
    }
    EXPECT_GT(checked, 40);
  }
}

TEST_F(PictureTest, CoverageIsTheShareOfSamples) {
  PictureOptions some = options(Aov::Radiance);
  some.antialias = 8;
  const Image image = picture(some).image;
  int partly = 0;
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) {
    EXPECT_EQ(image.rgba[i] * 8, std::round(image.rgba[i] * 8));
    partly += image.rgba[i] > 0 && image.rgba[i] < 1 ? 1 : 0;
  }
  EXPECT_GT(partly, 10);
}

TEST_F(PictureTest, ProgressReachesTheEnd) {
  const reference::Geometry geometry(scene_);
  const reference::Irradiance irradiance(geometry);
  std::size_t before = 0;
  std::size_t all = 0;
  makePicture(geometry, irradiance, {}, options(Aov::Irradiance),
              [&](std::size_t done, std::size_t total) {
                EXPECT_GT(done, before);
                before = done;
                all = total;
              });
  EXPECT_EQ(all, 480U);
  EXPECT_EQ(before, all);
}

TEST_F(PictureTest, OptionsOutOfRangeAreRefused) {
  const auto refused = [&](const auto& change) {
    PictureOptions some = options(Aov::Position);
    change(some);
    EXPECT_THROW(picture(some), UsageError);
  };
  refused([](PictureOptions& o) { o.width = 0; });
  refused([](PictureOptions& o) { o.height = 20000; });
  refused([](PictureOptions& o) { o.every = 0; });
  refused([](PictureOptions& o) { o.aov = Aov::DsmArea; });
  refused([](PictureOptions& o) { o.aov = Aov::Evaluations; });
  refused([](PictureOptions& o) { o.aov = Aov::Surfels; });
  refused([](PictureOptions& o) { o.region = reference::Region{0, 0, 25, 1}; });
  refused([](PictureOptions& o) { o.region = reference::Region{5, 5, 1, 2147483647}; });
  refused([](PictureOptions& o) { o.region = reference::Region{-1, 0, 3, 3}; });
}

}  // namespace
}  // namespace opaline
