// Opaque bodies in the reference, against closed forms.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "reference/bodies.h"
#include "reference/path/eye_paths.h"
#include "reference/path/path_run.h"
#include "reference/truth.h"
#include "renderer/shapes.h"

namespace opaline::reference {
namespace {

using std::numbers::pi;

constexpr int edge = 16;

Body opaqueBody(const Mesh& mesh, const OpaqueMaterial& material) {
  Body body = test::bodyOf(mesh);
  body.opaque = material;
  body.textureCoordinates = mesh.textureCoordinates;
  return body;
}

OpaqueMaterial luminous(double radiance, double albedo) {
  const auto share = static_cast<float>(albedo);
  const auto emitted = static_cast<float>(radiance);
  OpaqueMaterial material = mattMaterial({share, share, share});
  material.emission = {emitted, emitted, emitted};
  return material;
}

/// A square perpendicular to z.
Mesh square(const Vec3& centre, float half) {
  Mesh mesh;
  for (const float y : {-1.0F, 1.0F})
    for (const float x : {-1.0F, 1.0F}) {
      mesh.positionsMm.push_back({centre[0] + half * x, centre[1] + half * y, centre[2]});
      mesh.normals.push_back({0, 0, 1});
      mesh.textureCoordinates[0].push_back({0.5F + 0.5F * x, 0.5F - 0.5F * y});
    }
  mesh.triangles = {{0, 1, 2}, {2, 1, 3}};
  return mesh;
}

/// A point as seen from a direction, by many paths.
class Eye {
 public:
  explicit Eye(const Scene& scene, int bounces = 1000)
      : geometry_(scene), tracer_(geometry_, {.bounces = bounces}) {}

  PathTracer& tracer() { return tracer_; }

  Colour radianceFrom(const Vector& origin, const Vector& towards, int paths) const {
    const EyePaths eye(geometry_, tracer_, {});
    const Vector direction = unitOr(towards - origin, {0, 0, -1});
    const auto hit = geometry_.closestHit(origin, direction);
    Random random(3, 1);
    Colour sum{};
    for (int i = 0; i < paths; ++i) sum += eye.radiance(hit->point, -direction, random);
    return (1.0 / paths) * sum;
  }

 private:
  Geometry geometry_;
  PathTracer tracer_;
};

double fluxThatLeft(const PathTracer& tracer) {
  double left = 0;
  for (const Order order : {Order::Unscattered, Order::Single, Order::Multiple})
    left += tracer.leftFlux(0, order);
  return left;
}

double ggxByTheBook(double alpha, double half, double in, double out) {
  const double a2 = alpha * alpha;
  const double t = half * half * (a2 - 1) + 1;
  const auto lambda = [&](double cosine) {
    return 0.5 * (std::sqrt(1 + a2 * (1 / (cosine * cosine) - 1)) - 1);
  };
  return a2 / (pi * t * t) / (1 + lambda(in) + lambda(out)) / (4 * in * out);
}

TEST(OpaqueTruthTest, LambertAndGgxUnderADirectionalLight) {
  Scene scene =
      test::sceneOfBodies({opaqueBody(square({0, 0, 0}, 10), mattMaterial({0.8F, 0.5F, 0}))});
  scene.lighting.directional = {{{0.6F, 0, 0.8F}, {3, 3, 3}}};
  const Colour matt = Eye(scene).radianceFrom({0, 0, 40}, {1, 1, 0}, 1);
  EXPECT_NEAR(matt[0], 0.8 * 0.8 * 3 / pi, 1e-6);
  EXPECT_NEAR(matt[1], 0.5 * 0.8 * 3 / pi, 1e-6);
  // A metal of low roughness, where reflection between facets is negligible.
  OpaqueMaterial metal;
  metal.baseColor = {1, 0.5F, 0.5F};
  metal.metallic = 1;
  metal.roughness = 0.3F;
  scene.bodies[0].opaque = metal;
  const Vector out = unitOr({-0.6, 0.1, 0.8}, {});
  const Vector half = unitOr(out + Vector{0.6, 0, 0.8}, {});
  const double expected = ggxByTheBook(0.09, half[2], 0.8, out[2]) * 0.8 * 3 *
                          (0.5 + 0.5 * std::pow(1 - dot(half, out), 5));
  EXPECT_NEAR(Eye(scene).radianceFrom(40.0 * out, {0, 0, 0}, 1)[1] / expected, 1, 0.01);
}

// glTF 2.0, appendix B mixes the two results, not their parameters.
TEST(OpaqueTruthTest, HalfMetalIsTheMeanOfMetalAndDielectric) {
  OpaqueMaterial material;
  material.baseColor = {0.8F, 0.4F, 0.1F};
  material.roughness = 0.6F;
  const auto found = [&](float metallic) {
    material.metallic = metallic;
    Scene scene = test::sceneOfBodies({opaqueBody(square({0, 0, 0}, 10), material)});
    scene.lighting.directional = {{{0.6F, 0, 0.8F}, {3, 3, 3}}};
    return Eye(scene).radianceFrom({0, 0, 40}, {1, 1, 0}, 1);
  };
  const Colour mean = 0.75 * found(0) + 0.25 * found(1);
  const Colour mixed = found(0.25F);
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(mixed[c] / mean[c], 1, 1e-6);
}

// White surfaces are as bright as their surroundings.
TEST(OpaqueTruthTest, WhiteFurnace) {
  for (const double roughness : {0.1, 0.5, 1.0})
    for (const float metallic : {0.0F, 0.5F, 1.0F}) {
      OpaqueMaterial white;
      white.baseColor = {1, 1, 1};
      white.metallic = metallic;
      white.roughness = static_cast<float>(roughness);
      Scene scene = test::sceneOfBodies({opaqueBody(test::sphere({0, 0, 0}, 5, 4), white)});
      scene.lighting.ambient = {1, 1, 1};
      const Eye eye(scene);
      for (const double across : {0.0, 2.5, 4.0})
        EXPECT_NEAR(eye.radianceFrom({across, 0, 40}, {across, 0, 0}, 30'000)[1], 1, 0.015)
            << roughness << " " << metallic << " " << across;
    }
}

// Inside a luminous matt ball all is L + ρL + ρ²L + …
TEST(OpaqueTruthTest, LightGoesRoundInAHollowBall) {
  Scene scene =
      test::sceneOfBodies({opaqueBody(test::sphere({0, 0, 0}, 5, 4), luminous(0.5, 0.7))});
  EXPECT_NEAR(Eye(scene).radianceFrom({1, 0, 1}, {5, 1, 0}, 20000)[1], 0.5 / 0.3, 0.02);
  EXPECT_NEAR(Eye(scene, 1).radianceFrom({1, 0, 1}, {5, 1, 0}, 1000)[1], 0.5 * 1.7, 1e-3);
}

// The middle of a square of half edge a faces an equal one at that distance. E of one of its
// quarters is by Lambert 1760.
TEST(OpaqueTruthTest, APlateShinesOnAnother) {
  Scene scene = test::sceneOfBodies({opaqueBody(square({0, 0, 0}, 10), mattMaterial({1, 1, 1})),
                                     opaqueBody(square({0, 0, 8}, 10), luminous(2, 0))});
  const double s = std::sqrt(100 + 64);
  const double quarter = 10 / s * std::atan(10 / s);  // twice the form factor times π
  const double expected = 2 * 4 * quarter / pi;
  EXPECT_NEAR(Eye(scene).radianceFrom({0, 0, 4}, {0, 0, 0}, 100'000)[1] / expected, 1, 0.01);
}

// A sphere wholly above a surface element covers (R/r)² cos θ of its sky.
TEST(OpaqueTruthTest, ABallHidesItsPartOfTheSky) {
  Scene scene = test::sceneOfBodies({opaqueBody(square({0, 0, 0}, 100), mattMaterial({1, 1, 1})),
                                     opaqueBody(test::sphere({0, 0, 6}, 5, 5), mattMaterial({}))});
  scene.lighting.ambient = {1, 1, 1};
  const double hidden = 25 / (36 + 64.0) * 6 / 10;
  EXPECT_NEAR(Eye(scene).radianceFrom({8, 0, 1}, {8, 0, 0}, 200'000)[1], 1 - hidden, 0.003);
}

// In even light a white ball is invisible, also with a white floor below: as much leaves the ball
// as without the floor. F̄_t of the particles that hit it enter.
TEST(OpaqueTruthTest, AWhiteFloorIsNotSeenInAWhiteFurnace) {
  const Medium white{"white", {2, 2, 2}, {0, 0, 0}, 1.3};
  Scene scene = test::sceneOfBodies({test::bodyOf(test::sphere({0, 0, 2.01F}, 2, 4), white),
                                     opaqueBody(square({0, 0, 0}, 12), mattMaterial({1, 1, 1}))});
  scene.lighting.ambient = {1, 1, 1};
  Eye eye(scene);
  eye.tracer().run(1'500'000);
  const double left = fluxThatLeft(eye.tracer());
  const double expected = pi * 4 * pi * 4 * bssrdf::meanTransmittance(1.3);
  EXPECT_NEAR(left / expected, 1, 0.03);
  // The floor itself is invisible too, close to the ball, which mirrors and returns light.
  EXPECT_NEAR(eye.radianceFrom({2.5, 0, 1}, {1.5, 0, 0}, 50'000)[1], 1, 0.03);
}

// Light of a luminous plate enters a ball above it like that of an equal lamp.
TEST(OpaqueTruthTest, EmissionEntersMedia) {
  const Medium thin{"thin", {0.5, 0.5, 0.5}, {0, 0, 0}, 1.3};
  const auto leftOf = [&](bool lamp) {
    Scene scene = test::sceneOfBodies({test::bodyOf(test::sphere({0, 0, 4}, 2, 4), thin)});
    if (lamp)
      scene.lighting.areas = {RectangleLight{{0, 0, 0}, {5, 0, 0}, {0, 5, 0}, {1, 1, 1}}};
    else
      scene.bodies.push_back(opaqueBody(square({0, 0, 0}, 5), luminous(1, 0)));
    Eye eye(scene);
    eye.tracer().run(400'000);
    return fluxThatLeft(eye.tracer());
  };
  EXPECT_NEAR(leftOf(false) / leftOf(true), 1, 0.03);
}

// A dark floor under a plate that only absorbs, by Fresnel's and Beer's laws for all reflections
// between the plate's sides.
TEST(OpaqueTruthTest, LightGoesStraightThroughAPlate) {
  constexpr double eta = 1.4;
  constexpr double thickness = 1;
  const Medium grey{"grey", {1e-6, 1e-6, 1e-6}, {0.2, 0.5, 1.2}, eta};
  const double cosine = std::cos(50 * pi / 180);
  Scene scene =
      test::sceneOfBodies({test::bodyOf(test::box({0, 0, 4}, {20, 20, thickness / 2}, 4), grey),
                           opaqueBody(square({0, 0, 0}, 12), mattMaterial({0.02F, 0.02F, 0.02F}))});
  scene.lighting.directional = {
      {{static_cast<float>(std::sin(50 * pi / 180)), 0, static_cast<float>(cosine)}, {1, 1, 1}}};
  Eye eye(scene);
  eye.tracer().run(1'500'000);
  constexpr int across = 40;
  Colour sum{};
  for (int i = 0; i < across * across; ++i) {
    const double x = 0.25 * (i % across) - 5;
    const double y = 0.25 * (i / across) - 5;
    sum += eye.radianceFrom({x, y, 2}, {x, y, 0}, 1);
  }
  const double inside = std::sqrt(1 - (1 - cosine * cosine) / (eta * eta));
  const double mirrored = bssrdf::fresnelReflectance(eta, cosine);
  for (std::size_t c = 0; c < 3; ++c) {
    const double left = std::exp(-grey.sigmaAPerMm[c] * thickness / inside);
    const double through =
        (1 - mirrored) * (1 - mirrored) * left / (1 - mirrored * mirrored * left * left);
    const double expected = 0.02 / pi * cosine * through;
    EXPECT_NEAR(sum[c] / (across * across) / expected, 1, 0.035) << c;
  }
}

// A luminous floor seen through a plate that only absorbs, by Fresnel's and Beer's laws for all
// reflections between the plate's sides.
TEST(OpaqueTruthTest, AFloorIsSeenThroughAPlate) {
  constexpr double eta = 1.4;
  constexpr double thickness = 1;
  const Medium grey{"grey", {1e-6, 1e-6, 1e-6}, {0.2, 0.5, 1.2}, eta};
  const Scene scene =
      test::sceneOfBodies({test::bodyOf(test::box({0, 0, 4}, {60, 60, thickness / 2}, 1), grey),
                           opaqueBody(square({0, 0, 0}, 200), luminous(1, 0))});
  const Eye eye(scene);
  for (const double degrees : {0.0, 30.0, 50.0}) {
    const double angle = degrees * pi / 180;
    const Colour seen = eye.radianceFrom({10 * std::sin(angle), 1, 4.5 + 10 * std::cos(angle)},
                                         {0, 1, 4.5}, 40'000);
    const double inside = std::sqrt(1 - std::pow(std::sin(angle) / eta, 2));
    const double mirrored = bssrdf::fresnelReflectance(eta, std::cos(angle));
    for (std::size_t c = 0; c < 3; ++c) {
      const double left = std::exp(-grey.sigmaAPerMm[c] * thickness / inside);
      const double expected =
          (1 - mirrored) * (1 - mirrored) * left / (1 - mirrored * mirrored * left * left);
      EXPECT_NEAR(seen[c] / expected, 1, 0.01) << degrees << " " << c;
    }
  }
}

// A white ball one mean free path thick is invisible in a white furnace, since what it does not
// scatter is seen through it. Light that scatters is taken to leave evenly, so this holds for the
// mean over the disc.
TEST(OpaqueTruthTest, AThinBallIsNotSeenInAWhiteFurnace) {
  constexpr double radius = 2;
  const Medium thin{"thin", {0.25, 0.25, 0.25}, {0, 0, 0}, 1.3};
  Scene scene = test::sceneOfBodies({test::bodyOf(test::sphere({0, 0, 0}, radius, 4), thin)});
  scene.lighting.ambient = {1, 1, 1};
  Eye eye(scene);
  eye.tracer().run(400'000);
  constexpr int places = 2000;
  double sum = 0;
  for (int i = 0; i < places; ++i) {
    const double across = radius * std::sqrt((i + 0.5) / places);
    const Vector place{across * std::cos(2.4 * i), across * std::sin(2.4 * i), 0};
    sum += eye.radianceFrom(place + Vector{0, 0, 60}, place, 1000)[1] / places;
  }
  EXPECT_NEAR(sum, 1, 0.01);
}

// Nor is a white glossy ball beside it, which gives back light that went straight through it.
TEST(OpaqueTruthTest, LightThroughMediaIsCountedOnce) {
  OpaqueMaterial glossy = mattMaterial({1, 1, 1});
  glossy.specular = 1;
  glossy.roughness = 0.3F;
  const Medium thin{"thin", {0.25, 0.25, 0.25}, {0, 0, 0}, 1.3};
  Scene scene = test::sceneOfBodies({opaqueBody(test::sphere({0, 0, 0}, 2, 4), glossy),
                                     test::bodyOf(test::sphere({3, 0, 1.5F}, 1.2F, 4), thin)});
  scene.lighting.ambient = {1, 1, 1};
  Eye eye(scene);
  eye.tracer().run(1'000'000);
  constexpr int across = 40;
  double sum = 0;
  for (int i = 0; i < across * across; ++i) {
    const Vector place{0.5 + 0.02 * (i % across), 0.02 * (i / across) - 0.4, 0};
    sum += eye.radianceFrom(place + Vector{0, 0, 60}, place, 40)[1] / (across * across);
  }
  EXPECT_NEAR(sum, 1, 0.01);
}

/// A material whose left half is transparent.
OpaqueMaterial halfCutOut() {
  TexturePixels pixels;
  pixels.width = 2;
  pixels.height = 1;
  pixels.rgba = {65535, 65535, 65535, 0, 65535, 65535, 65535, 65535};
  OpaqueMaterial material = mattMaterial({1, 1, 1});
  material.baseColorTexture.emplace();
  material.baseColorTexture->pixels = std::make_shared<const TexturePixels>(pixels);
  material.baseColorTexture->interpolated = false;
  material.alphaCutoff = 0.5F;
  return material;
}

TEST(OpaqueTruthTest, LightPassesWhatIsCutOut) {
  Scene scene = test::sceneOfBodies({opaqueBody(square({0, 0, 0}, 10), mattMaterial({1, 1, 1})),
                                     opaqueBody(square({0, 0, 8}, 10), halfCutOut())});
  scene.lighting.directional = {{{0, 0, 1}, {1, 1, 1}}};
  EXPECT_NEAR(Eye(scene, 0).radianceFrom({-5, 0, 4}, {-5, 0, 0}, 1)[0], 1 / pi, 1e-6);
  EXPECT_NEAR(Eye(scene, 0).radianceFrom({5, 0, 4}, {5, 0, 0}, 1)[0], 0, 1e-6);
  EXPECT_NEAR(Eye(scene, 0).radianceFrom({-5, 0, 40}, {-5, 0, 0}, 1)[0], 1 / pi, 1e-6);
}

TEST(OpaqueTruthTest, ALampFoundByRaysAndBySamplesIsOne) {
  OpaqueMaterial polished;
  polished.baseColor = {0.6F, 0.6F, 0.6F};
  polished.metallic = 1;
  polished.roughness = 0.1F;
  Scene scene = test::sceneOfBodies({opaqueBody(square({0, 0, 0}, 10), polished)});
  scene.lighting.areas = {DiscLight{{0, 0, 30}, {0, 0, -1}, 20, {1, 1, 1}}};
  // The lobe lies within the disc, so it is as bright as the mirror image of a white sky.
  Scene sky = scene;
  sky.lighting = {};
  sky.lighting.ambient = {1, 1, 1};
  EXPECT_NEAR(Eye(scene).radianceFrom({0, 0, 5}, {0, 0, 0}, 20'000)[1],
              Eye(sky).radianceFrom({0, 0, 5}, {0, 0, 0}, 20'000)[1], 0.006);
}

// With the exact integral, opaque bodies show the direct light of lights and sky, and cast shadows
// on media.
TEST(OpaqueTruthTest, TheIntegralKnowsDirectLight) {
  Scene scene =
      test::sceneOfBodies({test::bodyOf(test::sphere({0, 0, 0}, 5, 4)),
                           opaqueBody(square({0, 0, -6}, 50), mattMaterial({0.5F, 0.5F, 0.5F}))});
  scene.lighting.directional = {{{0, 0, 1}, {2, 2, 2}}};
  scene.camera.positionMm = {0, 60, 60};
  const Geometry geometry(scene);
  const Irradiance irradiance(geometry);
  PictureOptions options;
  options.width = options.height = edge;
  options.aov = Aov::Exitance;
  const Image lit =
      integralTruth(geometry, irradiance, {.tolerance = 0.01}, options, {}).picture.image;
  options.aov = Aov::Object;
  const Image objects = integralTruth(geometry, irradiance, {}, options, {}).picture.image;
  int floor = 0;
  int shaded = 0;
  for (int y = 0; y < edge; ++y)
    for (int x = 0; x < edge; ++x) {
      if (objects.pixel(x, y)[3] == 0 || objects.pixel(x, y)[0] != 1) continue;
      const double found{lit.pixel(x, y)[1]};
      if (found == 0)
        ++shaded;
      else
        EXPECT_NEAR(found, 1, 1e-6);
      ++floor;
    }
  EXPECT_GT(floor, 50);
  EXPECT_GT(shaded, 0);
}

// A ball on an endless ground, lit from straight above. Of the light from a place of the ground at
// distance d from the ball's middle, (R/d)³ hits it. The ground is lit from R√2 on. That gives ρ√2
// of the light from above, without further bounces.
TEST(OpaqueTruthTest, AnEndlessGroundLightsABall) {
  const Medium white{"white", {1, 1, 1}, {0, 0, 0}, 1.01};
  Scene scene = test::sceneOfBodies({test::bodyOf(test::sphere({0, 5, 0}, 5, 4), white)});
  scene.lighting.directional = {{{0, 1, 0}, {1, 1, 1}}};
  const auto leftOf = [&] {
    Eye eye(scene, 1);
    eye.tracer().run(400'000);
    return fluxThatLeft(eye.tracer());
  };
  EXPECT_NEAR(leftOf() / (pi * 25), 1, 0.01);
  Body ground = test::bodyOf(test::sheet({0, -0.001F, 0}, {0, 0, 9000}, {9000, 0, 0}, 1));
  ground.opaque = mattMaterial({0.5F, 0.5F, 0.5F});
  ground.isGround = true;
  scene.bodies.push_back(ground);
  EXPECT_NEAR(leftOf() / (pi * 25), 1 + 0.5 * std::sqrt(2.0), 0.03);
}

// Half of even light comes from below a black ground, and does not reach a ball on it; nor do
// lights from there.
TEST(OpaqueTruthTest, AnEndlessGroundHidesWhatIsBelow) {
  const Medium white{"white", {1, 1, 1}, {0, 0, 0}, 1.01};
  Scene scene = test::sceneOfBodies({test::bodyOf(test::sphere({0, 5, 0}, 5, 4), white)});
  scene.lighting.ambient = {1, 1, 1};
  const auto leftOf = [&] {
    Eye eye(scene, 1);
    eye.tracer().run(80'000);
    return fluxThatLeft(eye.tracer());
  };
  const double everywhere = leftOf();
  EXPECT_NEAR(everywhere / (pi * 4 * pi * 25), 1, 0.01);
  Body ground = test::bodyOf(test::sheet({0, -0.001F, 0}, {0, 0, 9000}, {9000, 0, 0}, 1));
  ground.opaque = mattMaterial({0, 0, 0});
  ground.isGround = true;
  scene.bodies.push_back(ground);
  EXPECT_NEAR(leftOf() / everywhere, 0.5, 0.015);
  Image even(8, 4);
  for (float& value : even.rgba) value = 1;
  scene.lighting.ambient = {0, 0, 0};
  scene.lighting.environment = std::make_shared<const Image>(even);
  EXPECT_NEAR(leftOf() / everywhere, 0.5, 0.015);
  scene.lighting.environment = nullptr;
  scene.lighting.directional = {{{1, -0.1F, 0}, {1, 1, 1}}};
  EXPECT_EQ(leftOf(), 0);
}

// A ground does not count towards sizes.
TEST(OpaqueTruthTest, AGroundCountsForNoSize) {
  Scene scene = test::sceneOfBodies({test::bodyOf(test::sphere({0, 0, 0}, 5, 3))});
  const double alone = boxOf(scene).diagonalMm();
  scene.bodies.push_back(opaqueBody(square({0, 0, -5}, 5000), mattMaterial({1, 1, 1})));
  scene.bodies[1].isGround = true;
  EXPECT_EQ(boxOf(scene).diagonalMm(), alone);
}

OpaqueMaterial paper(double through, const Rgb& color) {
  OpaqueMaterial material = mattMaterial({1, 1, 1});
  material.diffuseTransmission = static_cast<float>(through);
  material.diffuseTransmissionColor = color;
  return material;
}

// Lambert's law on the other side, by paths and by the exact integral's direct light.
TEST(OpaqueTruthTest, LightGoesThroughASheet) {
  Scene scene = test::sceneOfBodies({opaqueBody(square({0, 0, 0}, 10), paper(0.4, {1, 0.5F, 0}))});
  scene.lighting.directional = {{{0.6F, 0, 0.8F}, {3, 3, 3}}};
  const Colour behind = Eye(scene).radianceFrom({0, 0, -40}, {1, 1, 0}, 1);
  EXPECT_NEAR(behind[0], 0.4 * 0.8 * 3 / pi, 1e-6);
  EXPECT_NEAR(behind[1], 0.2 * 0.8 * 3 / pi, 1e-6);
  EXPECT_EQ(behind[2], 0);
  EXPECT_NEAR(Eye(scene).radianceFrom({0, 0, 40}, {1, 1, 0}, 1)[2], 0.6 * 0.8 * 3 / pi, 1e-6);
  const Geometry geometry(scene);
  const Irradiance irradiance(geometry);
  const auto hit = geometry.closestHit(Vector{1, 1, -40}, Vector{0, 0, 1});
  const Look look{hit->point, {0, 0, -1}, true, 0};
  EXPECT_NEAR(directLightOf(scene, irradiance, look).value[1], 0.2 * 0.8 * 3 / pi, 1e-6);
}

// In a white furnace a white lantern is invisible, with a mirroring surface or without, also to a
// ball inside.
TEST(OpaqueTruthTest, ALanternIsNotSeenInAWhiteFurnace) {
  for (const float specular : {0.0F, 1.0F}) {
    OpaqueMaterial material = paper(0.5, {1, 1, 1});
    material.specular = specular;
    material.roughness = 0.4F;
    Scene scene = test::sceneOfBodies({opaqueBody(test::sphere({0, 0, 0}, 8, 4), material)});
    scene.lighting.ambient = {1, 1, 1};
    for (const double across : {0.0, 4.0, 6.0})
      EXPECT_NEAR(Eye(scene).radianceFrom({across, 0, 60}, {across, 0, 0}, 30'000)[1], 1, 0.015)
          << specular << " " << across;
    const Medium white{"white", {1, 1, 1}, {0, 0, 0}, 1.01};
    scene.bodies.push_back(test::bodyOf(test::sphere({0, 0, 0}, 5, 4), white));
    Eye eye(scene);
    eye.tracer().run(60'000);
    EXPECT_NEAR(fluxThatLeft(eye.tracer()) / (pi * 4 * pi * 25), 1, 0.02) << specular;
  }
}

// All light of a lamp in a white lantern gets out, evenly.
TEST(OpaqueTruthTest, ALampInALantern) {
  Scene scene =
      test::sceneOfBodies({opaqueBody(test::sphere({0, 0, 0}, 10, 4), paper(0.3, {1, 1, 1}))});
  scene.lighting.points = {{{0, 0, 0}, {100, 100, 100}}};
  EXPECT_NEAR(Eye(scene).radianceFrom({3, 0, 40}, {3, 0, 0}, 200'000)[0], 1 / pi, 0.01 / pi);
}

TEST(OpaqueTruthTest, EqualPicturesOnAnyNumberOfThreads) {
  Scene scene =
      test::sceneOfBodies({opaqueBody(test::sphere({0, 0, 0}, 5, 2), luminous(0.1, 0.5))});
  scene.lighting.ambient = {1, 1, 1};
  const Geometry geometry(scene);
  const Irradiance irradiance(geometry);
  const PathTracer tracer(geometry, {});
  PictureOptions options;
  options.width = options.height = edge;
  options.antialias = 1;
  options.pathsOfPixel = 3;
  Image one;
  onThreads(1, [&] { one = pathTruth(tracer, geometry, irradiance, options).image; });
  EXPECT_EQ(one.rgba, pathTruth(tracer, geometry, irradiance, options).image.rgba);
}

}  // namespace
}  // namespace opaline::reference
