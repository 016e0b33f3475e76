#include "opaline/digest.h"

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "core/digest.h"

namespace opaline {

namespace scene {
namespace {

using core::Digest;

// Every structure is unpacked completely. Whoever adds a member is thus told by the compiler to
// decide whether it affects pixels.

template <typename... Parts>
void addAll(Digest& digest, const Parts&... parts) {
  (digest.add(parts), ...);
}

template <typename T, typename Add>
void addEach(Digest& digest, const std::vector<T>& values, const Add& add) {
  digest.add(std::uint64_t{values.size()});
  for (const T& value : values) add(value);
}

template <typename T, typename Add>
void addIfThere(Digest& digest, const std::optional<T>& value, const Add& add) {
  digest.add(value.has_value());
  if (value) add(*value);
}

void addRig(Digest& digest, const Rig& rig) {
  const auto& [node, positions, normals, targets, joints, firstInfluence, influences, toScene] =
      rig;
  addAll(digest, node, positions, normals);
  addEach(digest, targets, [&](const MorphTarget& target) {
    const auto& [moved, turned] = target;
    addAll(digest, moved, turned);
  });
  addAll(digest, joints, firstInfluence, influences, toScene);
}

void addTexture(Digest& digest, const std::optional<Texture>& texture) {
  addIfThere(digest, texture, [&](const Texture& given) {
    const auto& [pixels, wrapU, wrapV, interpolated, coordinates, transform] = given;
    const auto& [width, height, rgba, name] = *pixels;
    addAll(digest, width, height, rgba, wrapU, wrapV, interpolated, coordinates, transform);
  });
}

void addNumbers(Digest& digest, const OpaqueMaterial& material) {
  const auto& [name, baseColor, baseColorTexture, metallic, roughness, metallicRoughnessTexture,
               ior, specular, specularColor, specularTexture, specularColorTexture, normalTexture,
               normalScale, occlusionTexture, occlusionStrength, emission, emissionTexture,
               alphaCutoff, alpha, unlit, diffuseTransmission, diffuseTransmissionTexture,
               diffuseTransmissionColor, diffuseTransmissionColorTexture] = material;
  addAll(digest, baseColor, metallic, roughness, ior, specular, specularColor, normalScale,
         occlusionStrength, emission, alphaCutoff, alpha, unlit, diffuseTransmission,
         diffuseTransmissionColor);
  for (const TextureOfMaterial& of : texturesOfMaterial)
    addIfThere(digest, material.*of.texture,
               [&](const Texture& texture) { digest.add(texture.transform); });
}

void addMaterial(Digest& digest, const OpaqueMaterial& material) {
  addNumbers(digest, material);
  for (const TextureOfMaterial& of : texturesOfMaterial) addTexture(digest, material.*of.texture);
}

void addObject(Digest& digest, const Object& object) {
  const auto& [name, mesh, medium, paint, surface, rig, opaque, isGround, duplicates] = object;
  const auto& [positionsMm, normals, triangles, facetted, textureCoordinates, colors] = mesh;
  const auto& [mediumName, sigmaSPrimePerMm, sigmaAPerMm, eta, g] = medium;
  addAll(digest, positionsMm, normals, triangles, facetted, sigmaSPrimePerMm, sigmaAPerMm, eta, g,
         isGround, textureCoordinates[0], textureCoordinates[1], colors);
  addIfThere(digest, opaque,
             [&](const OpaqueMaterial& material) { addMaterial(digest, material); });
  addIfThere(digest, paint, [&](const Paint& given) {
    const auto& [paintName, color, colorTexture] = given;
    addAll(digest, color);
    addTexture(digest, colorTexture);
  });
  addIfThere(digest, surface, [&](const TranslucentSurface& given) {
    const auto& [roughness, metallicRoughnessTexture, normalTexture, normalScale] = given;
    addIfThere(digest, roughness, [&](float number) { digest.add(number); });
    addTexture(digest, metallicRoughnessTexture);
    addTexture(digest, normalTexture);
    addAll(digest, normalScale);
  });
  addIfThere(digest, rig, [&](const Rig& given) { addRig(digest, given); });
}

void addMotion(Digest& digest, const Scene& scene) {
  addEach(digest, scene.nodes, [&](const Node& node) {
    const auto& [name, parent, translation, rotation, scale, matrix, morphWeights] = node;
    addAll(digest, parent, translation, rotation, scale);
    addIfThere(digest, matrix, [&](const Affine& affine) { digest.add(affine); });
    digest.add(morphWeights);
  });
  addEach(digest, scene.clips, [&](const Clip& clip) {
    const auto& [name, seconds, tracks] = clip;
    digest.add(seconds);
    addEach(digest, tracks, [&](const Track& track) {
      const auto& [node, target, interpolation, keys, values] = track;
      addAll(digest, node, target, interpolation, keys, values);
    });
  });
  addEach(digest, scene.deformers, [&](const Deformer& deformer) {
    const auto& [kind, amount, periodSeconds] = deformer;
    addAll(digest, kind, amount, periodSeconds);
  });
}

void addShape(Digest& digest, const RectangleLight& light) {
  const auto& [centreMm, uMm, vMm, radiance, twoSided, visible] = light;
  addAll(digest, centreMm, uMm, vMm, radiance, twoSided, visible);
}

void addShape(Digest& digest, const DiscLight& light) {
  const auto& [centreMm, normal, radiusMm, radiance, twoSided, visible] = light;
  addAll(digest, centreMm, normal, radiusMm, radiance, twoSided, visible);
}

void addShape(Digest& digest, const SphereLight& light) {
  const auto& [centreMm, radiusMm, radiance, visible] = light;
  addAll(digest, centreMm, radiusMm, radiance, visible);
}

void addShape(Digest& digest, const TubeLight& light) {
  const auto& [fromMm, toMm, radiusMm, radiance, visible] = light;
  addAll(digest, fromMm, toMm, radiusMm, radiance, visible);
}

void addLight(Digest& digest, const DirectionalLight& light) {
  const auto& [directionToLight, irradiance, angularRadiusDegrees] = light;
  addAll(digest, directionToLight, irradiance, angularRadiusDegrees);
}

void addLight(Digest& digest, const PointLight& light) {
  const auto& [positionMm, intensity] = light;
  addAll(digest, positionMm, intensity);
}

void addLight(Digest& digest, const SpotLight& light) {
  const auto& [positionMm, direction, intensity, innerDegrees, outerDegrees] = light;
  addAll(digest, positionMm, direction, intensity, innerDegrees, outerDegrees);
}

void addLighting(Digest& digest, const Lighting& lighting) {
  const auto& [directional, points, spots, areas, ambient, environment] = lighting;
  const auto add = [&](const auto& light) { addLight(digest, light); };
  addEach(digest, directional, add);
  addEach(digest, points, add);
  addEach(digest, spots, add);
  addEach(digest, areas, [&](const AreaLight& area) {
    digest.add(std::uint64_t{area.index()});
    std::visit([&](const auto& light) { addShape(digest, light); }, area);
  });
  digest.add(ambient);
  digest.add(environment != nullptr);
  if (!environment) return;
  digest.add(environment->width);
  digest.add(environment->rgba);
}

void addCamera(Digest& digest, const Camera& camera) {
  const auto& [positionMm, targetMm, up, verticalFovDegrees, shiftX, shiftY, orthographicHeightMm] =
      camera;
  addAll(digest, positionMm, targetMm, up, verticalFovDegrees, shiftX, shiftY);
  addIfThere(digest, orthographicHeightMm, [&](float heightMm) { digest.add(heightMm); });
}

template <typename T, typename Add>
void addKeys(Digest& digest, const std::vector<Keys<T>>& all, const Add& add) {
  addEach(digest, all, [&](const Keys<T>& of) {
    const auto& [index, seconds, values] = of;
    addAll(digest, index, seconds);
    addEach(digest, values, add);
  });
}

void addChanges(Digest& digest, const ClipChanges& changes) {
  const auto& [directional, points, spots, cameras, surfaces, media] = changes;
  const auto addOne = [&](const auto& light) { addLight(digest, light); };
  addKeys(digest, directional, addOne);
  addKeys(digest, points, addOne);
  addKeys(digest, spots, addOne);
  addKeys(digest, cameras, [&](const Camera& camera) { addCamera(digest, camera); });
  addKeys(digest, surfaces, [&](const OpaqueMaterial& material) { addNumbers(digest, material); });
  addKeys(digest, media, [&](const Medium& medium) {
    addAll(digest, medium.sigmaSPrimePerMm, medium.sigmaAPerMm, medium.eta, medium.g);
  });
}

void addScene(Digest& digest, const Scene& scene) {
  // What the camera sees counts, not who chose the camera.
  const auto& [name, objects, lighting, camera, cameraChosen, nodes, clips, changes, deformers,
               repairs, notShown] = scene;
  addEach(digest, objects, [&](const Object& object) { addObject(digest, object); });
  addLighting(digest, lighting);
  addCamera(digest, camera);
  addMotion(digest, scene);
  addEach(digest, changes, [&](const ClipChanges& of) { addChanges(digest, of); });
}

}  // namespace
}  // namespace scene

std::uint64_t digestOf(std::span<const std::byte> bytes) {
  core::Digest digest;
  digest.addBytes(bytes.data(), bytes.size());
  return digest.value();
}

std::uint64_t digestOf(const Scene& scene) {
  core::Digest digest;
  scene::addScene(digest, scene);
  return digest.value();
}

}  // namespace opaline
