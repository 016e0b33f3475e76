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

Colour product(const Colour& a, const Colour& b) {
  return {a[0] * b[0], a[1] * b[1], a[2] * b[2]};
}

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
      exitFactors_(exitFactors(geometry.scene(), Transport::BetterDipole)) {
  for (const Body& body : geometry_.scene().bodies)
    mirrored_.push_back(body.opaque ? nullptr : &mirroredShareOfMedium(body.medium.eta));
}

// With even light inside, the light that leaves towards the eye is what a surface would not mirror
// of even light outside.
double EyePaths::leaving(std::uint32_t body, double alpha, double cosine) const {
  return exitFactors_[body] * (1 - (*mirrored_[body])(alpha, cosine));
}

EyePaths::Vertex EyePaths::vertexAt(const SurfacePoint& point, const Vector& toEye,
                                    bool first) const {
  const Body& body = geometry_.scene().bodies[point.body];
  if (!body.opaque) {
    const Sides sides = sidesOf(body, point, toEye);
    const double cosine = std::clamp(dot(sides.normal, toEye), 1e-3, 1.0);
    const double alpha = alphaAt(body, point, options_.roughness);
    return {point, Reflection::ofMedium(body.medium.eta, alpha, sides.normal, sides.outside, toEye),
            leaving(point.body, alpha, cosine) * tracer_.exitance(point).value};
  }
  OpaqueSurface surface = opaqueSurfaceAt(body, point);
  if (first && !options_.specular) surface = withoutMirror(surface);
  return opaqueVertex(point, surface, surface.emission, toEye);
}

// Light that arrives straight through a medium is known from the particles as well.
EyePaths::Vertex EyePaths::opaqueVertex(const SurfacePoint& point, const OpaqueSurface& surface,
                                        const Colour& emission, const Vector& toEye) const {
  const Sides sides = sidesOf(geometry_.scene().bodies[point.body], point, toEye);
  Vertex vertex{point, Reflection(surface, sides.normal, sides.outside, toEye), emission,
                surface.occlusion, surface.unlit};
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

Colour EyePaths::follow(Vertex vertex, Random& random) const {
  constexpr int certainBounces = 3;
  Colour sum{};
  Colour share{1, 1, 1};
  for (int bounce = 0;; ++bounce) {
    sum += product(share, vertex.own);
    if (vertex.ends) return sum;
    sum += product(share, lightAt(vertex, random));
    const Vector direction = vertex.reflection.direction(random);
    const double density = vertex.reflection.density(direction);
    if (!(density > 0)) return sum;
    share = product(share, (1 / density) * vertex.reflection.value(direction));
    if (largest(share) <= 0) return sum;
    const auto hit = geometry_.closestHit(vertex.point, direction);
    const double free = hit ? hit->distanceMm : std::numeric_limits<double>::infinity();
    lights_.forEachAlong(vertex.point.position, direction, free, [&](const LightAlong& light) {
      sum += (light.isSky ? vertex.occlusion : 1) * balanced(density, light.density) *
             product(share, light.radiance);
    });
    if (!hit || bounce >= tracer_.options().bounces) return sum;
    share = vertex.occlusion * share;
    // Dark paths end at random.
    const double goesOn = bounce < certainBounces ? 1 : std::min(largest(share), 0.97);
    if (random() >= goesOn) return sum;
    share = (1 / goesOn) * share;
    vertex = vertexAt(hit->point, -direction, false);
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
