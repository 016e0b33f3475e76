#pragma once

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "deform/deformed_vertices.h"
#include "opaline/scene.h"
#include "reference/scene.h"
#include "renderer/shapes.h"

namespace opaline::test {

inline reference::Body bodyOf(const Mesh& mesh, const Medium& medium = marble()) {
  reference::Body body;
  for (const Vec3& p : mesh.positionsMm) body.positionsMm.push_back(toVector(p));
  for (const Vec3& n : mesh.normals) body.normals.push_back(toVector(n));
  body.triangles = mesh.triangles;
  body.medium = medium;
  return body;
}

/// The bodies of a scene as they are at rest.
inline reference::Scene referenceOf(const Scene& scene) {
  reference::Scene result;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    deform::DeformedVertices mesh = deform::deformedVertices(scene, i, -1, 0);
    result.bodies.push_back({std::move(mesh.positionsMm), std::move(mesh.normals),
                             scene.objects[i].mesh.triangles, scene.objects[i].medium});
  }
  result.lighting = scene.lighting;
  result.camera = scene.camera;
  return result;
}

/// A scene without light, seen from +z.
inline reference::Scene sceneOfBodies(std::vector<reference::Body> bodies) {
  reference::Scene scene;
  scene.bodies = std::move(bodies);
  scene.camera.positionMm = {0, 0, 40};
  return scene;
}

// The following is written again from the papers, so that it shares nothing with the code.

/// Fresnel 1823, from outside.
inline double fresnelTransmittance(double eta, double cosine) {
  const double inside = std::sqrt(1 - (1 - cosine * cosine) / (eta * eta));
  const double s = (cosine - eta * inside) / (cosine + eta * inside);
  const double p = (inside - eta * cosine) / (inside + eta * cosine);
  return 1 - 0.5 * (s * s + p * p);
}

/// Jensen et al. 2001, Eq. 4, for one channel of a medium.
struct DipoleByTheBook {
  double albedo;
  double sigmaTr;
  double zReal;
  double zVirtual;

  DipoleByTheBook(const Medium& medium, std::size_t channel) {
    const double a = medium.sigmaAPerMm[channel];
    const double s = medium.sigmaSPrimePerMm[channel];
    const double eta = medium.eta;
    const double internal = -1.440 / (eta * eta) + 0.710 / eta + 0.668 + 0.0636 * eta;
    albedo = s / (a + s);
    sigmaTr = std::sqrt(3 * a * (a + s));
    zReal = 1 / (a + s);
    zVirtual = zReal * (1 + 4. / 3 * (1 + internal) / (1 - internal));
  }

  double operator()(double r) const {
    double sum = 0;
    for (const double z : {zReal, zVirtual}) {
      const double d = std::sqrt(r * r + z * z);
      sum += z * (1 + sigmaTr * d) * std::exp(-sigmaTr * d) / (d * d * d);
    }
    return albedo / (4 * std::numbers::pi) * sum;
  }

  /// The integral over a disc of that radius.
  double disc(double radius) const {
    double sum = 0;
    for (const double z : {zReal, zVirtual}) {
      const double d = std::sqrt(radius * radius + z * z);
      sum += std::exp(-sigmaTr * z) - z * std::exp(-sigmaTr * d) / d;
    }
    return albedo / 2 * sum;
  }
};

}  // namespace opaline::test
