// Opaque objects inside a body, against closed forms of diffusion in a ball with a concentric core.
// The light is even, or its radiance varies with a cosine: the first two terms of the expansion in
// Legendre polynomials.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "bssrdf/fresnel.h"
#include "environment/lat_long.h"
#include "renderer/boundary_fixture.h"

namespace opaline {
namespace {

using namespace test;
using std::numbers::pi;

using BoundaryLiningTest = RendererTest;

constexpr float ballMm = 10;
constexpr float coreMm = 5;

/// A mean free path is at most a twentieth of the shell, so that diffuse light starts at the
/// surface. Little is absorbed on the way to the core.
Medium cream() {
  return {"cream", {4, 2.5F, 1.5F}, {0.002F, 0.008F, 0.012F}, 1.4};
}

Mesh turned(Mesh mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  for (Vec3& normal : mesh.normals) normal = {-normal[0], -normal[1], -normal[2]};
  return mesh;
}

OpaqueMaterial matt(const Rgb& color) {
  OpaqueMaterial material;
  material.baseColor = color;
  material.metallic = 0;
  return material;
}

Object coreOf(const Mesh& mesh, const Rgb& color) {
  Object core;
  core.name = "core";
  core.mesh = mesh;
  core.opaque = matt(color);
  return core;
}

Scene ballAround(const Object& core) {
  Scene scene = ballOf(ballMm, cream());
  scene.objects.push_back(core);
  return scene;
}

constexpr double slope = 0.8;  // of the sky's radiance, 1 + slope cos θ to +x

std::shared_ptr<const Image> slopingSky() {
  constexpr int height = 64;
  Image image(2 * height, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < 2 * height; ++x) {
      const Vec3 direction = latLongDirection((x + 0.5) / (2 * height), (y + 0.5) / height);
      for (int c = 0; c < 3; ++c)
        image.pixel(x, y)[c] = static_cast<float>(1 + slope * double{direction[0]});
    }
  return std::make_shared<const Image>(std::move(image));
}

/// Diffusion in a shell: coefficients in one channel (Grosjean 1956; d'Eon and Irving 2011).
struct Diffusion {
  double d;
  double sigma;
  double a;
  double kappa;

  Diffusion(const Medium& medium, std::size_t c) {
    const double scattering{medium.sigmaSPrimePerMm[c]};
    const double absorption{medium.sigmaAPerMm[c]};
    const double extinction = scattering + absorption;
    d = (2 * absorption + scattering) / (3 * extinction * extinction);
    sigma = std::sqrt(absorption / d);
    a = (1 + bssrdf::threeC2(medium.eta)) / (1 - bssrdf::twoC1(medium.eta));
    kappa = 2 / (1 + bssrdf::threeC2(medium.eta));
  }
};

/// Modified spherical Bessel functions of order 0 and 1, and their derivatives.
struct Radial {
  double value;
  double slope;
};
Radial growing(int order, double x) {
  const double s = std::sinh(x);
  const double c = std::cosh(x);
  if (order == 0) return {s / x, c / x - s / (x * x)};
  return {c / x - s / (x * x), s / x - 2 * c / (x * x) + 2 * s / (x * x * x)};
}
Radial falling(int order, double x) {
  const double e = std::exp(-x);
  if (order == 0) return {e / x, -e / x - e / (x * x)};
  return {e / x + e / (x * x), -e / x - 2 * e / (x * x) - 2 * e / (x * x * x)};
}

/// What leaves the ball over what has entered, of one order. The conditions are -D φ' = φ/2A - κE
/// outside and D φ' = φ/2A' at the core, and M = φ/2A - (κ - 1) E. `overA` is 1/A'.
double leaves(const Diffusion& of, int order, double overA) {
  const auto at = [&](double mm, Radial (*function)(int, double)) {
    const Radial found = function(order, of.sigma * mm);
    return Radial{found.value, of.sigma * found.slope};
  };
  const Radial outerGrowing = at(ballMm, growing);
  const Radial outerFalling = at(ballMm, falling);
  const Radial innerGrowing = at(coreMm, growing);
  const Radial innerFalling = at(coreMm, falling);
  const auto inner = [&](const Radial& f) { return of.d * f.slope - overA / 2 * f.value; };
  const auto outer = [&](const Radial& f) { return of.d * f.slope + f.value / (2 * of.a); };
  const double part = -inner(innerGrowing) / inner(innerFalling);  // falling per growing function
  const double weight = of.kappa / (outer(outerGrowing) + part * outer(outerFalling));
  const double fluence = weight * (outerGrowing.value + part * outerFalling.value);
  return fluence / (2 * of.a) - (of.kappa - 1);
}

/// ∫ F_t μ (1 + slope cos θ) dω over the hemisphere about a normal of cos θ = `cosine`.
double entering(double eta, double cosine) {
  constexpr int steps = 2000;
  double first = 0;
  for (int i = 0; i < steps; ++i) {
    const double mu = (i + 0.5) / steps;
    first += 2 * pi * (1 - bssrdf::fresnelReflectance(eta, mu)) * mu * mu / steps;
  }
  return pi * bssrdf::meanTransmittance(eta) + slope * cosine * first;
}

constexpr std::size_t bands = 10;

struct Pictures {
  Image exitance;
  Image position;
  Vec3 cameraMm;

  auto inBands(const Image& image) const {
    return exitanceOfBands<bands>(image, position, cameraMm);
  }
};

void lightBySky(Scene& scene) {
  scene.lighting = {};
  scene.lighting.environment = slopingSky();
}

RenderOptions optionsWith(int maxClusters) {
  RenderOptions options = boundaryOptions(40);
  options.maxClusters = maxClusters;
  return options;
}

Pictures underSky(Scene scene, const std::function<void(Renderer&)>& edit = {}) {
  lightBySky(scene);
  const RenderOptions options = optionsWith(2048);
  Renderer& renderer = *sharedRenderer().renderer;
  renderer.setScene(scene);
  if (edit) edit(renderer);
  std::vector<Image> images = renderer.render(options, {Aov::Exitance, Aov::Position}).images;
  return {std::move(images[0]), std::move(images[1]), scene.camera.positionMm};
}

/// `overA` has 1/A' at the core per channel.
Image exactOn(const Pictures& seen, const std::array<double, 3>& overA) {
  Image exact = seen.exitance;
  for (std::size_t c = 0; c < 3; ++c) {
    const Diffusion diffusion(cream(), c);
    const double even = entering(cream().eta, 0);
    const double sloping = entering(cream().eta, 1) - even;
    const double first = even * leaves(diffusion, 0, overA[c]);
    const double second = sloping * leaves(diffusion, 1, overA[c]);
    forEachCovered(exact, [&](std::size_t i) {
      const Vector outward = unit(toVector(&seen.position.rgba[i]));
      exact.rgba[i + c] = static_cast<float>(first + second * outward[0]);
    });
  }
  return exact;
}

void expectExact(const Pictures& seen, const std::array<double, 3>& overA) {
  const auto found = seen.inBands(seen.exitance);
  const auto exact = seen.inBands(exactOn(seen, overA));
  for (std::size_t band = 0; band < bands; ++band)
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(found[band][c] / exact[band][c], 1, 0.02) << c << " band " << band;
}

/// For a core that reflects evenly, by the exact extrapolation from a plane: 0.7104 mean free paths
/// in Milne's problem, where all light is absorbed, and 4/3 share/(1 - share) more otherwise.
/// Diffusion has 2/3 A'.
double overAOf(double share) {
  return (1 - share) / (1.5 * 0.7104 * (1 - share) + 2 * share);
}

// A core that is black in red, grey in green and white in blue.
TEST_F(BoundaryLiningTest, ABallWithACoreIsAsTheSeriesSays) {
  const Rgb share{0, 0.5F, 1};
  std::array<double, 3> overA{};
  for (std::size_t c = 0; c < 3; ++c) overA[c] = overAOf(double{share[c]});
  expectExact(underSky(ballAround(coreOf(sphere({0, 0, 0}, coreMm, 4), share))), overA);
}

// Where A' equals A, the core acts as air inside, from which nothing returns.
TEST_F(BoundaryLiningTest, AShareCanBeThatOfAFreeBoundary) {
  const double a = Diffusion(cream(), 0).a;
  const double more = a - 1.5 * 0.7104;  // 2 share / (1 - share)
  const auto share = static_cast<float>(more / (2 + more));
  const Mesh core = sphere({0, 0, 0}, coreMm, 4);
  const Pictures lined = underSky(ballAround(coreOf(core, {share, share, share})));
  Scene hollow = ballOf(ballMm, cream());
  hollow.objects[0].mesh = together(hollow.objects[0].mesh, turned(core));
  const Pictures free = underSky(hollow);
  EXPECT_LT(errorsOf(lined.exitance, free.exitance).rms, 0.005);
  expectExact(lined, {1 / a, 1 / a, 1 / a});
}

// Objects inside are found at rest, but are moved in every frame.
TEST_F(BoundaryLiningTest, GoesWithWhatMoves) {
  const Mesh middle = sphere({0, 0, 0}, coreMm, 4);
  Mesh aside = middle;
  for (Vec3& position : aside.positionsMm) position[0] += 3.5F;
  const auto move = [&](Renderer& renderer) { renderer.replacePositions(1, aside.positionsMm); };
  const Rgb black{0, 0, 0};
  const Pictures moved = underSky(ballAround(coreOf(middle, black)), move);
  const Pictures made = underSky(ballAround(coreOf(aside, black)));
  const Pictures still = underSky(ballAround(coreOf(middle, black)));
  EXPECT_LT(errorsOf(moved.exitance, made.exitance).rms, 0.01);
  EXPECT_GT(errorsOf(still.exitance, made.exitance).rms, 0.05);
}

// What lets light through ends none, and edits may turn one into the other.
TEST_F(BoundaryLiningTest, ComesAndGoesWithTheMaterial) {
  Scene scene = ballAround(coreOf(sphere({0, 0, 0}, coreMm, 3), {0, 0, 0}));
  lightBySky(scene);
  const RenderOptions options = optionsWith(512);
  Renderer& renderer = *sharedRenderer().renderer;
  renderer.setScene(scene);
  const Image solid = renderer.render(options).images[0];
  scene.objects[1].opaque->diffuseTransmission = 0.5F;
  renderer.setMaterial(1, materialOf(scene.objects[1]));
  const Image porous = renderer.render(options).images[0];
  renderer.setScene(scene);
  EXPECT_EQ(porous.rgba, renderer.render(options).images[0].rgba);
  EXPECT_GT(errorsOf(solid, porous).rms, 0.02);
}

}  // namespace
}  // namespace opaline
