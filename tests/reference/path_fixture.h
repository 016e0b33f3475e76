#pragma once

#include "reference/bodies.h"

namespace opaline::reference {

/// A body of one colour; coefficients are per mm.
inline Body bodyOf(const Mesh& mesh, double sigmaS, double sigmaA, double eta) {
  return test::bodyOf(mesh, {"test", {sigmaS, sigmaS, sigmaS}, {sigmaA, sigmaA, sigmaA}, eta});
}

/// A scene without light, seen from afar.
inline Scene sceneOf(const Body& body) {
  Scene scene = test::sceneOfBodies({body});
  scene.camera.positionMm = {0, 0, 1000};
  return scene;
}

}  // namespace opaline::reference
