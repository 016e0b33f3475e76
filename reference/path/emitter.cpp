#include "reference/path/emitter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "environment/lat_long.h"
#include "lights/area.h"

namespace opaline::reference {

namespace {

constexpr double pi = std::numbers::pi;

}  // namespace

Emitter::Emitter(const Scene& scene, int channel) {
  const Box box = boxOf(scene);
  centre_ = box.centre();
  for (const Body& body : scene.bodies)
    for (const Vector& p : body.positionsMm) radiusMm_ = std::max(radiusMm_, length(p - centre_));
  radiusMm_ *= 1 + 1e-6;
  const auto c = static_cast<std::size_t>(channel);
  const double disc = pi * radiusMm_ * radiusMm_;
  for (const DirectionalLight& light : scene.lighting.directional)
    add({Kind::Directional, unitOr(toVector(light.directionToLight), {0, 0, 1})},
        double{light.irradiance[c]} * disc);
  for (const PointLight& light : scene.lighting.points) {
    const Vector position = toVector(light.positionMm);
    const double cosine = cosineOfScene(position);
    add({Kind::Point, position, cosine}, double{light.intensity[c]} * 2 * pi * (1 - cosine));
  }
  for (const SpotLight& light : scene.lighting.spots) {
    const Vector position = toVector(light.positionMm);
    const double cosine = cosineOfScene(position);
    const Vector axis = unitOr(toVector(light.direction), {0, 0, -1});
    add({Kind::Point, position, cosine, 0, axis, falloffOf(light)},
        double{light.intensity[c]} * 2 * pi * (1 - cosine));
  }
  areas_ = scene.lighting.areas;
  for (std::size_t i = 0; i < areas_.size(); ++i) addArea(i, c);
  add({Kind::Ambient}, double{scene.lighting.ambient[c]} * pi * 4 * disc);
  if (scene.lighting.environment) addEnvironment(*scene.lighting.environment, channel);
}

void Emitter::add(Source source, double flux) {
  if (!(flux > 0)) return;
  flux_ += flux;
  source.fluxSoFar = flux_;
  sources_.push_back(source);
}

// Every place of a light shines into the cone from there that holds the scene, none of which is
// wider than that from as near as one could be.
void Emitter::addArea(std::size_t index, std::size_t channel) {
  const AreaLight& light = areas_[index];
  const double away = length(middleOf(light) - centre_) - reachMm(light);
  const double ratio = radiusMm_ / away;
  const double cosine = away > radiusMm_ ? std::sqrt(1 - ratio * ratio) : -1;
  Source source{Kind::Area, {}, cosine};
  source.area = index;
  add(source, double{radianceOf(light)[channel]} * areaMm2(light) * 2 * pi * (1 - cosine));
}

double Emitter::cosineOfScene(const Vector& position) const {
  const double distance = length(position - centre_);
  const double ratio = radiusMm_ / distance;
  return distance > radiusMm_ ? std::sqrt(1 - ratio * ratio) : -1;
}

void Emitter::addEnvironment(const Image& image, int channel) {
  environmentWidth_ = image.width;
  environmentHeight_ = image.height;
  double sum = 0;
  for (int y = 0; y < image.height; ++y) {
    const double top = std::cos(pi * y / image.height);
    const double bottom = std::cos(pi * (y + 1) / image.height);
    const double solidAngle = 2 * pi / image.width * (top - bottom);
    for (int x = 0; x < image.width; ++x) {
      sum += std::max(double{image.pixel(x, y)[channel]}, 0.0) * solidAngle;
      pixelsSoFar_.push_back(sum);
    }
  }
  add({Kind::Environment}, sum * pi * radiusMm_ * radiusMm_);
}

Flight Emitter::throughDisc(const Vector& toLight, Random& random) const {
  const auto [x, y] = across(toLight);
  const double radius = radiusMm_ * std::sqrt(random());
  const double angle = 2 * pi * random();
  return {centre_ + 1.5 * radiusMm_ * toLight + radius * std::cos(angle) * x +
              radius * std::sin(angle) * y,
          -toLight};
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
  const double cosineOfCone = cosineOfScene(place.positionMm);
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

// Uniform radiance through a sphere: uniform places, directions by the cosine.
Flight Emitter::fromAround(Random& random) const {
  const double height = 2 * random() - 1;
  const Vector outward = around({0, 0, 1}, height, 2 * pi * random());
  const double cosine = std::sqrt(random());
  return {centre_ + radiusMm_ * outward, around(-outward, cosine, 2 * pi * random())};
}

Vector Emitter::environmentDirection(Random& random) const {
  const double wanted = random() * pixelsSoFar_.back();
  const auto found = std::upper_bound(pixelsSoFar_.begin(), pixelsSoFar_.end(), wanted);
  const auto index = static_cast<int>(std::min<std::ptrdiff_t>(
      found - pixelsSoFar_.begin(), static_cast<std::ptrdiff_t>(pixelsSoFar_.size()) - 1));
  const int x = index % environmentWidth_;
  const int y = index / environmentWidth_;
  // Uniform in solid angle within the pixel: in the cosine of the polar angle.
  const double top = std::cos(pi * y / environmentHeight_);
  const double bottom = std::cos(pi * (y + 1) / environmentHeight_);
  const double v = std::acos(std::clamp(top + (bottom - top) * random(), -1.0, 1.0)) / pi;
  return toVector(latLongDirection((x + random()) / environmentWidth_, v));
}

Flight Emitter::emit(Random& random) const {
  const double wanted = random() * flux_;
  const auto source = std::find_if(sources_.begin(), sources_.end() - 1,
                                   [&](const Source& known) { return wanted < known.fluxSoFar; });
  switch (source->kind) {
    case Kind::Directional:
      return throughDisc(source->place, random);
    case Kind::Point:
      return fromPoint(*source, random);
    case Kind::Area:
      return fromArea(*source, random);
    case Kind::Ambient:
      return fromAround(random);
    case Kind::Environment:
      break;
  }
  return throughDisc(environmentDirection(random), random);
}

}  // namespace opaline::reference
