#pragma once

#include <array>
#include <vector>

#include "reference/geometry.h"
#include "reference/scene.h"

namespace opaline::reference {

/// An absorbing layer on a body, of one channel: its optical thickness all over the surface.
class Layer {
 public:
  /// The same everywhere.
  explicit Layer(double thickness) : thickness_(thickness) {}
  /// Of a body with paint, by which it has the paint's colours in even light. The body must live as
  /// long and stay as it is.
  Layer(const Body& body, int channel);

  double thicknessAt(const SurfacePoint& point) const;

 private:
  double colorAt(const SurfacePoint& point) const;

  double thickness_ = 0;
  const Body* body_ = nullptr;
  std::size_t channel_ = 0;
  double bare_ = 1;            // colour without a layer
  std::vector<double> table_;  // thicknesses for the squares of 0 to 1 times that
};

}  // namespace opaline::reference
