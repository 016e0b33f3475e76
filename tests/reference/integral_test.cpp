// The surface integral against closed forms and one-dimensional quadrature.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

#include "bssrdf/fresnel.h"
#include "bssrdf/profile.h"
#include "opaline/error.h"
#include "reference/bodies.h"
#include "reference/integral.h"

namespace opaline {
namespace {

using namespace test;
using reference::Geometry;
using reference::Integral;
using reference::Irradiance;

using std::numbers::pi;

/// Simpson's rule on intervals that grow by a constant factor.
double quadrature(const std::function<double(double)>& f, double from, double to) {
  constexpr int panels = 400;
  constexpr double smallest = 1e-4;
  double sum = 0;
  double begin = 0;
  const double factor = std::pow((to - from) / smallest + 1, 1.0 / panels);
  for (int i = 1; i <= panels; ++i) {
    const double end = i == panels ? to - from : smallest * (std::pow(factor, i) - 1);
    sum +=
        (end - begin) / 6 * (f(from + begin) + 4 * f(from + 0.5 * (begin + end)) + f(from + end));
    begin = end;
  }
  return sum;
}

reference::SurfacePoint pointAt(const Vector& position, std::uint32_t body = 0) {
  reference::SurfacePoint point;
  point.position = position;
  point.body = body;
  return point;
}

/// A scene and everything needed to integrate over it.
struct Solved {
  reference::Scene scene;
  Geometry geometry;
  Irradiance irradiance;
  Integral integral;

  Solved(reference::Scene given, Transport transport, double tolerance)
      : scene(std::move(given)),
        geometry(scene),
        irradiance(geometry),
        integral(geometry, irradiance, {transport, tolerance}) {}

  reference::Exitance at(const Vector& position) const { return integral.at(pointAt(position)); }
};

reference::Scene uniformlyLit(const Mesh& mesh) {
  auto scene = sceneOfBodies({bodyOf(mesh)});
  scene.lighting.ambient = {1, 1, 1};
  return scene;
}

double discOf(Transport transport, std::size_t channel, double radius) {
  if (transport == Transport::Dipole) return DipoleByTheBook(marble(), channel).disc(radius);
  return bssrdf::makeProfile(bssrdf::Model::BetterDipole,
                             bssrdf::coefficients(marble(), static_cast<int>(channel)))
      .disc(radius);
}

// ---- uniform light: E = π F̄_t

const double entered = pi * bssrdf::meanTransmittance(1.5);

/// A circle of triangles around its centre, with 64 sides and the disc's area. The edge's deviation
/// of 0.1 % from the circle only matters squared.
Mesh discMesh(double radius) {
  constexpr std::uint32_t sides = 64;
  const double step = 2 * pi / sides;
  radius *= std::sqrt(step / std::sin(step));
  Mesh mesh;
  mesh.positionsMm.push_back({0, 0, 0});
  for (std::uint32_t i = 0; i < sides; ++i) {
    mesh.positionsMm.push_back(
        toVec3({radius * std::cos(step * i), radius * std::sin(step * i), 0}));
    mesh.triangles.push_back({0, i + 1, (i + 1) % sides + 1});
  }
  mesh.normals.assign(mesh.positionsMm.size(), {0, 0, 1});
  return mesh;
}

class TransportTest : public testing::TestWithParam<Transport> {};

TEST_P(TransportTest, DiscHasItsClosedForm) {
  for (const double radius : {0.2, 2.0, 12.0}) {
    const Solved solved(uniformlyLit(discMesh(radius)), GetParam(), 1e-5);
    const auto found = solved.at({0, 0, 0});
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(found.value[c] / (entered * discOf(GetParam(), c, radius)), 1, 2e-5)
          << radius << " mm, channel " << c;
    }
  }
}

TEST_P(TransportTest, PlaneHasTheTotalReflectance) {
  const Solved solved(uniformlyLit(sheet({0, 0, 0}, {120, 0, 0}, {0, 120, 0}, 7)), GetParam(),
                      1e-5);
  for (const Vector& place : {Vector{0, 0, 0}, Vector{3.3, -7.1, 0}}) {
    const auto found = solved.at(place);
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(found.value[c] / (entered * discOf(GetParam(), c, 1e9)), 1, 2e-5);
      EXPECT_LE(found.error[c], 1e-5 * found.value[c]);
    }
  }
}

// B = E · D(2R): on a sphere the area element is 2π r dr in the chord r. The mesh's vertices lie on
// the sphere. The error of the facets falls with the square of their size, so two meshes give the
// limit (Richardson 1911).
TEST_P(TransportTest, SphereHasItsClosedForm) {
  for (const double radius : {0.5, 3.0, 25.0}) {
    std::array<reference::Exitance, 2> found;
    for (int i = 0; i < 2; ++i) {
      const Mesh mesh = sphere({0, 0, 0}, static_cast<float>(radius), 4 + i);
      const Solved solved(uniformlyLit(mesh), GetParam(), 1e-5);
      found[static_cast<std::size_t>(i)] = solved.at(toVector(mesh.positionsMm[0]));
    }
    for (std::size_t c = 0; c < 3; ++c) {
      const double value = (4 * found[1].value[c] - found[0].value[c]) / 3;
      EXPECT_NEAR(value / (entered * discOf(GetParam(), c, 2 * radius)), 1, 1e-4)
          << radius << " mm, channel " << c;
    }
  }
}

// Only the facets differ from the closed form. Each lies below the sphere by the square of its
// size, so the order is two.
TEST_P(TransportTest, ConvergesWithTheSquareOfTheFacets) {
  constexpr float radius = 3;
  std::array<double, 3> errors{};
  for (int i = 0; i < 3; ++i) {
    const Mesh mesh = sphere({0, 0, 0}, radius, 3 + i);
    const Solved solved(uniformlyLit(mesh), GetParam(), 1e-6);
    const double found = solved.at(toVector(mesh.positionsMm[0])).value[0];
    errors[static_cast<std::size_t>(i)] =
        std::abs(found / (entered * discOf(GetParam(), 0, 2.0 * radius)) - 1);
  }
  for (std::size_t i = 0; i < 2; ++i) {
    const double order = std::log2(errors[i] / errors[i + 1]);
    EXPECT_NEAR(order, 2, 0.1) << errors[i] << " then " << errors[i + 1];
  }
}

// The error is within the tolerance, judged by a tolerance a thousand times smaller.
TEST_P(TransportTest, ErrorIsWithinTheTolerance) {
  const auto scene = uniformlyLit(box({0, 0, 0}, {6, 4, 9}, 3));
  const Solved exact(scene, GetParam(), 1e-6);
  for (const double tolerance : {0.1, 1e-2, 1e-3}) {
    const Solved solved(scene, GetParam(), tolerance);
    for (const Vector& place : {Vector{6, 0, 0}, Vector{6, 4, 9}, Vector{-1, 4, 2}}) {
      const auto found = solved.at(place);
      const auto truth = exact.at(place);
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_LE(std::abs(found.value[c] / truth.value[c] - 1), tolerance);
        EXPECT_LE(found.error[c], tolerance * found.value[c]);
        EXPECT_LE(std::abs(found.value[c] - truth.value[c]), found.error[c] + truth.error[c]);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Both, TransportTest,
                         testing::Values(Transport::Dipole, Transport::BetterDipole),
                         [](const auto& tested) {
                           return std::string(tested.param == Transport::Dipole ? "Dipole"
                                                                                : "BetterDipole");
                         });

// ---- light that changes over the surface

// A lamp at height H: E(r) = I H/(H² + r²)^(3/2) F_t.
TEST(IntegralTest, PlaneUnderALamp) {
  for (const double height : {0.5, 6.0}) {
    auto scene = sceneOfBodies({bodyOf(sheet({0, 0, 0}, {100, 0, 0}, {0, 100, 0}, 8))});
    scene.lighting.points = {{{0, 0, static_cast<float>(height)}, {10, 10, 10}}};
    const Solved solved(scene, Transport::Dipole, 1e-4);
    const auto found = solved.at({0, 0, 0});
    for (std::size_t c = 0; c < 3; ++c) {
      const DipoleByTheBook dipole(marble(), c);
      const double exact = quadrature(
          [&](double r) {
            const double distance = std::hypot(r, height);
            const double irradiance =
                10 * height / std::pow(distance, 3) * fresnelTransmittance(1.5, height / distance);
            return 2 * pi * r * irradiance * dipole(r);
          },
          0, 100);
      EXPECT_NEAR(found.value[c] / exact, 1, 1e-4) << height << " mm, channel " << c;
    }
  }
}

// A sphere of radius ρ at height H, wholly above the horizon: E(r) = π L (ρ/d)² H/d. Fresnel's term
// is negligible.
TEST(IntegralTest, PlaneUnderASphereLight) {
  Medium medium = marble();
  medium.eta = 1.01;
  auto scene = sceneOfBodies({bodyOf(sheet({0, 0, 0}, {30, 0, 0}, {0, 30, 0}, 8))});
  scene.bodies[0].medium = medium;
  scene.lighting.areas = {SphereLight{{0, 0, 10}, 3, {10, 10, 10}}};
  const Geometry geometry(scene);
  const Irradiance irradiance(geometry);
  for (const double x : {0.0, 5.0, 12.0}) {
    const auto hit = geometry.closestHit(Vector{x, 0.1, 1}, Vector{0, 0, -1});
    ASSERT_TRUE(hit);
    const double d = std::sqrt(x * x + 100.01);
    EXPECT_NEAR(irradiance(hit->point)[1] / (10 * pi * 9 * 10 / (d * d * d)), 1, 0.01) << x;
  }
}

// The same lamp with a cone of 40° to 60°: the cosine to its axis is H/√(H² + r²).
TEST(IntegralTest, PlaneUnderASpotLight) {
  const double height = 6;
  auto scene = sceneOfBodies({bodyOf(sheet({0, 0, 0}, {100, 0, 0}, {0, 100, 0}, 8))});
  scene.lighting.spots = {{{0, 0, 6}, {0, 0, -1}, {10, 10, 10}, 40, 60}};
  const Solved solved(scene, Transport::Dipole, 1e-4);
  const auto found = solved.at({0, 0, 0});
  const double inner = std::cos(40 * pi / 180);
  for (std::size_t c = 0; c < 3; ++c) {
    const DipoleByTheBook dipole(marble(), c);
    const double exact = quadrature(
        [&](double r) {
          const double distance = std::hypot(r, height);
          const double cosine = height / distance;
          const double part = std::clamp((cosine - 0.5) / (inner - 0.5), 0.0, 1.0);
          const double irradiance =
              part * part * 10 * height / std::pow(distance, 3) * fresnelTransmittance(1.5, cosine);
          return 2 * pi * r * irradiance * dipole(r);
        },
        0, 10.5);  // mm, where the cone ends
    EXPECT_NEAR(found.value[c] / exact, 1, 2e-4) << "channel " << c;
  }
}

// The pole of a ball that faces the sun: ∫ cos θ F_t R_d(2R sin θ/2) 2πR² sin θ dθ.
TEST(IntegralTest, BallInTheSun) {
  constexpr double radius = 5;
  std::array<reference::Exitance, 2> found;
  for (int i = 0; i < 2; ++i) {
    const Mesh mesh = sphere({0, 0, 0}, radius, 4 + i);
    auto scene = sceneOfBodies({bodyOf(mesh)});
    scene.lighting.directional = {{mesh.normals[0], {1, 1, 1}}};
    const Solved solved(scene, Transport::Dipole, 1e-4);
    found[static_cast<std::size_t>(i)] = solved.at(toVector(mesh.positionsMm[0]));
  }
  for (std::size_t c = 0; c < 3; ++c) {
    const DipoleByTheBook dipole(marble(), c);
    const double exact = quadrature(
        [&](double angle) {
          const double cosine = std::max(std::cos(angle), 0.0);
          return 2 * pi * radius * radius * std::sin(angle) * cosine *
                 fresnelTransmittance(1.5, cosine) * dipole(2 * radius * std::sin(angle / 2));
        },
        0, pi / 2);
    EXPECT_NEAR((4 * found[1].value[c] - found[0].value[c]) / 3 / exact, 1, 2e-4)
        << "channel " << c;
  }
}

// ---- shadows

/// Exitance at a signed distance from the straight border of a shadow, positive in the light: the
/// circle of radius r around it is lit over an angle of 2 arccos(-distance/r).
double besideShadow(const DipoleByTheBook& dipole, double distance) {
  const double irradiance = fresnelTransmittance(1.5, 1);
  const double whole = distance > 0 ? dipole.disc(distance) : 0;
  // r = √(distance² + t²), r dr = t dt.
  const double rest = quadrature(
      [&](double t) {
        const double r = std::hypot(distance, t);
        return t > 0 || distance != 0 ? 2 * std::acos(-distance / r) * dipole(r) * t : 0;
      },
      0, 100);
  return irradiance * (whole + rest);
}

/// A sheet under the sun, half of it in the shadow of another, whose edge has that angle.
reference::Scene halfShadowed(double angle) {
  const Vector across{std::cos(angle), std::sin(angle), 0};
  const Vector along{-across[1], across[0], 0};
  const Vector middle = Vector{0, 0, 5} - 150 * across;
  auto scene =
      sceneOfBodies({bodyOf(sheet({0, 0, 0}, {100, 0, 0}, {0, 100, 0}, 60)),
                     bodyOf(sheet(toVec3(middle), toVec3(150 * across), toVec3(150 * along), 1))});
  scene.lighting.directional = {{{0, 0, 1}, {1, 1, 1}}};
  return scene;
}

// With a mesh aligned with the border and with one that is not.
TEST(ShadowTest, HalfPlane) {
  for (const double angle : {0.0, 0.3}) {
    const Solved solved(halfShadowed(angle), Transport::Dipole, 1e-3);
    for (const double distance : {-6.0, -2.0, -0.5, -0.1, 0.0, 0.1, 0.5, 2.0, 6.0}) {
      const auto found = solved.at({distance * std::cos(angle), distance * std::sin(angle), 0});
      for (std::size_t c = 0; c < 3; ++c) {
        const double exact = besideShadow(DipoleByTheBook(marble(), c), distance);
        EXPECT_NEAR(found.value[c] / exact, 1, 1e-3)
            << angle << ", " << distance << " mm, channel " << c;
        EXPECT_LE(std::abs(found.value[c] - exact), found.error[c] + 1e-6 * exact)
            << angle << ", " << distance << " mm, channel " << c;
        EXPECT_LE(found.error[c], 1e-3 * exact);
      }
    }
  }
}

// ---- what must stay separate

TEST(IntegralTest, BodiesDoNotLeakIntoEachOther) {
  auto scene = halfShadowed(0);
  const Solved solved(scene, Transport::Dipole, 1e-2);
  // The upper sheet is in the sun, the lower one is not; neither affects the other.
  const double upper = solved.integral.at(pointAt({-100, 0, 5}, 1)).value[0];
  EXPECT_NEAR(upper / besideShadow(DipoleByTheBook(marble(), 0), 100), 1, 1e-2);
  EXPECT_LT(solved.at({-60, 0, 0}).value[0], 1e-3 * upper);
}

TEST(IntegralTest, DarknessIsDark) {
  auto scene = sceneOfBodies({bodyOf(sphere({0, 0, 0}, 2, 2))});
  const Solved solved(scene, Transport::Dipole, 1e-3);
  EXPECT_EQ(solved.at({0, 0, 2}).value, (reference::Colour{}));
  EXPECT_EQ(solved.integral.patchCount(), 0U);
}

TEST(IntegralTest, OptionsOutOfRangeAreRefused) {
  const auto scene = sceneOfBodies({bodyOf(sphere({0, 0, 0}, 2, 1))});
  const Geometry geometry(scene);
  const Irradiance irradiance(geometry);
  for (const double tolerance : {0.0, -1.0, 0.9, std::nan("")}) {
    EXPECT_THROW(Integral(geometry, irradiance, {Transport::Dipole, tolerance}), UsageError);
  }
}

}  // namespace
}  // namespace opaline
