#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>

#include "reference/scene.h"
#include "reference/vector.h"

namespace opaline::reference {

/// A point of the surface.
struct SurfacePoint {
  Vector position{};
  Vector facetNormal{};    ///< unit, of the triangle, on the side of its counter-clockwise corners
  Vector shadingNormal{};  ///< unit, interpolated
  std::uint32_t body = 0;
  std::uint32_t triangle = 0;
  std::array<double, 3> weights{};  ///< of the triangle's corners, sum 1
};

/// The surfaces of a scene: points on them and exact rays between them. All functions are
/// thread-safe. The scene must live as long and must not change.
class Geometry {
 public:
  explicit Geometry(const Scene& scene);
  ~Geometry();
  Geometry(const Geometry&) = delete;
  Geometry& operator=(const Geometry&) = delete;

  const Scene& scene() const { return scene_; }
  const Box& box() const { return box_; }

  /// The point with these weights of the triangle's corners.
  SurfacePoint pointOn(std::uint32_t body, std::uint32_t triangle,
                       const std::array<double, 3>& weights) const;

  struct Hit {
    SurfacePoint point;
    double distanceMm = 0;
  };
  /// The first surface from a point in space. Embree finds the triangle in single precision; the
  /// point on it is then computed in double.
  std::optional<Hit> closestHit(const Vector& origin, const Vector& direction) const;

  /// The same from a point of the surface, on the side to which the direction leads. The point's
  /// own triangle is ignored.
  std::optional<Hit> closestHit(const SurfacePoint& from, const Vector& direction) const;

  /// Whether something lies between a point of the surface and a place that far away in a unit
  /// direction. Rays start on the side of the facet to which the direction leads.
  bool occluded(const SurfacePoint& from, const Vector& direction,
                double distanceMm = std::numeric_limits<double>::infinity()) const;

  /// The part of this body, among the bodies that form one whole with it, whose surface is nearest
  /// to a place inside.
  std::uint32_t nearestPart(std::uint32_t body, const Vector& place) const;

  /// How far from the surface rays start, mm: a few units in the last place of the single-precision
  /// coordinates. Nothing thinner or nearer can cast a shadow.
  double offsetMm() const { return offsetMm_; }

 private:
  struct Device;

  Vector startOf(const SurfacePoint& from, const Vector& direction) const;
  /// The first surface, ignoring one triangle.
  std::optional<Hit> closestBut(std::uint32_t body, std::uint32_t triangle, const Vector& origin,
                                const Vector& direction) const;

  const Scene& scene_;
  Box box_;
  double offsetMm_;
  std::unique_ptr<Device> device_;
};

}  // namespace opaline::reference
