#pragma once

#include <array>
#include <functional>

#include "opaline/scene.h"

namespace opaline::builtin {

/// A signed distance, negative inside, and its gradient.
struct FieldSample {
  double distance;
  std::array<double, 3> gradient;
};

/// A body as its signed distance. `distance` leaves the gradient out, for the many places away from
/// the surface.
struct Field {
  std::function<double(const std::array<double, 3>&)> distance;
  std::function<FieldSample(const std::array<double, 3>&)> sample;
};

/// Where and how finely a field is turned into triangles.
struct Grid {
  std::array<double, 3> low;
  std::array<double, 3> high;
  double spacing;
};

/// The zero set of a field: one vertex in each cell that the surface crosses, one quadrilateral
/// around each edge that it crosses, two triangles each (Gibson 1998, "Constrained elastic surface
/// nets"), then spread evenly along the surface and projected onto it. The surface must not leave
/// the grid. Normals are the field's gradient.
Mesh polygonise(const Field& field, const Grid& grid);

}  // namespace opaline::builtin
