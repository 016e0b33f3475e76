#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

namespace opaline::test {

/// Unit directions and the triangles between them, counter-clockwise from outside.
struct Icosphere {
  std::vector<std::array<double, 3>> directions;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

inline void normalise(std::array<double, 3>& v) {
  const double length = std::hypot(v[0], v[1], v[2]);
  for (double& value : v) value /= length;
}

/// Every triangle becomes four, by the middles of its edges.
inline Icosphere halved(const Icosphere& coarse) {
  Icosphere fine{coarse.directions, {}};
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto [found, isNew] =
        middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(fine.directions.size()));
    if (isNew) {
      std::array<double, 3> between{};
      for (std::size_t i = 0; i < 3; ++i)
        between[i] = fine.directions[a][i] + fine.directions[b][i];
      normalise(between);
      fine.directions.push_back(between);
    }
    return found->second;
  };
  for (const auto& [a, b, c] : coarse.triangles) {
    const std::uint32_t ab = middle(a, b);
    const std::uint32_t bc = middle(b, c);
    const std::uint32_t ca = middle(c, a);
    fine.triangles.insert(fine.triangles.end(),
                          {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
  }
  return fine;
}

/// An icosahedron, halved `levels` times: 20·4^levels triangles, 10·4^levels + 2 directions.
inline Icosphere icosphere(int levels) {
  constexpr double g = std::numbers::phi;
  Icosphere made{
      {{-1, g, 0},
       {1, g, 0},
       {-1, -g, 0},
       {1, -g, 0},
       {0, -1, g},
       {0, 1, g},
       {0, -1, -g},
       {0, 1, -g},
       {g, 0, -1},
       {g, 0, 1},
       {-g, 0, -1},
       {-g, 0, 1}},
      {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
       {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
       {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
  for (std::array<double, 3>& direction : made.directions) normalise(direction);
  for (int level = 0; level < levels; ++level) made = halved(made);
  return made;
}

}  // namespace opaline::test
