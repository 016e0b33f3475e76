#pragma once

#include <algorithm>
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

/// What one channel of a body does to light inside. Opaque bodies have none.
struct Interior {
  double sigmaTPerMm = 0;  ///< extinction
  double albedo = 0;       ///< σ_s / σ_t
  double g = 0;            ///< mean cosine, Henyey and Greenstein 1941
  double eta = 1;
  std::shared_ptr<const Layer> layer{};  ///< on its surface; null without
};

/// Light on its way through space outside all bodies.
struct Flight {
  Vector origin{};
  Vector direction{};                  ///< unit
  std::optional<SurfacePoint> from{};  ///< if it starts on a surface
  /// What is met first beyond that is left to other particles.
  double reachMm = std::numeric_limits<double>::infinity();
};

/// A particle that leaves a body.
struct Leaving {
  const SurfacePoint& point;
  Order order;
  Vector direction;  ///< unit, outside
};

/// How the way of a particle ended.
enum class End {
  Away,      ///< left the scene
  Absorbed,  ///< in a body
  Dropped,   ///< after as many bounces as are wanted
  Lost,      ///< through a gap of the surface, or trapped
};

/// Follows single particles through bodies with smooth dielectric boundaries: exact Fresnel terms
/// from both sides, decided by chance, so that every particle keeps its weight; free flights,
/// absorption and scattering likewise. Boundaries are the triangles themselves; light enters
/// them by the normals that a texture tells.
class Walk {
 public:
  /// `interiors` of one channel, one a body. `bounces`: how often light that has left a body, or
  /// was reflected by one, may meet a body again.
  Walk(const Geometry& geometry, const DistanceBound& bound, const std::vector<Interior>& interiors,
       int bounces, std::size_t channel = 0)
      : geometry_(geometry),
        bound_(bound),
        interiors_(interiors),
        densest_(densestOf(geometry.scene(), interiors)),
        bounces_(bounces),
        channel_(channel) {}

  /// Calls `leave(Leaving)` for every time the particle leaves a body.
  template <typename Leave>
  End follow(const Flight& flight, Random& random, const Leave& leave) const;

 private:
  /// Where a particle goes on from.
  struct Particle {
    Vector position{};
    Vector direction{};
    SurfacePoint surface;  ///< that it comes from
    bool fromSurface = false;
    int met = 0;                                               ///< bodies
    double reachMm = std::numeric_limits<double>::infinity();  ///< until the first is met
    bool inside = false;                                       ///< of that surface's body
  };

  /// One particle, until it ends or becomes several.
  template <typename Leave>
  End followOne(Particle particle, Random& random, const Leave& leave,
                std::vector<Particle>& others) const;
  /// Of light that an opaque surface is met by, what goes on.
  void reflect(const Particle& particle, Random& random, std::vector<Particle>& others) const;
  /// The same where a medium has a normal texture: of what falls on the tilted surface, the parts
  /// that enter and that are mirrored.
  void meetTilted(const Particle& particle, Random& random, std::vector<Particle>& others) const;
  /// Of light inside a body that meets an opaque surface, which counts as matt there.
  bool reflectMatt(Particle& particle, Random& random) const;

  enum class Inside { Left, Absorbed, Lost };
  template <typename Leave>
  Inside passThrough(Particle& particle, Random& random, const Leave& leave) const;

  /// What a place in a body of several media is of: the medium of the nearest surface.
  const Interior& interiorAt(std::uint32_t body, const Vector& place) const {
    return interiors_[geometry_.nearestPart(body, place)];
  }

  /// For each body the extinction of the densest of these media, 0 where there is only one.
  static std::vector<double> densestOf(const Scene& scene, const std::vector<Interior>& interiors);

  /// Whether a particle gets through the layer at a point, with that cosine inside.
  static bool passes(const Interior& interior, const SurfacePoint& point, double cosine,
                     Random& random) {
    return !interior.layer ||
           random() < std::exp(-interior.layer->thicknessAt(point) / std::max(cosine, 1e-9));
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

/// Mirrored at a plane.
Vector mirrored(const Vector& direction, const Vector& normal);
/// Into a medium of relative index `eta`, `normal` against the direction. Snell 1621; there must be
/// a refracted direction.
Vector refracted(const Vector& direction, const Vector& normal, double eta);
/// A new direction by the phase function.
Vector scattered(const Vector& direction, double g, Random& random);
// ---- implementation

/// More scatterings than any medium needs; a body that neither absorbs nor lets light out of some
/// directions would keep it for ever.
inline constexpr std::uint64_t mostEvents = 50'000'000;

template <typename Leave>
Walk::Inside Walk::passThrough(Particle& particle, Random& random, const Leave& leave) const {
  const Scene& scene = geometry_.scene();
  const std::uint32_t body = particle.surface.body;
  // Where it is of several media, particles meet the densest, and less often the others (Woodcock
  // et al. 1965).
  const double densest = densest_[body];
  const double sigmaT = densest > 0 ? densest : interiors_[body].sigmaTPerMm;
  int scatterings = 0;
  int depth = 1;  // parts of the body around the particle
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
        // Another body has no boundary of ours, and where parts of one overlap, the outermost has.
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

template <typename Leave>
End Walk::followOne(Particle particle, Random& random, const Leave& leave,
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

template <typename Leave>
End Walk::follow(const Flight& flight, Random& random, const Leave& leave) const {
  Particle first{flight.origin, flight.direction, {}, false, 0, flight.reachMm};
  if (flight.from) {
    first.surface = *flight.from;
    first.fromSurface = true;
  }
  std::vector<Particle> others;
  End end = followOne(first, random, leave, others);
  while (!others.empty()) {
    const Particle particle = others.back();
    others.pop_back();
    const End its = followOne(particle, random, leave, others);
    if (end != End::Lost) end = its;
  }
  return end;
}

}  // namespace opaline::reference
