#include "reference/path/eye_paths.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "reference/own_surface.h"
#include "reference/picture.h"

namespace opaline::reference {

namespace {

using std::numbers::pi;

double largest(const Colour& colour) {
  return std::max({colour[0], colour[1], colour[2]});
}

/// A point's sides as seen by the eye.
struct Sides {
  Vector outside{};  ///< of the facet
  Vector normal{};
};

// A normal that faces away from the eye is turned round.
Sides sidesOf(const Body& body, const SurfacePoint& point, const Vector& toEye) {
  const double side = dot(point.facetNormal, toEye) < 0 ? -1 : 1;
  Vector normal = side * normalAt(body, point, point.shadingNormal);
  constexpr double least = 0.01;
  const double facing = dot(normal, toEye);
  if (facing < least) normal = unitOr(normal + (least - facing) * toEye, toEye);
  return {side * point.facetNormal, normal};
}

// The weight of light that two strategies might have found (Veach and Guibas 1995).
double balanced(double density, double other) {
  return density > 0 ? density / (density + other) : 1;
}

OpaqueSurface withoutMirror(OpaqueSurface surface) {
  surface.dielectric = {};
  surface.grazing = 0;
  surface.metallic = 0;
  return surface;
}

}  // namespace

EyePaths::EyePaths(const Geometry& geometry, const PathTracer& tracer,
                   const EyePathOptions& options)
    : geometry_(geometry),
      tracer_(tracer),
      options_(options),
      lights_(geometry.scene()),
      throughMedia_(geometry, tracer.interiors()),
      exitFactors_(exitFactors(geometry.scene(), Transport::BetterDipole)) {
  for (const Body& body : geometry_.scene().bodies)
    mirrored_.push_back(body.opaque ? nullptr : &mirroredShareOfMedium(body.medium.eta));
}

// With even light inside, the light that leaves towards the eye is what a surface would not mirror
// of even light outside.
double EyePaths::letOut(std::uint32_t body, double alpha, double cosine) const {
  return 1 - (*mirrored_[body])(alpha, cosine);
}

EyePaths::Vertex EyePaths::vertexAt(const SurfacePoint& point, const Vector& toEye,
                                    bool first) const {
  const Body& body = geometry_.scene().bodies[point.body];
  if (!body.opaque) {
    const Sides sides = sidesOf(body, point, toEye);
    const double cosine = std::clamp(dot(sides.normal, toEye), 1e-3, 1.0);
    const double alpha = alphaAt(body, point, options_.roughness);
    Vertex vertex{point, toEye,
                  Reflection::ofMedium(body.medium.eta, alpha, sides.normal, sides.outside, toEye)};
    vertex.letsOut = letOut(point.body, alpha, cosine);
    vertex.own = exitFactors_[point.body] * vertex.letsOut * tracer_.exitance(point).value;
    return vertex;
  }
  OpaqueSurface surface = opaqueSurfaceAt(body, point);
  if (first && !options_.specular) surface = withoutMirror(surface);
  return opaqueVertex(point, surface, surface.emission, toEye);
}

// Light that arrives straight through a medium is known from the particles as well.
EyePaths::Vertex EyePaths::opaqueVertex(const SurfacePoint& point, const OpaqueSurface& surface,
                                        const Colour& emission, const Vector& toEye) const {
  const Sides sides = sidesOf(geometry_.scene().bodies[point.body], point, toEye);
  Vertex vertex{point,
                toEye,
                Reflection(surface, sides.normal, sides.outside, toEye),
                emission,
                surface.occlusion,
                surface.unlit};
  if (!vertex.ends)
    vertex.own += vertex.reflection.ofDiffuse(tracer_.straightThrough(point, sides.outside),
                                              tracer_.straightThrough(point, -sides.outside));
  return vertex;
}

// The light of all lights, by one sample each.
Colour EyePaths::lightAt(const Vertex& vertex, Random& random) const {
  Colour sum{};
  lights_.forEach(vertex.point.position, random, [&](const LightSample& light) {
    const Colour value = vertex.reflection.value(light.direction);
    if (largest(value) <= 0) return;
    const double weight =
        light.density > 0 ? balanced(light.density, vertex.reflection.density(light.direction)) : 1;
    if (geometry_.occluded(vertex.point, light.direction, light.distanceMm)) return;
    sum += (light.isSky ? vertex.occlusion : 1) * weight * product(value, light.irradiance);
  });
  return sum;
}

std::optional<EyePaths::Step> EyePaths::mirrored(const Vertex& vertex, Share& share,
                                                 Random& random) const {
  const Vector direction = vertex.reflection.direction(random);
  const double density = vertex.reflection.density(direction);
  if (!(density > 0)) return std::nullopt;
  const Reflection::Parts parts = vertex.reflection.partsOf(direction);
  share.ofStraight = (1 / density) * product(share.ofStraight, parts.mirrored);
  share.ofAll = (1 / density) * product(share.ofAll, parts.diffuse + parts.mirrored);
  return Step{vertex.point, direction, density};
}

std::optional<EyePaths::Step> EyePaths::next(const Vertex& vertex, Share& share,
                                             Random& random) const {
  constexpr double leastMirrored = 0.05;  // for the choice alone
  const bool seesThrough = tracer_.options().shown == Scattered::Both;
  if (vertex.letsOut <= 0 || !seesThrough) return mirrored(vertex, share, random);
  const auto exit = throughMedia_.from(vertex.point, -vertex.toEye, random);
  const Colour through = exit ? vertex.letsOut * product(share.ofStraight, exit->share) : Colour{};
  const double most = largest(through);
  const double other = std::max(1 - vertex.letsOut, leastMirrored) * largest(share.ofAll);
  const double chance = most > 0 ? most / (most + other) : 0;
  if (random() < chance) {
    share.ofAll = share.ofStraight = (1 / chance) * through;
    return Step{exit->point, exit->direction, 0, exit->isOpaque};
  }
  share *= 1 / (1 - chance);
  return mirrored(vertex, share, random);
}

Colour EyePaths::follow(Vertex vertex, Random& random) const {
  constexpr int certainBounces = 3;
  Colour sum{};
  Share share;
  int bounces = 0;
  while (true) {
    sum += product(share.ofAll, vertex.own);
    if (vertex.ends) return sum;
    sum += product(share.ofAll, lightAt(vertex, random));
    const std::optional<Step> step = next(vertex, share, random);
    if (!step || largest(share.ofAll) <= 0) return sum;
    if (step->arrived) {
      vertex = vertexAt(step->from, -step->direction, false);
      continue;
    }
    const auto hit = geometry_.closestHit(step->from, step->direction);
    const double free = hit ? hit->distanceMm : std::numeric_limits<double>::infinity();
    lights_.forEachAlong(step->from.position, step->direction, free, [&](const LightAlong& light) {
      const double weight = step->density > 0 ? balanced(step->density, light.density) : 1;
      sum += (light.isSky ? vertex.occlusion : 1) * weight * product(share.ofAll, light.radiance);
    });
    if (!hit) return sum;
    const bool bounced = step->density > 0;
    if (bounced && bounces++ >= tracer_.options().bounces) return sum;
    // Dark paths end at random.
    const double goesOn = bounces <= certainBounces ? 1 : std::min(largest(share.ofAll), 0.97);
    if (random() >= goesOn) return sum;
    share *= vertex.occlusion / goesOn;
    vertex = vertexAt(hit->point, -step->direction, false);
  }
}

Colour EyePaths::radiance(const SurfacePoint& point, const Vector& toEye, Random& random) const {
  return follow(vertexAt(point, toEye, true), random);
}

Colour EyePaths::exitance(const SurfacePoint& point, const Vector& toEye, Random& random) const {
  OpaqueSurface surface =
      withoutMirror(opaqueSurfaceAt(geometry_.scene().bodies[point.body], point));
  surface.unlit = false;
  return pi * follow(opaqueVertex(point, surface, {}, toEye), random);
}

}  // namespace opaline::reference
