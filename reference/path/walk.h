#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "bssrdf/fresnel.h"
#include "reference/geometry.h"
#include "reference/own_surface.h"
#include "reference/path/distance_bound.h"
#include "reference/path/layer.h"
#include "reference/path/random.h"

namespace opaline::reference {

/// How often light scattered since it last entered a body.
enum class Order { Unscattered, Single, Multiple };

/// How one channel of a body affects light inside. Opaque bodies have none.
struct Interior {
  double sigmaTPerMm = 0;  ///< extinction
  double albedo = 0;       ///< σ_s / σ_t
  double g = 0;            ///< mean cosine, Henyey and Greenstein 1941
  double eta = 1;
  std::shared_ptr<const Layer> layer{};  ///< on its surface; null if there is none

  /// The share of light that passes the layer at a point, at that cosine inside.
  double passing(const SurfacePoint& point, double cosine) const {
    return layer ? std::exp(-layer->thicknessAt(point) / std::max(cosine, 1e-9)) : 1;
  }
};

using InteriorsByChannel = std::array<std::vector<Interior>, 3>;

/// One for each body.
std::vector<Interior> interiorsOf(const Scene& scene, std::size_t channel);
/// For each body the extinction of its densest medium; 0 where it has only one.
std::vector<double> densestOf(const Scene& scene, const std::vector<Interior>& interiors);

/// Light on its way through space outside all bodies.
struct Flight {
  Vector origin{};
  Vector direction{};                  ///< unit
  std::optional<SurfacePoint> from{};  ///< if it starts on a surface
  /// Hits beyond this distance are left to other particles.
  double reachMm = std::numeric_limits<double>::infinity();
};

/// A particle that leaves a body.
struct Leaving {
  const SurfacePoint& point;
  Order order;
  Vector direction;  ///< unit, outside
};

/// A particle that went through a body without being scattered, and arrives at an opaque one. No
/// path from the eye finds its light.
struct Arriving {
  const SurfacePoint& point;
  Vector direction;  ///< unit
};

/// How a particle's walk ended.
enum class End {
  Away,      ///< left the scene
  Absorbed,  ///< in a body
  Dropped,   ///< after the wanted number of bounces
  Lost,      ///< through a gap of the surface, or trapped
};

/// Follows single particles through bodies with smooth dielectric boundaries. Exact Fresnel terms
/// from both sides are decided at random, so that every particle keeps its weight. The same holds
/// for free flights, absorption and scattering. Boundaries are the triangles themselves; light
/// enters by the normals of a texture.
class Walk {
 public:
  /// `interiors` has one entry per body, for one channel. `bounces` is how often light that left a
  /// body, or was reflected by one, may hit a body again.
  Walk(const Geometry& geometry, const DistanceBound& bound, const std::vector<Interior>& interiors,
       int bounces, std::size_t channel = 0)
      : geometry_(geometry),
        bound_(bound),
        interiors_(interiors),
        densest_(densestOf(geometry.scene(), interiors)),
        bounces_(bounces),
        channel_(channel) {}

  /// Calls `leave(Leaving)` for every time the particle leaves a body, and `arrive(Arriving)`.
  template <typename Leave, typename Arrive>
  End follow(const Flight& flight, Random& random, const Leave& leave, const Arrive& arrive) const;
  template <typename Leave>
  End follow(const Flight& flight, Random& random, const Leave& leave) const {
    return follow(flight, random, leave, [](const Arriving&) {});
  }

 private:
  /// The state from which a particle continues.
  struct Particle {
    Vector position{};
    Vector direction{};
    SurfacePoint surface;  ///< where it comes from
    bool fromSurface = false;
    int met = 0;                                               ///< bodies hit so far
    double reachMm = std::numeric_limits<double>::infinity();  ///< for the first hit
    bool inside = false;                                       ///< in that surface's body
    bool straightThrough = false;  ///< went through the last body unscattered
  };

  /// Follows one particle until it ends or becomes several.
  template <typename Leave, typename Arrive>
  End followOne(Particle particle, Random& random, const Leave& leave, const Arrive& arrive,
                std::vector<Particle>& others) const;
  /// Continues light that hits an opaque surface.
  void reflect(const Particle& particle, Random& random, std::vector<Particle>& others) const;
  /// The same for a medium with a normal texture: the tilted surface receives the light, part of
  /// which enters and part of which is mirrored.
  void meetTilted(const Particle& particle, Random& random, std::vector<Particle>& others) const;
  /// Reflects light inside a body at an opaque surface, which counts as matt there.
  bool reflectMatt(Particle& particle, Random& random) const;

  enum class Inside { Left, Absorbed, Lost };
  template <typename Leave>
  Inside passThrough(Particle& particle, Random& random, const Leave& leave) const;

  /// The interior at a place in a body of several media: that of the nearest surface.
  const Interior& interiorAt(std::uint32_t body, const Vector& place) const {
    return interiors_[geometry_.nearestPart(body, place)];
  }

  /// Whether a particle passes the layer at a point, at that cosine inside.
  static bool passes(const Interior& interior, const SurfacePoint& point, double cosine,
                     Random& random) {
    return !interior.layer || random() < interior.passing(point, cosine);
  }

  std::optional<Geometry::Hit> next(const Particle& particle) const {
    return particle.fromSurface ? geometry_.closestHit(particle.surface, particle.direction)
                                : geometry_.closestHit(particle.position, particle.direction);
  }

  const Geometry& geometry_;
  const DistanceBound& bound_;
  const std::vector<Interior>& interiors_;
  std::vector<double> densest_;
  int bounces_;
  std::size_t channel_;
};

/// The direction mirrored at a plane.
Vector mirrored(const Vector& direction, const Vector& normal);
/// The direction refracted into a medium of relative index `eta` (Snell 1621). `normal` must oppose
/// the direction, and there must be a refracted direction.
Vector refracted(const Vector& direction, const Vector& normal, double eta);
/// The direction of light that enters through a facet by the normal of a texture, if it can.
Vector refractedInto(const Vector& facet, const Vector& direction, const Vector& normal,
                     double eta);
/// Samples a new direction from the phase function.
Vector scattered(const Vector& direction, double g, Random& random);
// ---- implementation

/// More scatterings than any medium needs. A body that neither absorbs light nor lets out light of
/// some directions would keep it for ever.
inline constexpr std::uint64_t mostEvents = 50'000'000;

template <typename Leave>
Walk::Inside Walk::passThrough(Particle& particle, Random& random, const Leave& leave) const {
  const Scene& scene = geometry_.scene();
  const std::uint32_t body = particle.surface.body;
  // In a body of several media, particles collide as in the densest, and some collisions are
  // dropped in the others (Woodcock et al. 1965).
  const double densest = densest_[body];
  const double sigmaT = densest > 0 ? densest : interiors_[body].sigmaTPerMm;
  int scatterings = 0;
  int depth = 1;  // how many nested parts of the body the particle is in
  for (std::uint64_t event = 0; event < mostEvents; ++event) {
    const double step = -std::log(random()) / sigmaT;
    if (!particle.fromSurface && step < bound_(particle.position)) {
      particle.position += step * particle.direction;
    } else {
      const std::optional<Geometry::Hit> hit = next(particle);
      if (!hit) return Inside::Lost;
      if (hit->distanceMm <= step) {
        const double cosine = dot(particle.direction, hit->point.facetNormal);
        particle.surface = hit->point;
        particle.position = hit->point.position;
        particle.fromSurface = true;
        if (scene.bodies[hit->point.body].opaque) {
          if (!reflectMatt(particle, random)) return Inside::Absorbed;
          continue;
        }
        // Another body has no boundary here. Where parts of one body overlap, only the outermost
        // boundary counts.
        if (wholeOf(scene, hit->point.body) != wholeOf(scene, body)) continue;
        const Interior& interior = interiors_[hit->point.body];
        if (cosine <= 0) ++depth;
        if (cosine <= 0 || --depth > 0) continue;
        depth = 1;
        if (!passes(interior, hit->point, cosine, random)) return Inside::Absorbed;
        if (random() < bssrdf::fresnelReflectanceInside(interior.eta, std::min(cosine, 1.0))) {
          particle.direction = mirrored(particle.direction, hit->point.facetNormal);
          if (!passes(interior, hit->point, cosine, random)) return Inside::Absorbed;
          continue;
        }
        particle.direction =
            refracted(particle.direction, -hit->point.facetNormal, 1 / interior.eta);
        particle.straightThrough = scatterings == 0;
        leave(Leaving{hit->point,
                      scatterings == 0   ? Order::Unscattered
                      : scatterings == 1 ? Order::Single
                                         : Order::Multiple,
                      particle.direction});
        return Inside::Left;
      }
      particle.position = particle.fromSurface
                              ? particle.surface.position + step * particle.direction
                              : particle.position + step * particle.direction;
      particle.fromSurface = false;
    }
    const Interior& interior = densest > 0 ? interiorAt(body, particle.position) : interiors_[body];
    if (densest > 0 && random() * densest >= interior.sigmaTPerMm) continue;
    if (random() >= interior.albedo) return Inside::Absorbed;
    ++scatterings;
    particle.direction = scattered(particle.direction, interior.g, random);
  }
  return Inside::Lost;
}

template <typename Leave, typename Arrive>
End Walk::followOne(Particle particle, Random& random, const Leave& leave, const Arrive& arrive,
                    std::vector<Particle>& others) const {
  while (true) {
    if (!particle.inside) {
      const std::optional<Geometry::Hit> hit = next(particle);
      if (!hit || hit->distanceMm > particle.reachMm) return End::Away;
      particle.reachMm = std::numeric_limits<double>::infinity();
      if (particle.met++ > bounces_) return End::Dropped;
      particle.surface = hit->point;
      particle.position = hit->point.position;
      particle.fromSurface = true;
      const Body& body = geometry_.scene().bodies[hit->point.body];
      if (body.opaque) {
        if (particle.straightThrough) arrive(Arriving{hit->point, particle.direction});
        reflect(particle, random, others);
        return End::Absorbed;
      }
      const double cosine = -dot(particle.direction, hit->point.facetNormal);
      if (cosine <= 0) return End::Lost;  // the back of an open surface
      if (normalTextureOf(body)) {
        meetTilted(particle, random, others);
        return End::Absorbed;
      }
      const double eta = interiors_[hit->point.body].eta;
      if (random() < bssrdf::fresnelReflectance(eta, std::min(cosine, 1.0))) {
        particle.direction = mirrored(particle.direction, hit->point.facetNormal);
        continue;
      }
      particle.direction = refracted(particle.direction, hit->point.facetNormal, eta);
    }
    particle.inside = false;
    if (!passes(interiors_[particle.surface.body], particle.surface,
                -dot(particle.direction, particle.surface.facetNormal), random))
      return End::Absorbed;
    const Inside inside = passThrough(particle, random, leave);
    if (inside == Inside::Absorbed) return End::Absorbed;
    if (inside == Inside::Lost) return End::Lost;
  }
}

template <typename Leave, typename Arrive>
End Walk::follow(const Flight& flight, Random& random, const Leave& leave,
                 const Arrive& arrive) const {
  Particle first{flight.origin, flight.direction, {}, false, 0, flight.reachMm};
  if (flight.from) {
    first.surface = *flight.from;
    first.fromSurface = true;
  }
  std::vector<Particle> others;
  End end = followOne(first, random, leave, arrive, others);
  while (!others.empty()) {
    const Particle particle = others.back();
    others.pop_back();
    const End its = followOne(particle, random, leave, arrive, others);
    if (end != End::Lost) end = its;
  }
  return end;
}

}  // namespace opaline::reference
