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

/// Light of opaque surfaces and of what media mirror, by paths from the eye: at each point that a
/// path meets every light is sampled, and one direction is followed. Where a path meets a medium,
/// what leaves there is what particles have counted.
class EyePaths {
 public:
  /// All must live as long.
  EyePaths(const Geometry& geometry, const PathTracer& tracer, const EyePathOptions& options);

  /// Radiance of a point, by one path.
  Colour radiance(const SurfacePoint& point, const Vector& toEye, Random& random) const;
  /// What leaves an opaque body there diffusely, on the side of the eye.
  Colour exitance(const SurfacePoint& point, const Vector& toEye, Random& random) const;

 private:
  /// A point that a path has met.
  struct Vertex {
    SurfacePoint point;
    Reflection reflection;
    Colour own{};          ///< radiance that it sends by itself
    double occlusion = 1;  ///< share of light that does not come straight from a light
    bool ends = false;     ///< no light that arrives matters
  };
  Vertex vertexAt(const SurfacePoint& point, const Vector& toEye, bool first) const;
  Colour follow(Vertex vertex, Random& random) const;
  Colour lightAt(const Vertex& vertex, Random& random) const;
  /// Radiance per exitance of a medium, towards an eye at that cosine to its surface.
  double leaving(std::uint32_t body, double alpha, double cosine) const;

  const Geometry& geometry_;
  const PathTracer& tracer_;
  EyePathOptions options_;
  LightSamples lights_;
  std::vector<double> exitFactors_;
  std::vector<const MirroredShare*> mirrored_;  ///< of bodies; none of opaque ones
};

}  // namespace opaline::reference
