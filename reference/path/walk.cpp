#include "reference/path/walk.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/path/reflection.h"

namespace opaline::reference {

Vector mirrored(const Vector& direction, const Vector& normal) {
  return unitOr(direction - 2 * dot(direction, normal) * normal, direction);
}

Vector refracted(const Vector& direction, const Vector& normal, double eta) {
  const double cosine = -dot(direction, normal);
  const double squared = 1 - (1 - cosine * cosine) / (eta * eta);
  const double inner = std::sqrt(std::max(squared, 0.0));
  return unitOr((1 / eta) * direction + (cosine / eta - inner) * normal, direction);
}

Vector refractedInto(const Vector& facet, const Vector& direction, const Vector& normal,
                     double eta) {
  const Vector inside = refracted(direction, normal, eta);
  return dot(inside, facet) < 0 ? inside : refracted(direction, facet, eta);
}

Vector scattered(const Vector& direction, double g, Random& random) {
  const double u = 2 * random() - 1;
  double cosine = u;
  if (g != 0) {
    const double part = (1 - g * g) / (1 + g * u);
    cosine = std::clamp((1 + g * g - part * part) / (2 * g), -1.0, 1.0);
  }
  const double angle = 2 * std::numbers::pi * random();
  if (g != 0) return around(direction, cosine, angle);
  const double sine = std::sqrt(std::max(1 - cosine * cosine, 0.0));
  return {sine * std::cos(angle), sine * std::sin(angle), cosine};
}

void Walk::reflect(const Particle& particle, Random& random, std::vector<Particle>& others) const {
  const Body& body = geometry_.scene().bodies[particle.surface.body];
  const OpaqueSurface surface = opaqueSurfaceAt(body, particle.surface);
  const Vector toLight = -particle.direction;
  const Vector& facet = particle.surface.facetNormal;
  const Vector normal = dot(facet, toLight) < 0 ? -facet : facet;
  reflectParticle(surface, channel_, normal, toLight, random, [&](const Vector& direction) {
    Particle next = particle;
    next.direction = direction;
    next.straightThrough = false;
    others.push_back(next);
  });
}

std::vector<Interior> interiorsOf(const Scene& scene, std::size_t channel) {
  std::vector<Interior> interiors;
  for (const Body& body : scene.bodies) {
    if (body.opaque) {
      interiors.emplace_back();
      continue;
    }
    const double scattering = body.medium.sigmaSPrimePerMm[channel] / (1 - body.medium.g);
    const double extinction = scattering + body.medium.sigmaAPerMm[channel];
    interiors.push_back(
        {extinction, scattering / extinction, body.medium.g, body.medium.eta,
         body.paint ? std::make_shared<const Layer>(body, static_cast<int>(channel)) : nullptr});
  }
  return interiors;
}

std::vector<double> densestOf(const Scene& scene, const std::vector<Interior>& interiors) {
  std::vector<double> densest(interiors.size(), 0);
  std::vector<int> parts(interiors.size(), 0);
  for (std::uint32_t body = 0; body < interiors.size(); ++body) {
    const std::uint32_t whole = wholeOf(scene, body);
    ++parts[whole];
    densest[whole] = std::max(densest[whole], interiors[body].sigmaTPerMm);
  }
  std::vector<double> result;
  result.reserve(interiors.size());
  for (std::uint32_t body = 0; body < interiors.size(); ++body) {
    const std::uint32_t whole = wholeOf(scene, body);
    result.push_back(parts[whole] > 1 ? densest[whole] : 0);
  }
  return result;
}

// A particle represents light that falls on the facet. The tilted surface receives more or less of
// it, so several particles continue or none.
void Walk::meetTilted(const Particle& particle, Random& random,
                      std::vector<Particle>& others) const {
  constexpr double mostParticles = 1000;  // from one that grazes the facet
  const SurfacePoint& point = particle.surface;
  const Vector& facet = point.facetNormal;
  const Vector normal = normalAt(geometry_.scene().bodies[point.body], point, facet);
  const double cosine = std::min(-dot(particle.direction, normal), 1.0);
  if (cosine <= 0) return;
  const double falling = std::min(cosine / -dot(particle.direction, facet), mostParticles);
  const double eta = interiors_[point.body].eta;
  const double reflectance = bssrdf::fresnelReflectance(eta, cosine);
  Particle next = particle;
  next.direction = mirrored(particle.direction, normal);
  if (dot(next.direction, facet) > 0)
    for (double left = falling * reflectance + random(); left >= 1; left -= 1)
      others.push_back(next);
  next.inside = true;
  next.direction = refractedInto(facet, particle.direction, normal, eta);
  for (double left = falling * (1 - reflectance) + random(); left >= 1; left -= 1)
    others.push_back(next);
}

bool Walk::reflectMatt(Particle& particle, Random& random) const {
  const Body& body = geometry_.scene().bodies[particle.surface.body];
  const OpaqueSurface surface = opaqueSurfaceAt(body, particle.surface);
  const double given = shareInMedium(surface, channel_);
  const double chance = random();
  if (chance >= given + surface.through[channel_]) return false;
  const Vector& facet = particle.surface.facetNormal;
  const bool turned = dot(facet, particle.direction) > 0;
  const Vector normal = turned == (chance < given) ? -facet : facet;
  const double cosine = std::sqrt(random());
  particle.direction = around(normal, cosine, 2 * std::numbers::pi * random());
  return true;
}

}  // namespace opaline::reference
