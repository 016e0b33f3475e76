#include "scene/repair/orientation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/disjoint_sets.h"
#include "scene/repair/topology.h"
#include "scene/vector_math.h"

namespace opaline::scene {

namespace {

constexpr std::uint32_t noComponent = 0xFFFFFFFFU;

/// Groups of triangles that are connected through edges with exactly two sides.
struct Patches {
  std::vector<std::uint32_t> component;  ///< per triangle
  std::vector<bool> against;             ///< per triangle: disagrees with the component's first
  std::size_t count = 0;
};

struct Neighbour {
  std::uint32_t triangle = noComponent;
  bool agrees = true;
};

std::vector<std::array<Neighbour, 3>> neighboursOf(std::span<const HalfEdge> edges,
                                                   std::size_t triangles) {
  std::vector<std::array<Neighbour, 3>> neighbours(triangles);
  forEachEdge(edges, [&](std::span<const HalfEdge> edge) {
    if (edge.size() != 2) return;
    const bool agrees = edge[0].forward != edge[1].forward;
    neighbours[edge[0].triangle][edge[0].corner] = {edge[1].triangle, agrees};
    neighbours[edge[1].triangle][edge[1].corner] = {edge[0].triangle, agrees};
  });
  return neighbours;
}

Patches findPatches(std::span<const HalfEdge> edges, std::size_t triangles) {
  const auto neighbours = neighboursOf(edges, triangles);
  Patches patches;
  patches.component.assign(triangles, noComponent);
  patches.against.assign(triangles, false);
  std::vector<std::uint32_t> open;
  for (std::uint32_t seed = 0; seed < triangles; ++seed) {
    if (patches.component[seed] != noComponent) continue;
    const auto name = static_cast<std::uint32_t>(patches.count++);
    patches.component[seed] = name;
    open.push_back(seed);
    while (!open.empty()) {
      const std::uint32_t t = open.back();
      open.pop_back();
      for (const Neighbour& next : neighbours[t]) {
        if (next.triangle == noComponent) continue;
        if (patches.component[next.triangle] != noComponent) continue;
        patches.component[next.triangle] = name;
        patches.against[next.triangle] = patches.against[t] == next.agrees;
        open.push_back(next.triangle);
      }
    }
  }
  return patches;
}

/// Measures of one component, oriented like its first triangle.
struct Measures {
  std::size_t triangles = 0;
  std::size_t against = 0;
  double area = 0;
  double fanArea = 0;  ///< of the fans over its open edges
  double volume = 0;   ///< with the fans closing the component
  Double3 low{INFINITY, INFINITY, INFINITY};
  Double3 high{-INFINITY, -INFINITY, -INFINITY};
  std::size_t firstTriangle = 0;
};

Double3 cornerOf(const RawMesh& mesh, const Triangle& triangle, std::size_t corner) {
  return toDouble(mesh.positions[triangle[corner]]);
}

/// Closes each open loop of a component by a fan, and adds the fans to its measures.
void addFans(const RawMesh& mesh, std::span<const Triangle> surface,
             std::span<const HalfEdge> edges, const Patches& patches,
             std::vector<Measures>& measures) {
  struct Side {
    std::uint32_t from, to, component, loop;
  };
  std::vector<Side> sides;
  core::DisjointSets loops(mesh.positions.size());
  forEachEdge(edges, [&](std::span<const HalfEdge> edge) {
    if (edge.size() == 2) return;
    for (const HalfEdge& half : edge) {
      const Triangle& t = surface[half.triangle];
      Side side{t[half.corner], t[(half.corner + 1U) % 3U], patches.component[half.triangle], 0};
      if (patches.against[half.triangle]) std::swap(side.from, side.to);
      loops.join(side.from, side.to);
      sides.push_back(side);
    }
  });
  for (Side& side : sides) side.loop = loops.find(side.from);
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return a.component != b.component ? a.component < b.component : a.loop < b.loop;
  });
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    Double3 centre{};
    for (end = begin; end < sides.size() && sides[end].component == sides[begin].component &&
                      sides[end].loop == sides[begin].loop;
         ++end) {
      centre = centre + toDouble(mesh.positions[sides[end].from]);
    }
    centre = (1.0 / static_cast<double>(end - begin)) * centre;
    Measures& of = measures[sides[begin].component];
    for (std::size_t i = begin; i < end; ++i) {
      const Double3 from = toDouble(mesh.positions[sides[i].from]);
      const Double3 to = toDouble(mesh.positions[sides[i].to]);
      const Double3 origin = cornerOf(mesh, surface[of.firstTriangle], 0);
      of.fanArea += 0.5 * length(areaVector(centre, to, from));
      of.volume += dot(centre - origin, cross(to - origin, from - origin)) / 6.0;
    }
  }
}

std::vector<Measures> measure(const RawMesh& mesh, std::span<const Triangle> surface,
                              std::span<const HalfEdge> edges, const Patches& patches) {
  std::vector<Measures> measures(patches.count);
  for (std::size_t t = 0; t < surface.size(); ++t) {
    Measures& of = measures[patches.component[t]];
    if (of.triangles == 0) of.firstTriangle = t;
    ++of.triangles;
    of.against += patches.against[t] ? 1U : 0U;
    const Double3 origin = cornerOf(mesh, surface[of.firstTriangle], 0);
    const std::array<Double3, 3> corner{cornerOf(mesh, surface[t], 0),
                                        cornerOf(mesh, surface[t], 1),
                                        cornerOf(mesh, surface[t], 2)};
    of.area += 0.5 * length(areaVector(corner[0], corner[1], corner[2]));
    const double tetrahedron =
        dot(corner[0] - origin, cross(corner[1] - origin, corner[2] - origin)) / 6.0;
    of.volume += patches.against[t] ? -tetrahedron : tetrahedron;
    for (const Double3& p : corner) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        of.low[axis] = std::min(of.low[axis], p[axis]);
        of.high[axis] = std::max(of.high[axis], p[axis]);
      }
    }
  }
  addFans(mesh, surface, edges, patches, measures);
  return measures;
}

/// +1 faces outwards, -1 inwards, 0 cannot be told.
int verdict(const Measures& m) {
  const double total = m.area + m.fanArea;
  // A sphere has volume / area^1.5 = 0.094.
  const double fullness = m.volume / std::pow(total, 1.5);
  if (m.fanArea == 0) return std::abs(fullness) < 1e-9 ? 0 : (fullness > 0 ? 1 : -1);
  // The fan over a flat sheet makes up half of the area, that over a half sphere a third.
  if (m.fanArea > 0.4 * total || std::abs(fullness) < 0.003) return 0;
  return fullness > 0 ? 1 : -1;
}

/// Whether `p` lies inside the closed component: counts crossings of a ray along +x by the sign of
/// areas in the yz-plane. They are half-open and both triangles of an edge cut it in the same turn,
/// so that it counts once even where rounding decides on which side it passes.
bool isInside(const Double3& p, const RawMesh& mesh, std::span<const Triangle> surface,
              const Patches& patches, std::uint32_t component) {
  bool inside = false;
  for (std::size_t t = 0; t < surface.size(); ++t) {
    if (patches.component[t] != component) continue;
    // First where the outline meets the line y = 0, then where z = 0 lies between those two places.
    std::array<Double3, 2> cut{};
    int cuts = 0;
    for (std::size_t i = 0; i < 3 && cuts < 2; ++i) {
      const auto [first, second] = std::minmax(surface[t][i], surface[t][(i + 1) % 3]);
      const Double3 a = toDouble(mesh.positions[first]) - p;
      const Double3 b = toDouble(mesh.positions[second]) - p;
      if ((a[1] > 0) == (b[1] > 0)) continue;
      const double s = a[1] / (a[1] - b[1]);
      cut[static_cast<std::size_t>(cuts++)] = a + s * (b - a);
    }
    if (cuts < 2 || (cut[0][2] > 0) == (cut[1][2] > 0)) continue;
    const double s = cut[0][2] / (cut[0][2] - cut[1][2]);
    if (cut[0][0] + s * (cut[1][0] - cut[0][0]) > 0) inside = !inside;
  }
  return inside;
}

/// Each test for a cavity visits the whole mesh. Beyond this many steps no more cavities are looked
/// for, so that a mesh of countless crumbs does not take quadratic time.
constexpr std::size_t cavityBudget = 200'000'000;

/// A closed component is a cavity if it faces inwards and lies in an odd number of others.
bool isCavity(std::uint32_t inner, const RawMesh& mesh, std::span<const Triangle> surface,
              const Patches& patches, const std::vector<Measures>& measures, std::size_t& steps) {
  steps += measures.size();
  // Not a corner, with which a cavity may touch the surface around it.
  const Triangle& t = surface[measures[inner].firstTriangle];
  const Double3 p =
      (1.0 / 3.0) * (cornerOf(mesh, t, 0) + cornerOf(mesh, t, 1) + cornerOf(mesh, t, 2));
  std::size_t around = 0;
  for (std::uint32_t outer = 0; outer < measures.size(); ++outer) {
    const Measures& m = measures[outer];
    if (outer == inner || m.fanArea != 0) continue;
    bool boxed = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      boxed = boxed && m.low[axis] < p[axis] && p[axis] < m.high[axis];
    }
    if (!boxed) continue;
    steps += surface.size();
    if (steps > cavityBudget) return false;
    around += isInside(p, mesh, surface, patches, outer) ? 1U : 0U;
  }
  return around % 2 == 1;
}

/// Per component whether its first triangle must be turned.
std::vector<bool> decide(const RawMesh& mesh, std::span<const Triangle> surface,
                         const Patches& patches, const std::vector<Measures>& measures) {
  std::vector<bool> turn(measures.size());
  std::vector<bool> told(measures.size());
  std::size_t steps = 0;
  bool anyOutward = false;
  bool anyInward = false;
  for (std::uint32_t i = 0; i < measures.size(); ++i) {
    const Measures& m = measures[i];
    const bool majority = 2 * m.against > m.triangles;
    turn[i] = majority;
    const int looks = verdict(m);
    if (looks == 0) continue;
    told[i] = true;
    turn[i] = looks < 0;
    const bool wholeInward = turn[i] != majority;
    if (wholeInward && m.fanArea == 0 && steps < cavityBudget &&
        isCavity(i, mesh, surface, patches, measures, steps)) {
      turn[i] = majority;
      continue;
    }
    (wholeInward ? anyInward : anyOutward) = true;
  }
  // The turn of a lid cannot be told by itself; the lid was turned like the pot on which it lies.
  if (anyInward && !anyOutward) {
    for (std::size_t i = 0; i < turn.size(); ++i) {
      if (!told[i]) turn[i] = !turn[i];
    }
  }
  return turn;
}

}  // namespace

OrientationResult orientOutward(RawMesh& mesh, std::span<const std::uint32_t> points) {
  const std::vector<Triangle> surface = renamed(mesh.triangles, points);
  const std::vector<HalfEdge> edges = sortedHalfEdges(surface);
  const Patches patches = findPatches(edges, surface.size());
  const std::vector<Measures> measures = measure(mesh, surface, edges, patches);
  const std::vector<bool> turnFirst = decide(mesh, surface, patches, measures);

  OrientationResult result;
  result.turned.resize(surface.size());
  std::vector<std::size_t> turnedOf(patches.count);
  for (std::size_t t = 0; t < surface.size(); ++t) {
    const std::uint32_t component = patches.component[t];
    if (patches.against[t] == turnFirst[component]) continue;
    result.turned[t] = true;
    ++turnedOf[component];
    std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
  }
  for (std::size_t i = 0; i < patches.count; ++i) {
    (turnedOf[i] == measures[i].triangles ? result.inward : result.inconsistent) += turnedOf[i];
  }
  return result;
}

}  // namespace opaline::scene
