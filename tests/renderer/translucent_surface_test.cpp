// Roughness and normals that translucent bodies have of their own, against closed forms and beside
// geometry.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>

#include "bssrdf/fresnel.h"
#include "renderer/renderer_fixture.h"
#include "renderer/shapes.h"

namespace opaline {
namespace {

using namespace test;
using std::numbers::pi;

constexpr float halfEdgeMm = 10;
constexpr int edgePixels = 48;

/// Rows of unit normals as a picture keeps them.
std::shared_ptr<const TexturePixels> normalPixels(int width, int height,
                                                  const std::function<Vector(int, int)>& normalAt) {
  TexturePixels made;
  made.width = width;
  made.height = height;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const Vector normal = normalAt(x, y);
      for (const double part : normal)
        made.rgba.push_back(static_cast<std::uint16_t>(std::lround(65535 * (0.5 + 0.5 * part))));
      made.rgba.push_back(65535);
    }
  return std::make_shared<const TexturePixels>(made);
}

Texture plainTexture(const Vector& value) {
  Texture texture;
  texture.pixels = normalPixels(1, 1, [&](int, int) { return value; });
  return texture;
}

class TranslucentSurfaceTest : public RendererTest {
 protected:
  static RenderOptions options() {
    RenderOptions options = smallOptions();
    options.transport = Transport::BetterDipole;
    options.width = options.height = edgePixels;
    return options;
  }

  // A square that faces +z, of light that scatters within a fraction of a millimetre. Its texture's
  // upper left corner is at its own.
  static Scene squareOf(const std::optional<TranslucentSurface>& surface, int cells = 24) {
    Medium medium = marble();
    medium.sigmaSPrimePerMm.fill(5);
    medium.sigmaAPerMm.fill(0.05);
    Scene scene = sceneOf(sheet({0, 0, 0}, {halfEdgeMm, 0, 0}, {0, halfEdgeMm, 0}, cells), medium,
                          {0, 0, 500}, 0.6F * halfEdgeMm);
    Mesh& mesh = scene.objects[0].mesh;
    for (const Vec3& place : mesh.positionsMm)
      mesh.textureCoordinates[0].push_back(
          {0.5F + 0.5F * place[0] / halfEdgeMm, 0.5F - 0.5F * place[1] / halfEdgeMm});
    scene.objects[0].surface = surface;
    return scene;
  }

  static Vector valueAt(const Scene& scene, const RenderOptions& options, Aov aov) {
    return toVector(render(scene, options, {aov})[0].pixel(edgePixels / 2 + 1, edgePixels / 2 - 2));
  }
};

// Tilted by its texture towards +x and, since green is up, +y.
Vector tiltedBy(double angle) {
  const double s = std::sin(angle) / std::sqrt(2.0);
  return {s, s, std::cos(angle)};
}

TEST_F(TranslucentSurfaceTest, LightEntersByTheNormalOfTheTexture) {
  const Vector normal = tiltedBy(0.4);
  Scene scene = squareOf(TranslucentSurface{.normalTexture = plainTexture(normal)});
  const double eta = scene.objects[0].medium.eta;
  for (const Vector& light : {unit({0.6, 0.3, 1}), unit({-1, -0.4, 1})}) {
    scene.lighting.directional = {{toVec3(light), {1, 1, 1}}};
    const double cosine = dot(light, normal);
    const double entering = cosine * (1 - bssrdf::fresnelReflectance(eta, cosine));
    EXPECT_NEAR(valueAt(scene, options(), Aov::Irradiance)[0], entering, 0.003);
    RenderOptions boundary = options();
    boundary.transport = Transport::Boundary;
    EXPECT_NEAR(valueAt(scene, boundary, Aov::Irradiance)[0], entering, 0.003);
  }
  // What faces away from a light takes none of it.
  scene.lighting.directional = {{toVec3(unit({-1, -1, 0.3})), {1, 1, 1}}};
  EXPECT_EQ(valueAt(scene, options(), Aov::Irradiance)[0], 0);
}

TEST_F(TranslucentSurfaceTest, FromAnEvenSkyAsMuchEntersWhateverTheNormal) {
  Scene scene = squareOf(std::nullopt);
  scene.lighting.ambient = {1, 1, 1};
  const double plain = valueAt(scene, options(), Aov::Irradiance)[0];
  scene.objects[0].surface = TranslucentSurface{.normalTexture = plainTexture(tiltedBy(0.4))};
  EXPECT_NEAR(valueAt(scene, options(), Aov::Irradiance)[0], plain, 1e-3 * plain);
}

// GGX's distribution times Smith's height-correlated masking (Heitz 2014), over 4 cos in cos out,
// where the half vector is the normal.
double ggxHeadOn(double alpha, double in, double out) {
  const auto lambda = [&](double c) {
    return 0.5 * (std::sqrt(1 + alpha * alpha * (1 / (c * c) - 1)) - 1);
  };
  return 1 / (pi * alpha * alpha) / ((1 + lambda(in) + lambda(out)) * 4 * in * out);
}

TEST_F(TranslucentSurfaceTest, HighlightsLieWhereTheNormalOfTheTextureMirrorsTheLight) {
  const Vector normal = tiltedBy(0.3);
  const float roughness = 0.4F;
  Scene scene =
      squareOf(TranslucentSurface{.roughness = roughness, .normalTexture = plainTexture(normal)});
  const double out = normal[2];
  const Vector mirrored = 2 * out * normal - Vector{0, 0, 1};
  scene.lighting.directional = {{toVec3(mirrored), {1, 1, 1}}};
  RenderOptions with = options();
  RenderOptions without = options();
  without.specular = false;
  const double found =
      valueAt(scene, with, Aov::Radiance)[0] - valueAt(scene, without, Aov::Radiance)[0];
  const double alpha = double{roughness} * double{roughness};
  const double expected = ggxHeadOn(alpha, out, out) * out *
                          bssrdf::fresnelReflectance(scene.objects[0].medium.eta, out);
  EXPECT_NEAR(found, expected, 0.01 * expected);
}

TEST_F(TranslucentSurfaceTest, RoughnessIsThatOfTheTexture) {
  Scene scene = squareOf(TranslucentSurface{.roughness = 0.3F});
  scene.lighting.directional = {{toVec3(unit({0.1, 0.1, 1})), {1, 1, 1}}};
  scene.lighting.ambient = {0.5F, 0.5F, 0.5F};
  const Image stated = render(scene, options(), {Aov::Radiance})[0];
  // Green is the roughness: a half of 0.6.
  scene.objects[0].surface =
      TranslucentSurface{.roughness = 0.6F, .metallicRoughnessTexture = plainTexture({1, 0, 1})};
  const Image textured = render(scene, options(), {Aov::Radiance})[0];
  // As the picture has it where none is stated.
  scene.objects[0].surface.reset();
  RenderOptions asThePicture = options();
  asThePicture.roughness = 0.3F;
  const Image plain = render(scene, asThePicture, {Aov::Radiance})[0];
  ASSERT_GT(forEachCovered(stated,
                           [&](std::size_t i) {
                             EXPECT_NEAR(textured.rgba[i], stated.rgba[i], 1e-3F * stated.rgba[i]);
                             EXPECT_NEAR(plain.rgba[i], stated.rgba[i], 5e-3F * stated.rgba[i]);
                           }),
            1000);
}

/// Waves along x: height and slope.
constexpr double waveMm = 5;
constexpr double steepest = 0.3;
double slopeAt(double x) {
  return steepest * std::cos(2 * pi * x / waveMm);
}

// The same waves as a mesh and as normals on a plane, which light sees alike where it scatters far
// less than a wave's length: with surfels fine enough for it, and with coarse ones, where the
// fragments add what these leave out.
TEST_F(TranslucentSurfaceTest, WavesOfATextureLookLikeThoseOfTheMesh) {
  constexpr int cells = 160;
  Scene geometry = squareOf(std::nullopt, cells);
  Mesh& mesh = geometry.objects[0].mesh;
  for (std::size_t v = 0; v < mesh.positionsMm.size(); ++v) {
    const double x = double{mesh.positionsMm[v][0]};
    mesh.positionsMm[v][2] =
        static_cast<float>(steepest * waveMm / (2 * pi) * std::sin(2 * pi * x / waveMm));
    mesh.normals[v] = toVec3(unit({-slopeAt(x), 0, 1}));
  }
  constexpr int texels = 256;
  Texture waves;
  waves.pixels = normalPixels(texels, 1, [](int x, int) {
    const double place = 2 * double{halfEdgeMm} * ((x + 0.5) / texels - 0.5);
    return unit({-slopeAt(place), 0, 1});
  });
  const Scene textured = squareOf(TranslucentSurface{.normalTexture = waves});
  RenderOptions fine = options();
  fine.specular = false;
  RenderOptions coarse = fine;
  coarse.maxSurfels = 1024;
  const auto rendered = [&](Scene scene, const RenderOptions& options) {
    scene.lighting.directional = {{toVec3(unit({0.7, 0, 1})), {1, 1, 1}}};
    return render(scene, options, {Aov::Radiance})[0];
  };
  const Image expected = rendered(geometry, fine);
  for (const RenderOptions& options : {fine, coarse}) {
    const Image found = rendered(textured, options);
    double squares = 0;
    double sum = 0;
    double spread = 0;
    const auto middle = static_cast<double>(expected.pixel(edgePixels / 2, edgePixels / 2)[0]);
    const int count = forEachCovered(expected, [&](std::size_t i) {
      const double off = double{found.rgba[i]} - double{expected.rgba[i]};
      squares += off * off;
      sum += double{expected.rgba[i]};
      spread = std::max(spread, std::abs(double{expected.rgba[i]} - middle));
    });
    EXPECT_GT(spread, 0.2 * sum / count);  // there is something to be seen
    EXPECT_LT(std::sqrt(squares / count), 0.03 * sum / count) << options.maxSurfels;
  }
}

TEST_F(TranslucentSurfaceTest, NormalsThatAreThoseOfTheMeshChangeNothing) {
  Scene scene = squareOf(std::nullopt);
  scene.objects[0].mesh = sphere({0, 0, 0}, 5, 3);
  scene.objects[0].mesh.textureCoordinates[0].resize(scene.objects[0].mesh.positionsMm.size());
  for (std::size_t v = 0; v < scene.objects[0].mesh.positionsMm.size(); ++v)
    scene.objects[0].mesh.textureCoordinates[0][v] = {scene.objects[0].mesh.positionsMm[v][0],
                                                      scene.objects[0].mesh.positionsMm[v][1]};
  scene.lighting.directional = {{toVec3(unit({0.7, 0.2, 1})), {1, 1, 1}}};
  scene.lighting.ambient = {0.2F, 0.2F, 0.2F};
  RenderOptions options = TranslucentSurfaceTest::options();
  options.transport = Transport::Boundary;
  options.site = Site::Fragment;
  options.specular = false;
  const std::vector<Image> plain = render(scene, options, {Aov::Radiance, Aov::Normal});
  scene.objects[0].surface = TranslucentSurface{.normalTexture = plainTexture({0, 0, 1})};
  const Image mapped = render(scene, options, {Aov::Radiance})[0];
  forEachCovered(mapped, [&](std::size_t i) {
    // Normals at the rim that look away are turned to the eye.
    if (plain[1].rgba[i + 2] < 0.03F) return;
    EXPECT_NEAR(mapped.rgba[i], plain[0].rgba[i], 2e-3F * plain[0].rgba[i]);
  });
}

// What leaves and what is mirrored add up in even light, where the surface is grazed too, however
// rough it is.
TEST_F(TranslucentSurfaceTest, InAWhiteFurnaceABallIsEvenToItsEdge) {
  Medium white = marble();
  white.sigmaSPrimePerMm.fill(5);
  white.sigmaAPerMm.fill(0);
  Scene scene = sceneOf(sphere({0, 0, 0}, halfEdgeMm, 5), white, {0, 0, 60}, halfEdgeMm);
  scene.lighting.ambient = {1, 1, 1};
  RenderOptions options = TranslucentSurfaceTest::options();
  options.transport = Transport::Boundary;
  for (const float roughness : {0.05F, 0.25F, 0.5F, 1.0F}) {
    options.roughness = roughness;
    const Image image = render(scene, options, {Aov::Radiance})[0];
    int seen = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
      const double coverage{image.rgba[i + 3]};
      if (coverage < 0.2) continue;
      ++seen;
      EXPECT_NEAR(double{image.rgba[i + 1]} / coverage, 1, 0.015) << roughness << ", " << i / 4;
    }
    EXPECT_GT(seen, 800);
  }
}

TEST_F(TranslucentSurfaceTest, ThePatternKnowsRoughnessButNoNormals) {
  RenderOptions pattern = smallOptions();
  pattern.sum = Sum::Pattern;
  Scene scene = squareOf(TranslucentSurface{.roughness = 0.5F});
  scene.lighting.directional = {{{0, 0, 1}, {1, 1, 1}}};
  EXPECT_NO_THROW(render(scene, pattern, {Aov::Radiance}));
  scene.objects[0].surface->normalTexture = plainTexture({0, 0, 1});
  renderer().setScene(scene);
  EXPECT_THROW(render(pattern, {Aov::Radiance}), UsageError);
}

}  // namespace
}  // namespace opaline
