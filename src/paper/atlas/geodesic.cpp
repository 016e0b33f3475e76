#include "paper/atlas/geodesic.h"

#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

#include "paper/atlas/topology.h"

namespace opaline::atlas {

namespace {

// No walk crosses more triangles; only degenerate ones could make it longer.
constexpr int maxSteps = 100'000;

Point3 add(const Point3& a, const Point3& b, double factor) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

Point3 unit(const Point3& a) {
  const double size = length(a);
  return size > 0 ? Point3{a[0] / size, a[1] / size, a[2] / size} : Point3{};
}

// The part of a direction that lies in a plane, made as long as it was.
Point3 alongPlane(const Point3& direction, const Point3& normal) {
  return unit(add(direction, normal, -dot(direction, normal)));
}

// Turns a unit vector that is perpendicular to the axis.
Point3 turned(const Point3& direction, const Point3& axis, double angle) {
  const Point3 side = cross(axis, direction);
  return add({std::cos(angle) * direction[0], std::cos(angle) * direction[1],
              std::cos(angle) * direction[2]},
             side, std::sin(angle));
}

// The triangles around every vertex, as one list with a start for each.
struct Fans {
  std::vector<std::uint32_t> start;
  std::vector<std::uint32_t> corners;  // 3 · triangle + corner

  explicit Fans(const Topology& topology) : start(topology.positions.size() + 1, 0) {
    for (std::size_t t = 0; t < topology.triangles.size(); ++t)
      if (!topology.degenerate[t])
        for (const std::uint32_t vertex : topology.triangles[t]) ++start[vertex + 1];
    for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
    corners.resize(start.back());
    std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
    for (std::uint32_t t = 0; t < topology.triangles.size(); ++t)
      if (!topology.degenerate[t])
        for (std::uint32_t i = 0; i < 3; ++i) corners[next[topology.triangles[t][i]]++] = 3 * t + i;
  }

  std::span<const std::uint32_t> around(std::uint32_t vertex) const {
    return std::span(corners).subspan(start[vertex], start[vertex + 1] - start[vertex]);
  }
};

// The place and direction of a walk in a triangle's plane.
struct Walker {
  std::uint32_t triangle = none;
  std::size_t enteredBy = 3;  // the edge, 3 at the start
  Point3 position{};
  Point3 direction{};
  double left = 0;  // mm
};

class Walk {
 public:
  explicit Walk(const Topology& topology) : topology_(topology), fans_(topology) {}

  GeodesicStar star(std::uint32_t vertex, double distanceMm) const {
    GeodesicStar star{};
    Point3 normal{};
    for (const std::uint32_t corner : fans_.around(vertex))
      normal = add(normal, topology_.normals[corner / 3], topology_.areas[corner / 3]);
    normal = unit(normal);
    if (length(normal) == 0) return star;
    const Point3 rise =
        std::abs(normal[1]) < 0.999 ? alongPlane({0, 1, 0}, normal) : alongPlane({0, 0, 1}, normal);
    for (std::size_t i = 0; i < star.size(); ++i) {
      const double angle = (static_cast<double>(i) + 0.5) * std::numbers::pi / 4;
      if (std::optional<Walker> walker = depart(vertex, turned(rise, normal, angle), normal)) {
        walker->left = distanceMm;
        star[i] = arrive(*walker, distanceMm);
      }
    }
    return star;
  }

 private:
  const Point3& corner(std::uint32_t triangle, std::size_t i) const {
    return topology_.positions[topology_.triangles[triangle][i % 3]];
  }

  // Enters the triangle of the fan that lies in the direction. Triangles are told apart as seen
  // along the vertex's normal, because there they meet without gaps.
  std::optional<Walker> depart(std::uint32_t vertex, const Point3& direction,
                               const Point3& vertexNormal) const {
    for (const std::uint32_t fan : fans_.around(vertex)) {
      const std::uint32_t triangle = fan / 3;
      const std::size_t at = fan % 3;
      const Point3& normal = topology_.normals[triangle];
      const Point3 first = subtract(corner(triangle, at + 1), corner(triangle, at));
      const Point3 second = subtract(corner(triangle, at + 2), corner(triangle, at));
      if (dot(cross(first, direction), vertexNormal) < 0 ||
          dot(cross(direction, second), vertexNormal) < 0)
        continue;
      // The walk can leave only by the edge opposite.
      return Walker{triangle, 3, corner(triangle, at), alongPlane(direction, normal), 0};
    }
    return std::nullopt;
  }

  // Distance to an edge along the walk; nothing if it does not lie ahead.
  std::optional<double> distanceTo(const Walker& walker, std::size_t edge) const {
    const Point3& normal = topology_.normals[walker.triangle];
    const Point3& from = corner(walker.triangle, edge);
    const Point3 outward = cross(subtract(corner(walker.triangle, edge + 1), from), normal);
    const double speed = dot(walker.direction, outward);
    if (speed <= 0) return std::nullopt;
    return std::max(0.0, dot(subtract(from, walker.position), outward) / speed);
  }

  SurfacePoint arrive(Walker walker, double distanceMm) const {
    for (int step = 0; step < maxSteps; ++step) {
      std::size_t exit = 3;
      double distance = 0;
      for (std::size_t edge = 0; edge < 3; ++edge) {
        if (edge == walker.enteredBy) continue;
        const std::optional<double> ahead = distanceTo(walker, edge);
        if (ahead && (exit == 3 || *ahead < distance)) {
          exit = edge;
          distance = *ahead;
        }
      }
      if (exit == 3 || distance >= walker.left) return stop(walker, walker.left, distanceMm);
      const std::uint32_t next = topology_.neighbours[walker.triangle][exit];
      if (next == none) return stop(walker, distance, distanceMm - walker.left + distance);
      crossEdge(walker, exit, distance, next);
    }
    return stop(walker, 0, distanceMm - walker.left);
  }

  SurfacePoint stop(const Walker& walker, double ahead, double walkedMm) const {
    const Point3 end = add(walker.position, walker.direction, ahead);
    const Point3& normal = topology_.normals[walker.triangle];
    SurfacePoint point{walker.triangle, {}, static_cast<float>(walkedMm)};
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Point3& a = corner(walker.triangle, i + 1);
      const Point3& b = corner(walker.triangle, i + 2);
      const double weight = std::max(0.0, dot(cross(subtract(a, end), subtract(b, end)), normal));
      point.barycentric[i] = static_cast<float>(weight);
      sum += weight;
    }
    if (!(sum > 0)) return {walker.triangle, {1, 0, 0}, point.walkedMm};
    for (float& weight : point.barycentric) weight = static_cast<float>(weight / sum);
    return point;
  }

  // Unfolds the next triangle into the plane of the walk: the components along the edge and across
  // it stay.
  void crossEdge(Walker& walker, std::size_t edge, double distance, std::uint32_t next) const {
    const Point3 along =
        unit(subtract(corner(walker.triangle, edge + 1), corner(walker.triangle, edge)));
    const Point3 outward = cross(along, topology_.normals[walker.triangle]);
    const Point3 inward = cross(along, topology_.normals[next]);
    const double forward = dot(walker.direction, along);
    const double across = dot(walker.direction, outward);
    walker.position = add(walker.position, walker.direction, distance);
    walker.direction =
        unit(add({forward * along[0], forward * along[1], forward * along[2]}, inward, across));
    walker.left -= distance;
    walker.enteredBy = edgeTo(next, walker.triangle);
    walker.triangle = next;
  }

  std::size_t edgeTo(std::uint32_t from, std::uint32_t to) const {
    for (std::size_t edge = 0; edge < 3; ++edge)
      if (topology_.neighbours[from][edge] == to) return edge;
    assert(false);
    return 3;
  }

  const Topology& topology_;
  Fans fans_;
};

}  // namespace

std::vector<GeodesicStar> walkFromVertices(const core::RestSurface& surface,
                                           std::span<const double> distanceMm) {
  assert(distanceMm.size() == surface.positionsMm.size());
  const Topology topology = makeTopology(surface);
  const Walk walk(topology);
  std::vector<GeodesicStar> stars(surface.positionsMm.size());
  std::vector<bool> walked(topology.positions.size(), false);
  std::vector<GeodesicStar> ofWelded(topology.positions.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t vertex = surface.triangles[t][i];
      const std::uint32_t welded = topology.triangles[t][i];
      if (!walked[welded]) {
        ofWelded[welded] = walk.star(welded, distanceMm[vertex]);
        walked[welded] = true;
      }
      stars[vertex] = ofWelded[welded];
    }
  return stars;
}

}  // namespace opaline::atlas
