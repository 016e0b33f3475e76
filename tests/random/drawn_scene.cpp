#include "random/drawn_scene.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "renderer/shapes.h"

namespace opaline::test {

namespace {

Vec3 placed(const Vec3& middleMm, float lengthMm, const Vec3& direction) {
  Vec3 place{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    place[axis] = middleMm[axis] + lengthMm * direction[axis];
  return place;
}

Vec3 times(float factor, const Vec3& v) {
  return {factor * v[0], factor * v[1], factor * v[2]};
}

Rgb color(Dice& dice, float scale) {
  return {scale * dice.between(0, 1), scale * dice.between(0, 1), scale * dice.between(0, 1)};
}

/// A body around the origin, of half size 1.
Mesh unitBody(Dice& dice) {
  switch (dice.below(6)) {
    case 0:
      return box({0, 0, 0}, {.6F, .5F, .4F}, 1 + dice.below(6));
    case 1:  // a plate
      return box({0, 0, 0}, {.8F, dice.betweenLog(1e-3F, .1F), .7F}, 1 + dice.below(8));
    case 2: {  // a needle
      const float thin = dice.betweenLog(1e-3F, .1F);
      return box({0, 0, 0}, {thin, 1, thin}, 1 + dice.below(4));
    }
    case 3:  // open
      return sheet({0, 0, 0}, {.8F, 0, 0}, {0, .5F, .5F}, 1 + dice.below(8));
    case 4:  // two that share a face, as one mesh
      return together(box({-.4F, 0, 0}, {.4F, .4F, .4F}, 3), box({.4F, 0, 0}, {.4F, .4F, .4F}, 2));
    default:
      return sphere({0, 0, 0}, .8F, 1 + dice.below(3));
  }
}

AreaLight areaLight(Dice& dice, float sizeMm, const Vec3& middleMm) {
  const Vec3 out = dice.direction();
  const Vec3 centre = placed(middleMm, dice.between(2, 4) * sizeMm, out);
  const float radius = sizeMm * dice.betweenLog(.02F, .8F);
  const Rgb radiance = color(dice, 8);
  switch (dice.below(4)) {
    case 0: {
      const Vector side = unit(cross(toVector(out), {.31, .52, .79}));
      const Vector other = cross(side, toVector(out));
      return RectangleLight{.centreMm = centre,
                            .uMm = toVec3(static_cast<double>(radius) * other),
                            .vMm = toVec3(static_cast<double>(radius) * side),
                            .radiance = radiance,
                            .twoSided = true};
    }
    case 1:
      return DiscLight{
          .centreMm = centre, .normal = times(-1, out), .radiusMm = radius, .radiance = radiance};
    case 2:
      return SphereLight{.centreMm = centre, .radiusMm = radius, .radiance = radiance};
    default:
      return TubeLight{.fromMm = centre,
                       .toMm = placed(centre, sizeMm, dice.direction()),
                       .radiusMm = .2F * radius,
                       .radiance = radiance};
  }
}

std::shared_ptr<const Image> environment(Dice& dice) {
  Image sky(16, 8);
  for (std::size_t i = 0; i < sky.rgba.size(); ++i)
    sky.rgba[i] = i % 4 == 3 ? 1.0F : dice.between(0, .6F);
  if (dice.chance(.5F)) sky.rgba[4 * static_cast<std::size_t>(dice.below(128))] = 60;  // a sun
  return std::make_shared<const Image>(std::move(sky));
}

// Nothing that shines by itself.
OpaqueMaterial drawOpaque(Dice& dice) {
  OpaqueMaterial material;
  material.baseColor = color(dice, 1);
  if (dice.chance(.3F)) material.metallic = dice.between(0, 1);
  material.roughness = dice.between(0, 1);
  if (dice.chance(.2F)) material.diffuseTransmission = dice.between(0, 1);
  return material;
}

}  // namespace

float Dice::between(float low, float high) {
  constexpr float steps = 1U << 24U;
  return low + (high - low) * static_cast<float>(bits_() >> 8U) / steps;
}

float Dice::betweenLog(float low, float high) {
  return low * std::pow(high / low, between(0, 1));
}

int Dice::below(int count) {
  return static_cast<int>(bits_() % static_cast<std::uint32_t>(count));
}

Vec3 Dice::direction() {
  const float z = between(-1, 1);
  const float angle = between(0, 2 * std::numbers::pi_v<float>);
  const float radius = std::sqrt(std::max(0.0F, 1 - z * z));
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

Medium drawMedium(Dice& dice, float sizeMm) {
  Medium medium{.name = "drawn", .eta = static_cast<double>(dice.between(1.01F, 2))};
  if (dice.chance(.3F)) medium.g = static_cast<double>(dice.between(-.9F, .9F));
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const double perMm =
        static_cast<double>(dice.betweenLog(.3F, 1000)) / static_cast<double>(sizeMm);
    const double absorbed = static_cast<double>(dice.betweenLog(1e-5F, .9F));
    medium.sigmaSPrimePerMm[channel] = perMm * (1 - absorbed);
    medium.sigmaAPerMm[channel] = perMm * absorbed;
  }
  return medium;
}

Material drawMaterial(Dice& dice, float sizeMm, bool opaque) {
  Material material{.medium = drawMedium(dice, sizeMm)};
  if (opaque) {
    material.opaque = drawOpaque(dice);
    return material;
  }
  if (dice.chance(.2F)) material.paint = Paint{.name = "drawn", .color = color(dice, 1)};
  if (dice.chance(.2F)) material.surface = TranslucentSurface{.roughness = dice.between(0, 1)};
  return material;
}

std::vector<Deformer> drawDeformers(Dice& dice) {
  std::vector<Deformer> deformers;
  while (deformers.size() < 3 && dice.chance(.3F)) {
    const std::array kinds{DeformerKind::Twist, DeformerKind::Bend, DeformerKind::Squash,
                           DeformerKind::Wobble};
    const DeformerKind kind = kinds[static_cast<std::size_t>(dice.below(4))];
    const float most = kind == DeformerKind::Wobble ? .2F : kind == DeformerKind::Squash ? .5F : 2;
    deformers.push_back({kind, dice.between(-most, most), dice.chance(.5F) ? 1.0F : 0.0F});
  }
  return deformers;
}

Lighting drawLighting(Dice& dice, float sizeMm, const Vec3& middleMm) {
  Lighting lighting;
  while (dice.chance(.5F)) lighting.directional.push_back({dice.direction(), color(dice, 3)});
  const auto place = [&] {
    return placed(middleMm, dice.between(2, 5) * sizeMm, dice.direction());
  };
  const float intensity = 10 * sizeMm * sizeMm;
  if (dice.chance(.4F)) lighting.points.push_back({place(), color(dice, intensity)});
  if (dice.chance(.3F)) {
    const Vec3 out = dice.direction();
    lighting.spots.push_back({placed(middleMm, 4 * sizeMm, out), times(-1, out),
                              color(dice, intensity), 5, dice.between(10, 80)});
  }
  while (lighting.areas.size() < 3 && dice.chance(.3F))
    lighting.areas.push_back(areaLight(dice, sizeMm, middleMm));
  if (dice.chance(.4F)) lighting.ambient = color(dice, 1);
  if (dice.chance(.2F)) lighting.environment = environment(dice);
  return lighting;
}

Camera drawCamera(Dice& dice, float sizeMm, const Vec3& middleMm) {
  return {.positionMm = placed(middleMm, dice.between(2.5F, 5) * sizeMm, dice.direction()),
          .targetMm = middleMm,
          .up = {.1F, 1, .2F},
          .verticalFovDegrees = dice.between(20, 60)};
}

Mesh drawBody(Dice& dice, float sizeMm, const Vec3& middleMm) {
  Mesh mesh = unitBody(dice);
  for (Vec3& position : mesh.positionsMm) position = placed(middleMm, sizeMm, position);
  return mesh;
}

DrawnScene drawScene(Dice& dice) {
  DrawnScene drawn;
  drawn.sizeMm = dice.betweenLog(1e-3F, 1e6F);
  if (dice.chance(.5F)) {
    const float most = std::min(1e7F, 1e4F * drawn.sizeMm);
    drawn.middleMm =
        placed({}, dice.betweenLog(drawn.sizeMm, std::max(most, drawn.sizeMm)), dice.direction());
  }
  const int bodies = 1 + dice.below(3);
  for (int i = 0; i < bodies; ++i) {
    Object object{.name = "body"};
    // Apart, touching or inside each other.
    const std::array gaps{0.0F, .8F, 1.6F, 2.0F};
    const Vec3 middle = placed(
        drawn.middleMm,
        drawn.sizeMm * static_cast<float>(i) * gaps[static_cast<std::size_t>(dice.below(4))] / 2,
        {1, 0, 0});
    object.mesh = drawBody(dice, drawn.sizeMm / 2, middle);
    object.medium = drawMedium(dice, drawn.sizeMm);
    drawn.scene.objects.push_back(std::move(object));
  }
  drawn.bodies = drawn.scene.objects.size();
  drawn.scene.lighting = drawLighting(dice, drawn.sizeMm, drawn.middleMm);
  drawn.scene.camera = drawCamera(dice, drawn.sizeMm, drawn.middleMm);
  drawn.scene.deformers = drawDeformers(dice);
  return drawn;
}

DrawnScene drawSceneOfAllKinds(Dice& dice) {
  DrawnScene drawn = drawScene(dice);
  for (Object& object : drawn.scene.objects)
    giveMaterial(drawMaterial(dice, drawn.sizeMm, dice.chance(.2F)), object);
  if (dice.chance(.2F))
    drawn.scene.objects.push_back(groundUnder(drawn.scene, {.color = color(dice, 1)}));
  return drawn;
}

bool isKnownToPattern(const Scene& scene) {
  return scene.lighting.areas.empty() &&
         std::none_of(scene.objects.begin(), scene.objects.end(),
                      [](const Object& object) { return object.opaque || object.paint; });
}

RenderOptions drawOptions(Dice& dice, const Scene& scene) {
  RenderOptions options;
  options.width = 16 + dice.below(17);
  options.height = 16 + dice.below(17);
  options.maxSurfels = 1024 << dice.below(2);
  options.maxClusters = 64 << dice.below(3);
  options.shadowSize = 64;
  options.dsmSize = 64;
  options.antialias = 1 << dice.below(2);
  options.bounces = dice.below(4);
  options.specular = dice.chance(.7F);
  options.roughness = dice.between(.1F, 1);
  options.ambientOcclusion = dice.chance(.3F);
  options.environmentBehind = dice.chance(.2F);
  const std::array sites{Site::Auto, Site::Vertex, Site::Fragment};
  options.site = sites[static_cast<std::size_t>(dice.below(3))];
  switch (dice.below(8)) {
    case 0:
      options.transport = Transport::Dipole;
      break;
    case 1:
      options.transport = Transport::BetterDipole;
      break;
    case 2:
      options.transport = Transport::Dipole;
      options.sum = Sum::All;
      break;
    case 3:
      options.transport = Transport::Dipole;
      if (isKnownToPattern(scene)) options.sum = Sum::Pattern;
      break;
    default:
      break;
  }
  return options;
}

}  // namespace opaline::test
