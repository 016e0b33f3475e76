#pragma once

#include <cstdint>
#include <vector>

#include "reference/geometry.h"
#include "reference/gloss.h"
#include "reference/path/light_samples.h"
#include "reference/path/path_tracer.h"
#include "reference/path/random.h"
#include "reference/path/reflection.h"
#include "reference/picture.h"

namespace opaline::reference {

/// Light from opaque surfaces, and light that media mirror, by paths from the eye. At each point of
/// a path every light is sampled and one direction is followed. Where a path hits a medium, the
/// light leaving it is what particles have counted.
class EyePaths {
 public:
  /// All arguments must outlive it.
  EyePaths(const Geometry& geometry, const PathTracer& tracer, const EyePathOptions& options);

  /// The radiance of a point, by one path.
  Colour radiance(const SurfacePoint& point, const Vector& toEye, Random& random) const;
  /// The diffuse light that leaves an opaque body at a point, on the side of the eye.
  Colour exitance(const SurfacePoint& point, const Vector& toEye, Random& random) const;

 private:
  /// A point that a path has reached.
  struct Vertex {
    SurfacePoint point;
    Reflection reflection;
    Colour own{};          ///< radiance that it emits
    double occlusion = 1;  ///< factor on light that does not come straight from a light
    bool ends = false;     ///< light that arrives does not matter
  };
  Vertex opaqueVertex(const SurfacePoint& point, const OpaqueSurface& surface,
                      const Colour& emission, const Vector& toEye) const;
  Vertex vertexAt(const SurfacePoint& point, const Vector& toEye, bool first) const;
  Colour follow(Vertex vertex, Random& random) const;
  Colour lightAt(const Vertex& vertex, Random& random) const;
  /// Radiance per exitance of a medium, towards an eye at that cosine.
  double leaving(std::uint32_t body, double alpha, double cosine) const;

  const Geometry& geometry_;
  const PathTracer& tracer_;
  EyePathOptions options_;
  LightSamples lights_;
  std::vector<double> exitFactors_;
  std::vector<const MirroredShare*> mirrored_;  ///< of bodies; null for opaque ones
};

}  // namespace opaline::reference
