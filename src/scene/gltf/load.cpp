#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "opaline/options/scene.h"
#include "scene/finish.h"
#include "scene/formats.h"
#include "scene/gltf/accessor.h"
#include "scene/gltf/file.h"
#include "scene/gltf/instances.h"
#include "scene/gltf/material.h"
#include "scene/gltf/mesh.h"
#include "scene/gltf/nodes.h"
#include "scene/gltf/not_shown.h"
#include "scene/not_shown.h"
#include "scene/rig.h"
#include "scene/text.h"

namespace opaline::scene {

namespace {

constexpr double mmPerMetre = 1000;
/// A file may draw one mesh any number of times: this many triangles or vertices at most, beyond
/// one for every four bytes that are really there.
constexpr std::size_t mostRepeated = 4'000'000;

/// What a scene is gathered with.
struct Gathering {
  const Input& input;
  const tinygltf::Model& model;
  GltfNodes nodes;
  GltfAccessors accessors;
  GltfMaterials materials;
  GltfMotion motion{};
  RawScene scene{};
  std::size_t triangles = 0;
  std::size_t vertices = 0;

  std::size_t most() const {
    std::size_t bytes = 0;
    for (const tinygltf::Buffer& buffer : model.buffers) bytes += buffer.data.size();
    return mostRepeated + bytes / 4;
  }
};

bool sameMedium(const Medium& a, const Medium& b) {
  return a.name == b.name && a.eta == b.eta && a.sigmaAPerMm == b.sigmaAPerMm &&
         a.sigmaSPrimePerMm == b.sigmaSPrimePerMm;
}

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

/// A texture whose coordinates the mesh does not have cannot be shown. Whether it was dropped.
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
    for (const auto member : texturesOfMaterial)
      any = dropWithout(attributes, *surface.opaque.*member) || any;
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
    auto object = std::find_if(begin, to.scene.objects.end(), [&](const RawObject& known) {
      return known.opaque == surface.opaque && known.rig.has_value() == baked.rig.has_value() &&
             (known.opaque || (sameMedium(known.medium, surface.translucent.medium) &&
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
    }
    append(*object, std::move(baked), part++);
  }
  // Without this two objects of one node could not be told apart.
  if (to.scene.objects.size() > first + 1) {
    for (std::size_t i = first; i < to.scene.objects.size(); ++i) {
      RawObject& object = to.scene.objects[i];
      object.name += fmt::format(" ({})", object.opaque ? object.opaque->name : object.medium.name);
    }
  }
}

/// The direction of an axis of a node, none where its transform is not invertible.
std::optional<Double3> axisOf(const Matrix4& world, std::size_t axis) {
  const Double3& column = world.column[axis];
  const double size = length(column);
  if (!isFinite(column) || !(size > 0)) return std::nullopt;
  return (1 / size) * column;
}

Rgb lightColor(const Input& input, const tinygltf::Light& light) {
  Rgb rgb{};
  for (std::size_t c = 0; c < 3; ++c) {
    const double value = (c < light.color.size() ? light.color[c] : 1.0) * light.intensity;
    if (!(value >= 0) || value > 1e30) {
      failGltf(input, fmt::format("the intensity of light '{}' is {}, but must be from 0 to 1e30",
                                  cleanText(light.name, 60), value));
    }
    rgb[c] = static_cast<float>(value);
  }
  return rgb;
}

SpotLight spotLight(const Input& input, const tinygltf::Light& light, const Matrix4& world,
                    std::size_t nodeIndex) {
  const auto back = axisOf(world, 2);
  if (!back) failGltf(input, fmt::format("light node {} has no direction", nodeIndex));
  constexpr double toDegrees = 180 / std::numbers::pi;
  const double inner = light.spot.innerConeAngle * toDegrees;
  const double outer = light.spot.outerConeAngle * toDegrees;
  // The extension allows no more than these. Rounding of π/2 is no mistake of the file.
  if (!(inner >= 0) || !(outer >= inner) || !(outer > 0) || !(outer <= 90 + 1e-4)) {
    failGltf(input, fmt::format("the cone of light '{}' goes from {:g} to {:g} degrees, but must "
                                "end between its inner angle and 90 degrees",
                                cleanText(light.name, 60), inner, outer));
  }
  SpotLight spot;
  spot.positionMm = toFloat(world.column[3]);
  spot.direction = toFloat(-1.0 * *back);
  spot.intensity = lightColor(input, light);
  spot.outerDegrees = static_cast<float>(std::min(outer, 90.0));
  spot.innerDegrees = std::min(static_cast<float>(inner), spot.outerDegrees);
  return spot;
}

/// KHR_lights_punctual: lux become irradiance as they are; candela become intensity in W/sr per
/// unit², where the unit is still a metre here.
void addLight(Gathering& to, std::size_t nodeIndex) {
  const auto& extensions = to.model.nodes[nodeIndex].extensions;
  const auto found = extensions.find("KHR_lights_punctual");
  if (found == extensions.end() || !found->second.Has("light")) return;
  const tinygltf::Value& value = found->second.Get("light");
  const int index = value.IsInt() ? value.GetNumberAsInt() : -1;
  if (index < 0 || static_cast<std::size_t>(index) >= to.model.lights.size()) {
    failGltf(to.input, fmt::format("node {} names a light that does not exist", nodeIndex));
  }
  const tinygltf::Light& light = to.model.lights[static_cast<std::size_t>(index)];
  const Matrix4& world = to.nodes.world[nodeIndex];
  if (light.type == "directional") {
    const auto back = axisOf(world, 2);
    if (!back) failGltf(to.input, fmt::format("light node {} has no direction", nodeIndex));
    to.scene.lighting.directional.push_back({toFloat(*back), lightColor(to.input, light)});
    to.scene.hasLights = true;
  } else if (light.type == "point") {
    to.scene.lighting.points.push_back({toFloat(world.column[3]), lightColor(to.input, light)});
    to.scene.hasLights = true;
  } else if (light.type == "spot") {
    to.scene.lighting.spots.push_back(spotLight(to.input, light, world, nodeIndex));
    to.scene.hasLights = true;
  } else {
    addNotShown(to.scene.notShown, cleanText(light.type, 20) + " lights", light.name);
  }
}

/// The first perspective camera; where it looks at is put beside the middle of the scene.
void takeCamera(Gathering& to, std::size_t nodeIndex) {
  const int index = to.model.nodes[nodeIndex].camera;
  if (index == -1) return;
  if (index < 0 || static_cast<std::size_t>(index) >= to.model.cameras.size()) {
    failGltf(to.input, fmt::format("node {} names a camera that does not exist", nodeIndex));
  }
  const tinygltf::Camera& camera = to.model.cameras[static_cast<std::size_t>(index)];
  if (camera.type != "perspective" || to.scene.camera) {
    addNotShown(to.scene.notShown,
                camera.type != "perspective" ? "orthographic cameras" : "cameras after the first",
                camera.name);
    return;
  }
  const Matrix4& world = to.nodes.world[nodeIndex];
  const auto back = axisOf(world, 2);
  const auto up = axisOf(world, 1);
  const double degrees = camera.perspective.yfov * 180 / std::numbers::pi;
  const std::string name = cleanText(camera.name, 60);
  if (!back || !up || !isFinite(world.column[3])) {
    failGltf(to.input, fmt::format("the node of camera '{}' gives it no place or no direction: its "
                                   "transform must be finite and invertible",
                                   name));
  }
  const options::Range degreesAllowed = options::fieldOf<Camera>("fov_degrees").allowed.range;
  if (!degreesAllowed.holds(degrees)) {
    failGltf(to.input, fmt::format("the vertical field of view of camera '{}' is {:g} degrees, but "
                                   "must be {}",
                                   name, degrees, options::describe(degreesAllowed)));
  }
  Camera taken;
  taken.positionMm = toFloat(world.column[3]);
  taken.targetMm = toFloat(world.column[3] - *back);
  taken.up = toFloat(*up);
  taken.verticalFovDegrees = static_cast<float>(degrees);
  to.scene.camera = taken;
  to.scene.cameraChosen = true;
}

/// Lights and cameras stay where the file puts them, whatever a clip does to their node.
void noteStanding(const Gathering& from, std::size_t nodeIndex) {
  if (!from.motion.any() || !from.motion.moved[nodeIndex]) return;
  const tinygltf::Node& node = from.model.nodes[nodeIndex];
  const bool lit = node.extensions.find("KHR_lights_punctual") != node.extensions.end();
  if (node.camera == -1 && !lit) return;
  note(from.input.log,
       fmt::format("{}: the {} at node '{}' stands still, though a clip moves it",
                   cleanText(from.input.file.string(), 1000),
                   node.camera == -1 ? "light" : "camera", cleanText(node.name, 60)));
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
    noteStanding(gathering, index);
  }
  std::vector<NotShown> notShown = notShownOf(model, gathering.nodes, gathering.materials.opaque());
  addNotShown(notShown, gathering.scene.notShown);
  gathering.scene.notShown = std::move(notShown);
  gathering.scene.nodes = std::move(gathering.motion.nodes);
  gathering.scene.clips = std::move(gathering.motion.clips);
  gathering.scene.mmPerUnit = mmPerMetre;
  aimAtMiddle(gathering.scene);
  return std::move(gathering.scene);
}

}  // namespace opaline::scene
