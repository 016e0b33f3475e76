#pragma once

#include "reference/bodies.h"
#include "reference/scene.h"

namespace opaline::reference {

/// Of one colour; coefficients per mm.
inline Body bodyOf(const Mesh& mesh, double sigmaS, double sigmaA, double eta) {
  Body body;
  for (const Vec3& p : mesh.positionsMm) body.positionsMm.push_back(toVector(p));
  for (const Vec3& n : mesh.normals) body.normals.push_back(toVector(n));
  body.triangles = mesh.triangles;
  body.medium = {"test", {sigmaS, sigmaS, sigmaS}, {sigmaA, sigmaA, sigmaA}, eta};
  return body;
}

inline Scene sceneOf(const Body& body) {
  Scene scene;
  scene.bodies = {body};
  scene.camera.positionMm = {0, 0, 1000};
  return scene;
}

}  // namespace opaline::reference
