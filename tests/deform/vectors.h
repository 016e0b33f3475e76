#pragma once

#include <gtest/gtest.h>

#include <cstddef>

#include "scene/vector_math.h"

namespace opaline::deform {

constexpr float root = 0.70710678F;  ///< of ½

inline void expectVector(const scene::Double3& actual, const scene::Double3& expected,
                         double tolerance = 1e-6) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(actual[axis], expected[axis], tolerance) << "axis " << axis;
  }
}

}  // namespace opaline::deform
