// Rays: the pixel through which a point is seen, where rays hit surfaces, and what is in shadow.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "opaline/error.h"
#include "reference/bodies.h"
#include "reference/camera_rays.h"
#include "reference/geometry.h"
#include "reference/irradiance.h"

namespace opaline {
namespace {

using namespace test;
using reference::CameraRays;
using reference::Geometry;
using reference::Irradiance;

// The picture is 2 tan(fov/2) high at distance 1, row 0 on top, and square in its pixels.
TEST(CameraRaysTest, PixelsLieWhereThePinholeShowsThem) {
  Camera camera;
  camera.positionMm = {1, 2, 3};
  camera.targetMm = {1, 2, -5};
  camera.verticalFovDegrees = 90;
  const CameraRays rays(camera, 40, 20);
  for (const auto& [x, y] : {std::pair{0, 0}, {39, 0}, {20, 10}, {7, 19}}) {
    const auto ray = rays.through(x, y);
    const double across = (x + 0.5 - 20) / 10;
    const double above = (10 - y - 0.5) / 10;
    EXPECT_NEAR(ray.direction[0] / -ray.direction[2], across, 1e-14);
    EXPECT_NEAR(ray.direction[1] / -ray.direction[2], above, 1e-14);
    EXPECT_NEAR(length(ray.direction), 1, 1e-15);
    EXPECT_NEAR(rays.depthMm(ray.origin + 7 / -ray.direction[2] * ray.direction), 7, 1e-13);
  }
  const auto shifted = rays.through(20, 10, {0.5, -0.5});
  EXPECT_NEAR(shifted.direction[0] / -shifted.direction[2], 0.1, 1e-14);
  EXPECT_NEAR(shifted.direction[1], 0, 1e-14);
}

TEST(CameraRaysTest, UpAlongTheAxisStillShowsSomething) {
  Camera camera;
  camera.positionMm = {0, 10, 0};
  const auto ray = CameraRays(camera, 8, 8).through(0, 0);
  EXPECT_TRUE(std::isfinite(length(ray.direction)));
  EXPECT_LT(ray.direction[1], -0.9);
}

TEST(GeometryTest, HitsAreExactThoughRaysAreSingle) {
  const auto scene = sceneOfBodies({bodyOf(sheet({1000, 2000, 3}, {40, 0, 7}, {0, 40, 5}, 9))});
  const Geometry geometry(scene);
  const Vector direction = unit({0.1, -0.2, -1});
  const Vector origin{1003.3, 2001.7, 60};
  const auto hit = geometry.closestHit(origin, direction);
  ASSERT_TRUE(hit);
  // The plane through the centre and the half edges; its corners are in single precision.
  const Vector normal = unit({-280, -200, 1600});
  const double distance = dot(normal, Vector{1000, 2000, 3} - origin) / dot(normal, direction);
  EXPECT_NEAR(hit->distanceMm, distance, 1e-4);
  EXPECT_NEAR(length(hit->point.position - (origin + hit->distanceMm * direction)), 0, 1e-11);
  EXPECT_NEAR(dot(hit->point.facetNormal, normal), 1, 1e-6);
  EXPECT_FALSE(geometry.closestHit(origin, unit({0, 0, 1})));
}

// A ball shadows one half of itself, whatever its size; no facet shadows itself or its neighbours.
TEST(GeometryTest, ABallShadesJustItsFarHalf) {
  for (const float radius : {0.001F, 1.0F, 5000.0F}) {
    const auto scene =
        sceneOfBodies({bodyOf(sphere({3 * radius, -radius, 2 * radius}, radius, 4))});
    const Geometry geometry(scene);
    const Vector toLight = unit({0.3, 0.8, -0.5});
    for (std::uint32_t t = 0; t < scene.bodies[0].triangles.size(); ++t) {
      const auto point = geometry.pointOn(0, t, {0.2, 0.5, 0.3});
      const double facing = dot(point.facetNormal, toLight);
      if (std::abs(facing) < 1e-3) continue;
      EXPECT_EQ(geometry.occluded(point, toLight), facing < 0) << t << " at " << facing;
    }
  }
}

TEST(GeometryTest, AShadowEndsAtTheLight) {
  const auto scene = sceneOfBodies({bodyOf(sheet({0, 0, 0}, {5, 0, 0}, {0, 5, 0}, 4)),
                                    bodyOf(sheet({0, 0, 2}, {5, 0, 0}, {0, 5, 0}, 4))});
  const Geometry geometry(scene);
  const auto point = geometry.pointOn(0, 5, {0.3, 0.3, 0.4});
  EXPECT_TRUE(geometry.occluded(point, {0, 0, 1}, 2.001));
  EXPECT_FALSE(geometry.occluded(point, {0, 0, 1}, 1.999));
  EXPECT_FALSE(geometry.occluded(point, {0, 0, -1}));
}

TEST(GeometryTest, ABodyWithoutSurfaceIsNotThere) {
  const auto scene = sceneOfBodies(
      {reference::Body{{}, {}, {}, marble()}, bodyOf(sheet({0, 0, 0}, {5, 0, 0}, {0, 5, 0}, 2))});
  const auto hit = Geometry(scene).closestHit(Vector{1, 1, 9}, Vector{0, 0, -1});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->point.body, 1U);
  EXPECT_EQ(hit->distanceMm, 9);
}

TEST(GeometryTest, WhatMakesNoSenseIsRefused) {
  const auto good = sceneOfBodies({bodyOf(sheet({0, 0, 0}, {5, 0, 0}, {0, 5, 0}, 2))});
  EXPECT_NO_THROW(Geometry{good});
  auto bad = good;
  bad.bodies[0].triangles[0][1] = 99;
  EXPECT_THROW(Geometry{bad}, Error);
  bad = good;
  bad.bodies[0].positionsMm[0][2] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(Geometry{bad}, Error);
  bad = good;
  bad.bodies[0].medium.sigmaSPrimePerMm[1] = 0;
  EXPECT_THROW(Geometry{bad}, Error);
  bad = good;
  bad.lighting.points = {{{0, 0, 1}, {-1, 0, 0}}};
  EXPECT_THROW(Geometry{bad}, Error);
  bad = good;
  bad.camera.positionMm = bad.camera.targetMm;
  EXPECT_THROW(Geometry{bad}, Error);
  EXPECT_THROW(Geometry{reference::Scene{}}, Error);
}

// Gong et al. 2008, Eq. 7 and 9.
TEST(IrradianceTest, LightsEnterByFresnelAndCosine) {
  auto scene = sceneOfBodies({bodyOf(sheet({0, 0, 0}, {50, 0, 0}, {0, 50, 0}, 1)),
                              bodyOf(sheet({30, 0, 5}, {3, 0, 0}, {0, 3, 0}, 1), skin())});
  scene.lighting.directional = {{{0, 3, 4}, {1, 2, 3}}, {{0, 0, -1}, {9, 9, 9}}};
  scene.lighting.points = {{{0, 0, 10}, {50, 0, 0}}};
  scene.lighting.ambient = {0, 0, 0.5F};
  const Geometry geometry(scene);
  const Irradiance irradiance(geometry);
  const double eta = scene.bodies[0].medium.eta;
  reference::SurfacePoint point = geometry.pointOn(0, 0, {1, 0, 0});
  point.position = {7, -3, 0};
  const double sun = 0.8 * fresnelTransmittance(eta, 0.8);
  const double squared = 49 + 9 + 100;
  const double cosine = 10 / std::sqrt(squared);
  const double lamp = cosine * fresnelTransmittance(eta, cosine) * 50 / squared;
  // Walsh's mean transmittance of η = 1.5, physics tables: .9082.
  const reference::Colour found = irradiance(point);
  EXPECT_NEAR(found[0], sun + lamp, 1e-7);
  EXPECT_NEAR(found[1], 2 * sun, 1e-7);
  EXPECT_NEAR(found[2], 3 * sun + 0.5 * std::numbers::pi * 0.9082, 1e-4);
  // In the shadow of the small sheet only the lamp shines.
  point.position = {30, -15. / 4, 0};
  const double farther = 900 + 225. / 16 + 100;
  const double flatter = 10 / std::sqrt(farther);
  EXPECT_NEAR(irradiance(point)[0], flatter * fresnelTransmittance(eta, flatter) * 50 / farther,
              1e-7);
}

}  // namespace
}  // namespace opaline
