#pragma once

#include <array>
#include <cstddef>

namespace opaline::test {

/// Composite five-point Gauss-Legendre rule.
template <typename Function>
double integrate(Function&& function, double from, double to, int panels) {
  constexpr std::array<double, 3> nodes = {0.0, 0.538469310105683091, 0.906179845938663993};
  constexpr std::array<double, 3> weights = {0.568888888888888889, 0.478628670499366468,
                                             0.236926885056189088};
  const double half = 0.5 * (to - from) / panels;
  double sum = 0;
  for (int i = 0; i < panels; ++i) {
    const double centre = from + half * (2 * i + 1);
    sum += weights[0] * function(centre);
    for (std::size_t k = 1; k < nodes.size(); ++k) {
      sum += weights[k] * (function(centre - half * nodes[k]) + function(centre + half * nodes[k]));
    }
  }
  return sum * half;
}

}  // namespace opaline::test
