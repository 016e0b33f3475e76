#pragma once

#include <array>
#include <vector>

#include "reference/geometry.h"
#include "reference/scene.h"

namespace opaline::reference {

/// The absorbing layer on a body in one channel: its optical thickness all over the surface.
class Layer {
 public:
  /// A layer of the same thickness everywhere.
  explicit Layer(double thickness) : thickness_(thickness) {}
  /// The layer that gives a painted body its paint's colours in even light. The body must live as
  /// long and must not change.
  Layer(const Body& body, int channel);

  double thicknessAt(const SurfacePoint& point) const;

 private:
  double colorAt(const SurfacePoint& point) const;

  double thickness_ = 0;
  const Body* body_ = nullptr;
  std::size_t channel_ = 0;
  double bare_ = 1;            // colour without a layer
  std::vector<double> table_;  // thicknesses for the squares of 0 to 1 times `bare_`
};

}  // namespace opaline::reference
