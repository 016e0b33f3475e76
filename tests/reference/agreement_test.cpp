// The GPU renderer and the reference show the same scene in the same pixels. They share no code
// except media, Fresnel's formulas, profiles and spherical harmonics.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "reference/bodies.h"
#include "reference/integral.h"
#include "reference/picture.h"
#include "renderer/renderer_fixture.h"

namespace opaline {
namespace {

using namespace test;

class AgreementTest : public RendererTest {
 protected:
  static constexpr int edge = 40;

  AgreementTest() {
    LoadOptions load;
    load.diagonalMm = 20;
    load.medium = marble();
    scene_ = builtInBear(load);
  }

  std::vector<Image> rendered(const std::vector<Aov>& aovs, Sum sum, Transport transport) {
    RenderOptions options;
    options.width = options.height = edge;
    options.dsmSize = 256;
    options.shadowSize = 2048;
    options.transport = transport;
    options.sum = sum;
    options.maxSurfels = maxSurfels_;
    options.site = Site::Fragment;
    if (!std::exchange(isSet_, true)) {
      renderer().setScene(scene_);
      renderer().setTime({.clip = -1});
    }
    return render(options, aovs);
  }
  std::vector<Image> exact(const std::vector<Aov>& aovs, Transport transport) const {
    const reference::Scene scene = referenceOf(scene_);
    const reference::Geometry geometry(scene);
    const reference::Irradiance irradiance(geometry);
    std::optional<reference::Integral> integral;
    if (std::any_of(aovs.begin(), aovs.end(), reference::showsExitance)) {
      integral.emplace(geometry, irradiance, reference::IntegralOptions{transport, 1e-3});
    }
    reference::PictureOptions options;
    options.width = options.height = edge;
    std::vector<Image> images;
    for (const Aov aov : aovs) {
      options.aov = aov;
      images.push_back(
          makePicture(geometry, irradiance,
                      {[&](const reference::SurfacePoint& point) { return integral->at(point); },
                       exitFactors(scene, transport)},
                      options)
              .image);
    }
    return images;
  }

  Scene scene_;
  int maxSurfels_ = RenderOptions{}.maxSurfels;
  bool isSet_ = false;
};

/// Whether a pixel and its neighbours show one piece of surface.
bool isInterior(const Image& depth, int x, int y, float stepMm) {
  if (x == 0 || y == 0 || x + 1 == depth.width || y + 1 == depth.height) return false;
  for (int j = y - 1; j <= y + 1; ++j) {
    for (int i = x - 1; i <= x + 1; ++i) {
      const float* pixel = depth.pixel(i, j);
      if (pixel[3] == 0 || std::abs(pixel[0] - depth.pixel(x, y)[0]) > stepMm) return false;
    }
  }
  return true;
}

TEST_F(AgreementTest, PixelsShowTheSamePlaces) {
  const std::vector<Aov> aovs{Aov::Position, Aov::Depth, Aov::Normal};
  const auto found = rendered(aovs, Sum::Pattern, Transport::Dipole);
  const auto truth = exact(aovs, Transport::Dipole);
  int interior = 0;
  int different = 0;
  for (int y = 0; y < edge; ++y) {
    for (int x = 0; x < edge; ++x) {
      different += found[0].pixel(x, y)[3] != truth[0].pixel(x, y)[3] ? 1 : 0;
      if (!isInterior(truth[1], x, y, 2)) continue;
      ++interior;
      for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(found[0].pixel(x, y)[c], truth[0].pixel(x, y)[c], 1e-4 * 20) << x << " " << y;
        EXPECT_NEAR(found[1].pixel(x, y)[c], truth[1].pixel(x, y)[c], 1e-4 * 20) << x << " " << y;
        EXPECT_NEAR(found[2].pixel(x, y)[c], truth[2].pixel(x, y)[c], 2e-3);  // half floats
      }
    }
  }
  EXPECT_GT(interior, edge * edge / 5);
  EXPECT_LE(different, 2);
}

struct Difference {
  double relative = 0;  ///< root mean square over the mean
  double largest = 0;   ///< over the value there
};

Difference differenceOf(const Image& found, const Image& truth) {
  Difference difference;
  double squares = 0;
  double sum = 0;
  int values = 0;
  for (std::size_t i = 0; i < truth.rgba.size(); i += 4) {
    if (truth.rgba[i + 3] == 0 || found.rgba[i + 3] == 0) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      const double value{truth.rgba[i + c]};
      const double off = double{found.rgba[i + c]} - value;
      squares += off * off;
      sum += value;
      difference.largest = std::max(difference.largest, std::abs(off) / value);
      ++values;
    }
  }
  difference.relative = std::sqrt(squares / values) / (sum / values);
  return difference;
}

// Surfels are two thirds of marble's shortest mean free path, with three sources each. The
// lattice's error is far below that of a shadow's border, which is blurred over a few texels of the
// shadow map.
TEST_F(AgreementTest, SumOverAllSurfelsIsTheIntegral) {
  for (const Transport transport : {Transport::Dipole, Transport::BetterDipole}) {
    const Difference difference = differenceOf(rendered({Aov::Exitance}, Sum::All, transport)[0],
                                               exact({Aov::Exitance}, transport)[0]);
    RecordProperty("relative_rmse", std::to_string(difference.relative));
    EXPECT_LT(difference.relative, 1e-3);
    EXPECT_LT(difference.largest, 0.02);
  }
}

// The remaining error is due to coarse surfels: fewer and larger ones are less precise.
TEST_F(AgreementTest, FinerSurfelsComeNearerToTheIntegral) {
  const Image truth = exact({Aov::Exitance}, Transport::Dipole)[0];
  double before = 0;
  for (const int surfels : {1024, 4096, 16384}) {
    maxSurfels_ = surfels;
    const double now =
        differenceOf(rendered({Aov::Exitance}, Sum::All, Transport::Dipole)[0], truth).relative;
    RecordProperty("relative_rmse_of_" + std::to_string(surfels), std::to_string(now));
    if (before > 0) {
      EXPECT_LT(now, 0.7 * before) << surfels;
    }
    before = now;
  }
  EXPECT_LT(before, 0.01);
}

}  // namespace
}  // namespace opaline
