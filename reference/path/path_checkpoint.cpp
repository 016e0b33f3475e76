#include <bit>
#include <cstring>

#include "core/digest.h"
#include "lights/area.h"
#include "opaline/error.h"
#include "reference/own_surface.h"
#include "reference/path/path_tracer.h"

namespace opaline::reference {

namespace {

constexpr std::uint64_t magic = 0x31485441504C504F;  // "OPLPATH1"

/// Precedes the counts.
struct Header {
  std::uint64_t magic = 0;
  std::uint64_t fingerprint = 0;
  std::uint64_t particles = 0;
  std::uint64_t counts = 0;
  std::array<std::uint64_t, 3> lost{};
};

void add(const std::optional<Texture>& texture, core::Digest& print) {
  print.add(texture.has_value());
  if (!texture) return;
  print.add(texture->transform);
  print.add(texture->pixels->rgba);
}

void add(const OpaqueMaterial& material, core::Digest& print) {
  print.add(material.baseColor);
  print.add(material.metallic);
  print.add(material.roughness);
  print.add(material.ior);
  print.add(material.specular);
  print.add(material.specularColor);
  print.add(material.emission);
  print.add(material.alphaCutoff);
  print.add(material.alpha);
  print.add(material.unlit);
  print.add(material.diffuseTransmission);
  print.add(material.diffuseTransmissionColor);
  for (const TextureOfMaterial& of : texturesOfMaterial) add(material.*of.texture, print);
}

}  // namespace

std::uint64_t PathTracer::fingerprint() const {
  core::Digest print;
  for (const Body& body : geometry_.scene().bodies) {
    print.add(body.positionsMm);
    print.add(body.triangles);
    if (body.opaque) {
      add(*body.opaque, print);
      continue;
    }
    print.add(body.medium.sigmaSPrimePerMm);
    print.add(body.medium.sigmaAPerMm);
    print.add(body.medium.eta);
    print.add(body.medium.g);
    if (body.paint) {
      print.add(body.paint->color);
      add(body.paint->colorTexture, print);
    }
    if (!normalTextureOf(body)) continue;
    print.add(body.surface->normalScale);
    add(body.surface->normalTexture, print);
  }
  const Lighting& lighting = geometry_.scene().lighting;
  print.add(lighting.directional);
  print.add(lighting.points);
  print.add(lighting.spots);
  for (const AreaLight& light : lighting.areas) {
    print.add(light.index());
    print.add(radianceOf(light));
    print.add(isTwoSided(light));
    print.add(areaMm2(light));
    for (const double x : {0.1, 0.5, 0.9}) print.add(pointOn(light, x, 0.3 * x).positionMm);
  }
  print.add(lighting.ambient);
  if (lighting.environment) {
    print.add(lighting.environment->width);
    print.add(lighting.environment->rgba);
  }
  print.add(options_.bounces);
  print.add(options_.seed);
  print.add(options_.coneDegrees);
  if (options_.coneDegrees > 0) print.add(geometry_.scene().camera.positionMm);
  print.add(cells_.count());
  print.add(opaqueCells_.count());
  return print.value();
}

std::vector<std::byte> PathTracer::save() const {
  Header header{magic, fingerprint(), particles_, counts_.size(), {}};
  for (std::size_t c = 0; c < 3; ++c) header.lost[c] = lost_[c];
  std::vector<std::byte> saved(sizeof(Header) + counts_.size() * sizeof(std::uint32_t));
  std::memcpy(saved.data(), &header, sizeof(Header));
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    const std::uint32_t count = counts_[i];
    std::memcpy(&saved[sizeof(Header) + i * sizeof(count)], &count, sizeof(count));
  }
  return saved;
}

void PathTracer::restore(std::span<const std::byte> saved) {
  Header header;
  if (saved.size() >= sizeof(Header)) std::memcpy(&header, saved.data(), sizeof(Header));
  if (header.magic != magic) throw Error("it is no checkpoint of a path tracer");
  if (header.fingerprint != fingerprint() || header.counts != counts_.size() ||
      saved.size() != sizeof(Header) + counts_.size() * sizeof(std::uint32_t)) {
    throw Error("it is a checkpoint of another scene or of other options");
  }
  particles_ = header.particles;
  for (std::size_t c = 0; c < 3; ++c) lost_[c] = header.lost[c];
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    std::uint32_t count = 0;
    std::memcpy(&count, &saved[sizeof(Header) + i * sizeof(count)], sizeof(count));
    counts_[i] = count;
  }
}

}  // namespace opaline::reference
