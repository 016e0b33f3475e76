#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "reference/geometry.h"
#include "reference/gloss.h"
#include "reference/path/light_samples.h"
#include "reference/path/path_tracer.h"
#include "reference/path/random.h"
#include "reference/path/reflection.h"
#include "reference/path/through_media.h"
#include "reference/picture.h"

namespace opaline::reference {

/// Light from opaque surfaces, and light that media mirror, by paths from the eye. At each point of
/// a path every light is sampled and one direction is followed. Where a path hits a medium, the
/// light that scattered there is what particles have counted. What it lets through without
/// scattering is followed as well.
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
    Vector toEye{};
    Reflection reflection;
    Colour own{};          ///< radiance that it emits
    double occlusion = 1;  ///< factor on light that does not come straight from a light
    bool ends = false;     ///< light that arrives does not matter
    double letsOut = 0;    ///< of the light inside of a medium
  };
  /// How much of the radiance that arrives along a path the eye sees.
  struct Share {
    Colour ofAll{1, 1, 1};
    /// Of light that went through a medium unscattered: opaque surfaces already know from the
    /// particles what they give back of it diffusely.
    Colour ofStraight{1, 1, 1};

    Share& operator*=(double factor) {
      ofAll = factor * ofAll;
      ofStraight = factor * ofStraight;
      return *this;
    }
  };
  /// Where a path goes on.
  struct Step {
    SurfacePoint from;
    Vector direction{};
    double density = 0;    ///< per steradian; 0 for a single direction
    bool arrived = false;  ///< `from` is the next point of the path
  };
  Vertex opaqueVertex(const SurfacePoint& point, const OpaqueSurface& surface,
                      const Colour& emission, const Vector& toEye) const;
  Vertex vertexAt(const SurfacePoint& point, const Vector& toEye, bool first) const;
  Colour follow(Vertex vertex, Random& random) const;
  /// Samples where a path goes on from a point, and what is left there. None if nothing is.
  std::optional<Step> next(const Vertex& vertex, Share& share, Random& random) const;
  std::optional<Step> mirrored(const Vertex& vertex, Share& share, Random& random) const;
  Colour lightAt(const Vertex& vertex, Random& random) const;
  /// The share of the light inside of a medium that is not mirrored back from an eye at that
  /// cosine.
  double letOut(std::uint32_t body, double alpha, double cosine) const;

  const Geometry& geometry_;
  const PathTracer& tracer_;
  EyePathOptions options_;
  LightSamples lights_;
  ThroughMedia throughMedia_;
  std::vector<double> exitFactors_;
  std::vector<const MirroredShare*> mirrored_;  ///< of bodies; null for opaque ones
};

}  // namespace opaline::reference
