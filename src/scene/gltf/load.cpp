#include <fmt/format.h>

#include <algorithm>
#include <variant>

#include "scene/finish.h"
#include "scene/formats.h"
#include "scene/gltf/accessor.h"
#include "scene/gltf/changes.h"
#include "scene/gltf/file.h"
#include "scene/gltf/instances.h"
#include "scene/gltf/json.h"
#include "scene/gltf/lights.h"
#include "scene/gltf/material.h"
#include "scene/gltf/medium.h"
#include "scene/gltf/mesh.h"
#include "scene/gltf/nodes.h"
#include "scene/gltf/not_shown.h"
#include "scene/not_shown.h"
#include "scene/rig.h"
#include "scene/text.h"

namespace opaline::scene {

namespace {

constexpr double mmPerMetre = 1000;
/// A file may draw one mesh any number of times. This many triangles or vertices are allowed, plus
/// one for every four bytes that are really there.
constexpr std::size_t mostRepeated = 4'000'000;

/// The state of a scene while its parts are gathered.
struct Gathering {
  const Input& input;
  const tinygltf::Model& model;
  GltfNodes nodes;
  GltfAccessors accessors;
  GltfMaterials materials;
  GltfMotion motion{};
  GltfParts parts{};
  RawScene scene{};
  std::size_t triangles = 0;
  std::size_t vertices = 0;

  std::size_t most() const {
    std::size_t bytes = 0;
    for (const tinygltf::Buffer& buffer : model.buffers) bytes += buffer.data.size();
    return mostRepeated + bytes / 4;
  }
};

void append(RawObject& object, BakedPrimitive&& part, std::uint64_t partNumber) {
  RawMesh& mesh = object.mesh;
  const auto offset = static_cast<std::uint32_t>(mesh.positions.size());
  const auto fileOffset = static_cast<std::uint32_t>(object.attributes.vertices);
  const RawMesh& more = part.mesh;
  mesh.facetted = (offset == 0 || mesh.facetted) && more.facetted;
  mesh.positions.insert(mesh.positions.end(), more.positions.begin(), more.positions.end());
  mesh.normals.insert(mesh.normals.end(), more.normals.begin(), more.normals.end());
  // Vertices along the seam of two primitives are no duplicates.
  for (const std::uint64_t tag : more.tags) mesh.tags.push_back(tag + (partNumber << 56U));
  for (const Triangle& t : more.triangles) {
    mesh.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  }
  mesh.badPolygons += more.badPolygons;
  for (const Provenance& of : more.provenance) mesh.provenance.push_back({of.vertex + fileOffset});
  appendAttributes(object.attributes, std::move(part.attributes));
  if (!part.rig) return;
  if (object.rig) {
    appendRig(*object.rig, std::move(*part.rig));
  } else {
    object.rig = std::move(part.rig);
  }
}

/// glTF 2.0, section 3.7.2.2.
void requireEqualTargets(const Gathering& of, const tinygltf::Mesh& mesh, std::size_t node) {
  if (!of.motion.any() || !of.motion.weighted[node]) return;
  for (const tinygltf::Primitive& primitive : mesh.primitives) {
    if (primitive.targets.size() == mesh.primitives[0].targets.size()) continue;
    failGltf(of.input, fmt::format("the primitives of mesh '{}' differ in how many morph targets "
                                   "they have",
                                   cleanText(mesh.name, 60)));
  }
}

/// Drops a texture whose coordinates the mesh lacks, as it cannot be shown. Returns whether it did.
bool dropWithout(const VertexAttributes& attributes, std::optional<Texture>& texture) {
  const bool isThere = texture && (texture->coordinates == 0 || texture->coordinates == 1) &&
                       !attributes.textureCoordinates[texture->coordinates == 1].empty();
  if (!texture || isThere) return false;
  texture.reset();
  return true;
}

bool dropTexturesWithout(const VertexAttributes& attributes, GltfSurface& surface) {
  bool any = false;
  if (surface.opaque)
    for (const TextureOfMaterial& of : texturesOfMaterial)
      any = dropWithout(attributes, (*surface.opaque).*of.texture) || any;
  if (std::optional<TranslucentSurface>& own = surface.translucent.surface; own)
    for (const auto member : texturesOfTranslucentSurface)
      any = dropWithout(attributes, *own.*member) || any;
  std::optional<Paint>& paint = surface.translucent.paint;
  return (paint && dropWithout(attributes, paint->colorTexture)) || any;
}

void addMesh(Gathering& to, std::size_t nodeIndex) {
  const tinygltf::Node& node = to.model.nodes[nodeIndex];
  if (node.mesh < 0 || static_cast<std::size_t>(node.mesh) >= to.model.meshes.size()) {
    failGltf(to.input,
             fmt::format("node {} names mesh {}, which does not exist", nodeIndex, node.mesh));
  }
  const tinygltf::Mesh& mesh = to.model.meshes[static_cast<std::size_t>(node.mesh)];
  const std::string name = !node.name.empty()   ? cleanText(node.name)
                           : !mesh.name.empty() ? cleanText(mesh.name)
                                                : fmt::format("node {}", nodeIndex);
  requireEqualTargets(to, mesh, nodeIndex);
  const std::size_t first = to.scene.objects.size();
  std::uint64_t part = 0;
  for (const tinygltf::Primitive& primitive : mesh.primitives) {
    if (!isSurface(primitive)) continue;
    GltfSurface surface = to.materials.surface(primitive.material, mesh.name, node.name);
    if (!surface.opaque && primitive.material >= 0)
      to.scene.hasMediaPerMetre =
          to.scene.hasMediaPerMetre ||
          saysMediumByVolume(to.model.materials[static_cast<std::size_t>(primitive.material)]);
    BakedPrimitive baked =
        bakePrimitive(to.input, to.model, to.nodes, to.motion, to.accessors, nodeIndex, primitive);
    if (!surface.opaque) baked.attributes.colors.clear();  // a medium has no base colour
    if (dropTexturesWithout(baked.attributes, surface))
      addNotShown(to.scene.notShown, "textures without coordinates", name);
    to.triangles += baked.mesh.triangles.size();
    to.vertices += baked.mesh.positions.size();
    if (to.triangles > to.most() || to.vertices > to.most()) {
      failGltf(to.input, fmt::format("it repeats its meshes to more than {} triangles or vertices",
                                     to.most()));
    }
    const auto begin = to.scene.objects.begin() + static_cast<std::ptrdiff_t>(first);
    const bool alone = isAnimated(to.motion, primitive.material);
    auto object = std::find_if(begin, to.scene.objects.end(), [&](const RawObject& known) {
      const auto number = static_cast<std::size_t>(&known - to.scene.objects.data());
      const int material = to.parts.materialOfObject[number];
      const bool apart =
          material != primitive.material && (alone || isAnimated(to.motion, material));
      return !apart && known.opaque == surface.opaque &&
             known.rig.has_value() == baked.rig.has_value() &&
             (known.opaque || (known.medium == surface.translucent.medium &&
                               known.paint == surface.translucent.paint &&
                               known.surface == surface.translucent.surface));
    });
    if (object == to.scene.objects.end()) {
      to.scene.objects.push_back({.name = name,
                                  .medium = surface.translucent.medium,
                                  .paint = surface.translucent.paint,
                                  .surface = surface.translucent.surface,
                                  .opaque = surface.opaque});
      object = to.scene.objects.end() - 1;
      to.parts.materialOfObject.push_back(primitive.material);
    }
    append(*object, std::move(baked), part++);
  }
  // Without numbers, two objects of one node could not be told apart.
  if (to.scene.objects.size() > first + 1) {
    for (std::size_t i = first; i < to.scene.objects.size(); ++i) {
      RawObject& object = to.scene.objects[i];
      object.name += fmt::format(" ({})", object.opaque ? object.opaque->name : object.medium.name);
    }
  }
}

/// Adds the node's light, if it has one.
void addLight(Gathering& to, std::size_t nodeIndex) {
  const auto& extensions = to.model.nodes[nodeIndex].extensions;
  const auto found = extensions.find("KHR_lights_punctual");
  if (found == extensions.end() || !found->second.Has("light")) return;
  const int index = gltfIndex(found->second, "light").value_or(-1);
  if (index < 0 || static_cast<std::size_t>(index) >= to.model.lights.size()) {
    failGltf(to.input, fmt::format("node {} names a light that does not exist", nodeIndex));
  }
  const auto number = static_cast<std::size_t>(index);
  const tinygltf::Light& light = to.model.lights[number];
  const auto read = readLight(to.input, light, to.nodes.world[nodeIndex], nodeIndex);
  if (!read) {
    addNotShown(to.scene.notShown, cleanText(light.type, 20) + " lights", light.name);
    return;
  }
  if (light.range > 0) addNotShown(to.scene.notShown, "ranges of lights", light.name);
  Lighting& lighting = to.scene.lighting;
  const auto add = [&](auto& lights, const auto& one) {
    to.parts.lights.push_back({nodeIndex, number, lights.size()});
    lights.push_back(one);
  };
  if (const auto* directional = std::get_if<DirectionalLight>(&*read))
    add(lighting.directional, *directional);
  if (const auto* point = std::get_if<PointLight>(&*read)) add(lighting.points, *point);
  if (const auto* spot = std::get_if<SpotLight>(&*read)) add(lighting.spots, *spot);
  to.scene.hasLights = true;
}

/// Takes the file's first camera; aimAtMiddle() sets how far away its target is.
void takeCamera(Gathering& to, std::size_t nodeIndex) {
  const int index = to.model.nodes[nodeIndex].camera;
  if (index == -1) return;
  if (index < 0 || static_cast<std::size_t>(index) >= to.model.cameras.size()) {
    failGltf(to.input, fmt::format("node {} names a camera that does not exist", nodeIndex));
  }
  const tinygltf::Camera& camera = to.model.cameras[static_cast<std::size_t>(index)];
  if (to.scene.camera) {
    addNotShown(to.scene.notShown, "cameras after the first", camera.name);
    return;
  }
  to.scene.camera = readCamera(to.input, camera, to.nodes.world[nodeIndex]);
  to.scene.cameraChosen = true;
  to.parts.cameraNode = nodeIndex;
}

void aimAtMiddle(RawScene& scene) {
  if (!scene.camera) return;
  const Double3 middle = exactMiddleOf(boundsOf(scene));
  const Double3 from = toDouble(scene.camera->positionMm);
  const Double3 forward = toDouble(scene.camera->targetMm) - from;
  const double distance = dot(middle - from, forward);
  if (distance > 0) scene.camera->targetMm = toFloat(from + distance * forward);
}

}  // namespace

RawScene loadGltf(const Input& input) {
  tinygltf::Model read = readGltf(input);
  expandInstances(input, read);
  const tinygltf::Model& model = read;
  Gathering gathering{input, model, resolveNodes(input, model), GltfAccessors(input, model),
                      GltfMaterials(input, model)};
  gathering.motion = readMotion(input, model, gathering.nodes, gathering.accessors);
  for (const int node : gathering.nodes.drawn) {
    const auto index = static_cast<std::size_t>(node);
    if (model.nodes[index].mesh != -1) addMesh(gathering, index);
    addLight(gathering, index);
    takeCamera(gathering, index);
  }
  std::vector<NotShown> notShown = notShownOf(model, gathering.nodes, gathering.materials.opaque());
  addNotShown(notShown, gathering.scene.notShown);
  gathering.scene.notShown = std::move(notShown);
  aimAtMiddle(gathering.scene);
  gathering.scene.changes = readChanges(input, model, gathering.nodes, gathering.motion,
                                        gathering.parts, gathering.materials, gathering.scene);
  gathering.scene.unreadable = gathering.materials.unreadableTextures();
  gathering.scene.nodes = std::move(gathering.motion.nodes);
  gathering.scene.clips = std::move(gathering.motion.clips);
  gathering.scene.mmPerUnit = mmPerMetre;
  return std::move(gathering.scene);
}

}  // namespace opaline::scene
