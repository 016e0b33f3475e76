#include "reference/path/emitter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "lights/area.h"
#include "reference/opaque_surface.h"

namespace opaline::reference {

namespace {

using std::numbers::pi;

// A ground is lit by particles up to this many radii of the bodies.
constexpr double nearGround = 4;

/// The most that a surface can emit.
double mostEmitted(const OpaqueMaterial& material, std::size_t channel) {
  return double{material.unlit ? material.baseColor[channel] : material.emission[channel]};
}

}  // namespace

Emitter::Emitter(const Geometry& geometry, int channel)
    : geometry_(geometry), channel_(static_cast<std::size_t>(channel)) {
  const Scene& scene = geometry.scene();
  centre_ = geometry.box().centre();
  std::optional<std::uint32_t> ground;
  for (std::uint32_t i = 0; i < scene.bodies.size(); ++i) {
    const Body& body = scene.bodies[i];
    if (body.isGround) ground = i;
    if (body.isGround) continue;
    for (const Vector& p : body.positionsMm)
      radiusOfBodiesMm_ = std::max(radiusOfBodiesMm_, length(p - centre_));
  }
  radiusOfBodiesMm_ *= 1 + 1e-6;
  radiusMm_ = ground ? nearGround * radiusOfBodiesMm_ : radiusOfBodiesMm_;
  if (ground) farGround_.emplace(geometry, *ground, channel_, radiusMm_);
  const std::size_t c = channel_;
  const double disc = pi * radiusMm_ * radiusMm_;
  for (const DirectionalLight& light : scene.lighting.directional)
    add({.kind = Kind::Directional,
         .place = unitOr(toVector(light.directionToLight), {0, 0, 1}),
         .cosine = std::cos(double{light.angularRadiusDegrees} * pi / 180),
         .lightsFarGround = true},
        double{light.irradiance[c]} * disc);
  for (const PointLight& light : scene.lighting.points) {
    const Vector position = toVector(light.positionMm);
    const double cosine = cosineOfScene(position);
    add({.kind = Kind::Point,
         .place = position,
         .cosine = cosine,
         .lightsFarGround = farGround_ && farGround_->counts(position)},
        double{light.intensity[c]} * 2 * pi * (1 - cosine));
  }
  for (const SpotLight& light : scene.lighting.spots) {
    const Vector position = toVector(light.positionMm);
    const double cosine = cosineOfScene(position);
    const Vector axis = unitOr(toVector(light.direction), {0, 0, -1});
    add({.kind = Kind::Point,
         .place = position,
         .cosine = cosine,
         .lightsFarGround = farGround_ && farGround_->counts(position),
         .axis = axis,
         .falloff = falloffOf(light)},
        double{light.intensity[c]} * 2 * pi * (1 - cosine));
  }
  areas_ = scene.lighting.areas;
  for (std::size_t i = 0; i < areas_.size(); ++i) addArea(i, c);
  add({.kind = Kind::Ambient, .lightsFarGround = true},
      double{scene.lighting.ambient[c]} * pi * 4 * disc);
  if (scene.lighting.environment) {
    Colour own{};
    own[c] = 1;
    environment_.emplace(*scene.lighting.environment, own);
    add({.kind = Kind::Environment, .lightsFarGround = true}, environment_->sum() * disc);
  }
  for (std::uint32_t i = 0; i < scene.bodies.size(); ++i) addSurface(i);
  if (farGround_)
    add({.kind = Kind::Ground},
        farGround_->mostRadiance() * pi * 4 * pi * radiusOfBodiesMm_ * radiusOfBodiesMm_);
}

void Emitter::add(Source source, double flux) {
  if (!(flux > 0)) return;
  flux_ += flux;
  source.fluxSoFar = flux_;
  sources_.push_back(source);
}

// Light from every place of an area light goes into the cone that holds the scene. All places use
// the angle of the nearest possible one, since no other cone is wider.
void Emitter::addArea(std::size_t index, std::size_t channel) {
  const AreaLight& light = areas_[index];
  const double cosine = cosineOfScene(middleOf(light), reachMm(light));
  const Source source{
      .kind = Kind::Area,
      .cosine = cosine,
      .lightsFarGround = farGround_ && farGround_->counts(middleOf(light), reachMm(light)),
      .area = index};
  add(source, double{radianceOf(light)[channel]} * areaMm2(light) * 2 * pi * (1 - cosine));
}

double Emitter::cosineOfScene(const Vector& position, double reachMm) const {
  if (farGround_ && !farGround_->counts(position, reachMm)) return -1;
  const double distance = length(position - centre_) - reachMm;
  const double ratio = radiusMm_ / distance;
  return distance > radiusMm_ ? std::sqrt(1 - ratio * ratio) : -1;
}

void Emitter::addSurface(std::uint32_t body) {
  const Body& of = geometry_.scene().bodies[body];
  if (!of.opaque || !(mostEmitted(*of.opaque, channel_) > 0)) return;
  Surface surface{body, {}};
  double area = 0;
  for (const Triangle& t : of.triangles) {
    const Vector& a = of.positionsMm[t[0]];
    area += 0.5 * length(cross(of.positionsMm[t[1]] - a, of.positionsMm[t[2]] - a));
    surface.areasSoFarMm2.push_back(area);
  }
  const Source source{.kind = Kind::Surface, .area = surfaces_.size()};
  surfaces_.push_back(std::move(surface));
  add(source, mostEmitted(*of.opaque, channel_) * 2 * pi * area);
}

Flight Emitter::throughDisc(const Vector& toLight, Random& random) const {
  const auto [x, y] = across(toLight);
  const double radius = radiusMm_ * std::sqrt(random());
  const double angle = 2 * pi * random();
  return {centre_ + 1.5 * radiusMm_ * toLight + radius * std::cos(angle) * x +
              radius * std::sin(angle) * y,
          -toLight};
}

Vector Emitter::fromCone(const Source& source, Random& random) {
  if (source.cosine >= 1) return source.place;
  const double cosine = 1 - random() * (1 - source.cosine);
  return around(source.place, cosine, 2 * pi * random());
}

Flight Emitter::fromPoint(const Source& source, Random& random) const {
  const double cosine = 1 - random() * (1 - source.cosine);
  const double angle = 2 * pi * random();
  const Vector direction = around(unitOr(centre_ - source.place, {0, 0, 1}), cosine, angle);
  const double part = source.falloff(dot(direction, source.axis));
  if (part < 1 && random() >= part) return nowhere();
  return {source.place, direction};
}

Flight Emitter::fromArea(const Source& source, Random& random) const {
  const AreaLight& light = areas_[source.area];
  const double x = random();
  const AreaPoint place = pointOn(light, x, random());
  const double cosineOfCone = source.cosine > -1 ? cosineOfScene(place.positionMm) : source.cosine;
  const double cosine = 1 - random() * (1 - cosineOfCone);
  const Vector direction =
      around(unitOr(centre_ - place.positionMm, {0, 0, 1}), cosine, 2 * pi * random());
  const double facing = dot(direction, place.normal);
  const double cosineOfLight = isTwoSided(light) ? std::abs(facing) : facing;
  if (random() * (1 - source.cosine) >= cosineOfLight * (1 - cosineOfCone)) return nowhere();
  return {place.positionMm, direction};
}

Flight Emitter::nowhere() const {
  return {centre_ + Vector{0, 0, 2 * radiusMm_}, {0, 0, 1}};
}

// Uniform radiance through a sphere: uniform places, and directions distributed by the cosine.
Flight Emitter::fromAround(double radiusMm, Random& random) const {
  const double height = 2 * random() - 1;
  const Vector outward = around({0, 0, 1}, height, 2 * pi * random());
  const double cosine = std::sqrt(random());
  return {centre_ + radiusMm * outward, around(-outward, cosine, 2 * pi * random())};
}

Flight Emitter::fromSurface(const Surface& surface, Random& random) const {
  const Body& body = geometry_.scene().bodies[surface.body];
  const std::vector<double>& soFar = surface.areasSoFarMm2;
  const auto found = std::upper_bound(soFar.begin(), soFar.end() - 1, random() * soFar.back());
  const double root = std::sqrt(random());
  const double along = random();
  const SurfacePoint point =
      geometry_.pointOn(surface.body, static_cast<std::uint32_t>(found - soFar.begin()),
                        {1 - root, root * (1 - along), root * along});
  const double emitted = opaqueSurfaceAt(body, point).emission[channel_];
  if (random() * mostEmitted(*body.opaque, channel_) >= emitted ||
      isCutOut(body, point.triangle, point.weights))
    return nowhere();
  const Vector side = random() < 0.5 ? point.facetNormal : -point.facetNormal;
  const double cosine = std::sqrt(random());
  return {point.position, around(side, cosine, 2 * pi * random()), point};
}

Flight Emitter::fromGround(Random& random) const {
  const Flight flight = fromAround(radiusOfBodiesMm_, random);
  const double radiance = farGround_->radianceThrough(flight.origin, flight.direction, random);
  return random() * farGround_->mostRadiance() < radiance ? flight : nowhere();
}

Flight Emitter::startedBy(const Source& source, Random& random) const {
  switch (source.kind) {
    case Kind::Directional:
      return throughDisc(fromCone(source, random), random);
    case Kind::Point:
      return fromPoint(source, random);
    case Kind::Area:
      return fromArea(source, random);
    case Kind::Ambient:
      return fromAround(radiusMm_, random);
    case Kind::Surface:
      return fromSurface(surfaces_[source.area], random);
    case Kind::Ground:
      return fromGround(random);
    case Kind::Environment:
      break;
  }
  return throughDisc(environment_->direction(random), random);
}

bool Emitter::isInfinitelyFar(const Source& source) {
  return source.kind == Kind::Directional || source.kind == Kind::Ambient ||
         source.kind == Kind::Environment;
}

Flight Emitter::emit(Random& random) const {
  const double wanted = random() * flux_;
  const auto source = std::find_if(sources_.begin(), sources_.end() - 1,
                                   [&](const Source& known) { return wanted < known.fluxSoFar; });
  Flight flight = startedBy(*source, random);
  if (!farGround_) return flight;
  if (isInfinitelyFar(*source) && farGround_->hides(flight.origin, flight.direction))
    return nowhere();
  if (source->lightsFarGround)
    flight.reachMm = (1 - 1e-6) * farGround_->distanceAlong(flight.origin, flight.direction);
  return flight;
}

}  // namespace opaline::reference
