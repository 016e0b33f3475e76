#include "reference/sky_table.h"

#include <algorithm>
#include <cstddef>

#include "environment/lat_long.h"

namespace opaline::reference {

namespace {

constexpr int rows = 96;  // of cells; nodes have one more
constexpr int columns = 192;

}  // namespace

SkyTable::SkyTable(const SkyIrradiance& irradiance) {
  nodes_.reserve(static_cast<std::size_t>(rows + 1) * columns);
  for (int row = 0; row <= rows; ++row)
    for (int column = 0; column < columns; ++column)
      nodes_.push_back(irradiance.at(latLongDirection(static_cast<double>(column) / columns,
                                                      static_cast<double>(row) / rows)));
}

const Colour& SkyTable::node(int row, int column) const {
  return nodes_[static_cast<std::size_t>(row * columns + column % columns)];
}

Colour SkyTable::at(const Vector& normal) const {
  const auto [u, v] = latLongCoordinates(toFloat(normal));
  const int column = std::clamp(static_cast<int>(u * columns), 0, columns - 1);
  const int row = std::clamp(static_cast<int>(v * rows), 0, rows - 1);
  const double right = u * columns - column;
  const double below = v * rows - row;
  Colour sum{};
  for (std::size_t c = 0; c < 3; ++c)
    sum[c] =
        (1 - below) * ((1 - right) * node(row, column)[c] + right * node(row, column + 1)[c]) +
        below * ((1 - right) * node(row + 1, column)[c] + right * node(row + 1, column + 1)[c]);
  return sum;
}

}  // namespace opaline::reference
