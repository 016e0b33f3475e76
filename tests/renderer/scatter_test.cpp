// Light that leaves: exitance of spheres in uniform light, where every dipole has a closed form.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

#include "bssrdf/fresnel.h"
#include "bssrdf/profile.h"
#include "renderer/renderer_fixture.h"
#include "renderer/shapes.h"

namespace opaline {
namespace {

using namespace test;

using std::numbers::pi;

bssrdf::Model modelOf(Transport transport) {
  return transport == Transport::Dipole ? bssrdf::Model::Dipole : bssrdf::Model::BetterDipole;
}

// B = E · D(2R): on a sphere the area element is 2π r dr in the chord r.
double sphereExitance(const Medium& medium, Transport transport, int channel, double radiusMm) {
  const bssrdf::Profile profile =
      bssrdf::makeProfile(modelOf(transport), bssrdf::coefficients(medium, channel));
  return pi * bssrdf::meanTransmittance(medium.eta) * profile.disc(2 * radiusMm);
}

Scene uniformBall(float radiusMm, int levels) {
  Scene scene = sceneOf(sphere({0, 0, 0}, radiusMm, levels), marble(), {0, 0, 4 * radiusMm},
                        radiusMm * 1.05F);
  scene.lighting.ambient = {1, 1, 1};
  return scene;
}

/// Radius in mm, transport, site, sum.
using SphereCase = std::tuple<float, Transport, Site, Sum>;

class SphereTest : public RendererTestBase<testing::TestWithParam<SphereCase>> {};

// The tree's tolerance is a share of the error that the sources themselves may have.
TEST_P(SphereTest, SurfelsGiveTheClosedForm) {
  const auto [radiusMm, transport, site, sum] = GetParam();
  const bool large = radiusMm > 10;
  RenderOptions options = finelyDivided(smallOptions());
  options.dsmSize = 512;
  options.width = options.height = large ? 16 : 24;
  options.sum = sum;
  options.tolerance = 0.003F;
  options.transport = transport;
  options.site = site;
  const Scene scene = uniformBall(radiusMm, site == Site::Vertex ? 3 : 5);
  const Image exitance = render(scene, options, {Aov::Exitance})[0];
  double squares = 0;
  const int covered = forEachCovered(exitance, [&](std::size_t i) {
    for (int c = 0; c < 3; ++c) {
      const double ratio = static_cast<double>(exitance.rgba[i + static_cast<std::size_t>(c)]) /
                           sphereExitance(marble(), transport, c, static_cast<double>(radiusMm));
      ASSERT_NEAR(ratio, 1, 0.01) << "channel " << c;
      squares += (ratio - 1) * (ratio - 1) / 3;
    }
  });
  EXPECT_GT(covered, options.width * options.height / 2);
  // The sphere through the vertices is coarser: facets lie 0.3 % below it.
  EXPECT_LT(std::sqrt(squares / covered), site == Site::Vertex ? 0.005 : 0.003);
}

std::string nameOf(const testing::TestParamInfo<SphereCase>& sphereCase) {
  const auto& [radiusMm, transport, site, sum] = sphereCase.param;
  return std::string(sum == Sum::Tree ? "Tree" : "All") +
         (transport == Transport::Dipole ? "Dipole" : "BetterDipole") +
         (site == Site::Vertex ? "Vertex" : "Fragment") + std::to_string(std::lround(radiusMm)) +
         "mm";
}

INSTANTIATE_TEST_SUITE_P(Uniform, SphereTest,
                         testing::Combine(testing::Values(5.0F, 20.0F),
                                          testing::Values(Transport::Dipole,
                                                          Transport::BetterDipole),
                                          testing::Values(Site::Fragment, Site::Vertex),
                                          testing::Values(Sum::Tree, Sum::All)),
                         nameOf);

using ScatterTest = RendererTest;

// Eq. 5 and d'Eon's exit: radiance from exitance, without the reflection on top.
TEST_F(ScatterTest, RadianceIsWhatTheBoundaryLetsThrough) {
  renderer().setScene(uniformBall(5, 5));
  for (const Transport transport : {Transport::Dipole, Transport::BetterDipole}) {
    RenderOptions options = smallOptions();
    options.transport = transport;
    options.specular = false;
    const auto images = render(options, {Aov::Radiance, Aov::Exitance, Aov::Position, Aov::Normal});
    const double factor = transport == Transport::Dipole
                              ? 1 / pi
                              : 1 / (pi * bssrdf::meanTransmittance(marble().eta));
    forEachCovered(images[0], [&](std::size_t i) {
      const Vector toCamera = unit(Vector{0, 0, 20} - toVector(&images[2].rgba[i]));
      const double cosine = dot(toVector(&images[3].rgba[i]), toCamera);
      if (cosine < 0.1) return;  // half floats
      const double expected = factor * static_cast<double>(images[1].rgba[i]) *
                              (1 - bssrdf::fresnelReflectance(1.5, std::min(cosine, 1.0)));
      ASSERT_NEAR(static_cast<double>(images[0].rgba[i]) / expected, 1, 0.003) << cosine;
    });
  }
}

// A ball in the umbra of another stays dark, whatever the other emits.
TEST_F(ScatterTest, SeparateObjectsDoNotLeakIntoEachOther) {
  Scene scene = sceneOf(sphere({0, 0, 0}, 5, 4), marble(), {0, 40, 1}, 12);
  scene.objects.push_back({"shaded", sphere({-8, 0, 0}, 2, 4), skin()});
  scene.lighting.directional = {{{1, 0, 0}, {1, 1, 1}}};
  renderer().setScene(scene);
  for (const Sum sum : {Sum::Pattern, Sum::Tree, Sum::All})
    for (const Site site : {Site::Fragment, Site::Vertex}) {
      RenderOptions options = smallOptions();
      options.dsmSize = 128;
      options.sum = sum;
      options.site = site;
      const auto images = render(options, {Aov::Object, Aov::Exitance});
      int shaded = 0;
      float brightest = 0;
      forEachCovered(images[0], [&](std::size_t i) {
        if (images[0].rgba[i] == 1) {
          ++shaded;
          ASSERT_EQ(images[1].rgba[i], 0);
        } else {
          brightest = std::max(brightest, images[1].rgba[i]);
        }
      });
      EXPECT_GT(shaded, 30);
      EXPECT_GT(brightest, 0.3F);
    }
}

// Lengths times s and coefficients over s give the same body.
TEST_F(ScatterTest, PictureDoesNotDependOnTheUnitOfLength) {
  const auto scaled = [](float s) {
    Medium medium = skin();
    for (std::size_t c = 0; c < 3; ++c) {
      medium.sigmaSPrimePerMm[c] /= static_cast<double>(s);
      medium.sigmaAPerMm[c] /= static_cast<double>(s);
    }
    Scene scene = sceneOf(sphere({s, 0, 0}, 6 * s, 4), medium, {0, 0, 30 * s}, 8 * s);
    scene.lighting.directional = {{toVec3(unit({1, 1, 0})), {2, 2, 2}}};
    scene.lighting.points = {{{-8 * s, -4 * s, 9 * s}, {100 * s * s, 100 * s * s, 100 * s * s}}};
    scene.lighting.ambient = {0.1F, 0.1F, 0.1F};
    return scene;
  };
  for (const Sum sum : {Sum::Pattern, Sum::Tree, Sum::All}) {
    RenderOptions options = smallOptions();
    options.dsmSize = 128;
    options.sum = sum;
    const Image one = render(scaled(1), options, {Aov::Radiance})[0];
    for (const float s : {0.0625F, 32.0F}) {
      const Image other = render(scaled(s), options, {Aov::Radiance})[0];
      for (std::size_t i = 0; i < one.rgba.size(); ++i)
        ASSERT_NEAR(other.rgba[i], one.rgba[i], 1e-3F) << s << ", value " << i;
    }
  }
}

TEST_F(ScatterTest, LightsAddUpInExitance) {
  Scene scene = uniformBall(5, 4);
  const DirectionalLight sun{toVec3(unit({1, 2, 1})), {1, 2, 3}};
  const PointLight lamp{{-8, 3, 5}, {200, 100, 50}};
  std::array<std::vector<Image>, 2> images;  // by sum, by lights
  RenderOptions options = smallOptions();
  options.width = options.height = 32;
  for (const unsigned lights : {1U, 2U, 3U}) {
    scene.lighting = {};
    if ((lights & 1U) != 0) scene.lighting.directional = {sun};
    if ((lights & 2U) != 0) scene.lighting.points = {lamp};
    renderer().setScene(scene);
    for (const Sum sum : {Sum::Pattern, Sum::All}) {
      options.sum = sum;
      images[sum == Sum::All ? 1 : 0].push_back(render(options, {Aov::Exitance})[0]);
    }
  }
  for (const std::vector<Image>& image : images)
    forEachCovered(image[2], [&](std::size_t i) {
      for (std::size_t c = 0; c < 3; ++c)  // sums of tens of thousands of terms in single precision
        ASSERT_NEAR(image[2].rgba[i + c] / (image[0].rgba[i + c] + image[1].rgba[i + c]), 1, 3e-5F);
    });
}

}  // namespace
}  // namespace opaline
