#include "scene/gltf/mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <optional>

#include "scene/gltf/draft.h"
#include "scene/gltf/skin.h"
#include "scene/hash.h"
#include "scene/rig.h"

namespace opaline::scene {

namespace {

std::vector<std::uint32_t> indicesOf(const Input& input, GltfAccessors& accessors,
                                     const tinygltf::Primitive& primitive, std::size_t vertices) {
  if (primitive.indices == -1) {
    std::vector<std::uint32_t> all(vertices);
    std::iota(all.begin(), all.end(), std::uint32_t{0});
    return all;
  }
  std::vector<std::uint32_t> indices = accessors.integers(primitive.indices, 1);
  for (const std::uint32_t index : indices) {
    if (index >= vertices) {
      failGltf(input, fmt::format("a triangle names vertex {}, but its mesh has {} vertices", index,
                                  vertices));
    }
  }
  return indices;
}

/// glTF 2.0, section 3.7.2.1.
std::vector<Triangle> assemble(int mode, const std::vector<std::uint32_t>& v) {
  std::vector<Triangle> triangles;
  if (mode == TINYGLTF_MODE_TRIANGLES) {
    for (std::size_t i = 0; i + 2 < v.size(); i += 3)
      triangles.push_back({v[i], v[i + 1], v[i + 2]});
    return triangles;
  }
  for (std::size_t i = 0; i + 2 < v.size(); ++i) {
    if (mode == TINYGLTF_MODE_TRIANGLE_STRIP) {
      triangles.push_back({v[i], v[i + 1 + i % 2], v[i + 2 - i % 2]});
    } else {
      triangles.push_back({v[i + 1], v[i + 2], v[0]});
    }
  }
  return triangles;
}

/// Vertices that differ in texture coordinates, colours, joints or morph targets get different
/// tags, although a still picture may not show the difference.
std::vector<std::uint64_t> tagsOf(const tinygltf::Model& model, GltfAccessors& accessors,
                                  const tinygltf::Primitive& primitive, std::size_t vertices) {
  std::vector<std::uint64_t> tags(vertices, 0);
  const auto add = [&](int accessor) {
    if (accessor < 0 || static_cast<std::size_t>(accessor) >= model.accessors.size()) return;
    const tinygltf::Accessor& of = model.accessors[static_cast<std::size_t>(accessor)];
    const int components = tinygltf::GetNumComponentsInType(static_cast<unsigned>(of.type));
    if (components <= 0 || of.count != vertices) return;
    const std::vector<float> values = accessors.floats(accessor, components);
    const auto width = static_cast<std::size_t>(components);
    for (std::size_t i = 0; i < values.size(); ++i) {
      mix(tags[i / width], std::uint64_t{std::bit_cast<std::uint32_t>(values[i])});
    }
  };
  for (const auto& [name, accessor] : primitive.attributes) {
    if (name != "POSITION" && name != "NORMAL" && name != "TANGENT") add(accessor);
  }
  for (const auto& target : primitive.targets) {
    for (const auto& [name, accessor] : target) {
      if (name == "POSITION" || name == "NORMAL") add(accessor);
    }
  }
  return tags;
}

std::vector<Vec2> textureCoordinates(GltfAccessors& accessors, const tinygltf::Primitive& primitive,
                                     const char* name, std::size_t vertices) {
  std::vector<Vec2> coordinates;
  const auto accessor = attribute(primitive.attributes, name);
  if (!accessor) return coordinates;
  const std::vector<float> numbers = accessors.floats(*accessor, 2, vertices);
  coordinates.resize(vertices);
  for (std::size_t v = 0; v < vertices; ++v) {
    // A texture cannot be sampled at a place that is not finite.
    const Vec2 place{numbers[2 * v], numbers[2 * v + 1]};
    if (std::isfinite(place[0]) && std::isfinite(place[1])) coordinates[v] = place;
  }
  return coordinates;
}

std::vector<std::array<float, 4>> colors(const tinygltf::Model& model, GltfAccessors& accessors,
                                         const tinygltf::Primitive& primitive,
                                         std::size_t vertices) {
  const auto accessor = attribute(primitive.attributes, "COLOR_0");
  if (!accessor) return {};
  const bool known = *accessor >= 0 && static_cast<std::size_t>(*accessor) < model.accessors.size();
  const bool alpha =
      known && model.accessors[static_cast<std::size_t>(*accessor)].type == TINYGLTF_TYPE_VEC4;
  const std::size_t width = alpha ? 4 : 3;
  const std::vector<float> numbers = accessors.floats(*accessor, static_cast<int>(width), vertices);
  std::vector<std::array<float, 4>> result(vertices, {1, 1, 1, 1});
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    // NaN becomes 0.
    result[i / width][i % width] = numbers[i] > 0 ? std::min(numbers[i], 1.0F) : 0.0F;
  }
  return result;
}

VertexAttributes attributesOf(const tinygltf::Model& model, GltfAccessors& accessors,
                              const tinygltf::Primitive& primitive, std::size_t vertices) {
  return {vertices,
          {textureCoordinates(accessors, primitive, "TEXCOORD_0", vertices),
           textureCoordinates(accessors, primitive, "TEXCOORD_1", vertices)},
          colors(model, accessors, primitive, vertices)};
}

/// The morph targets of a primitive, empty where they are not wanted. A target that moves no vertex
/// turns no normal either.
template <typename Wanted>
std::vector<MorphTarget> readTargets(GltfAccessors& accessors, const tinygltf::Primitive& primitive,
                                     const Draft& draft, Wanted&& wanted) {
  const std::vector<Vec3> still(draft.positions.size(), Vec3{0, 0, 0});
  std::vector<MorphTarget> targets;
  for (const auto& from : primitive.targets) {
    if (!wanted(targets.size())) {
      targets.emplace_back();
      continue;
    }
    const auto read = [&](const char* name) -> std::optional<std::vector<Vec3>> {
      const auto accessor = attribute(from, name);
      if (!accessor) return std::nullopt;
      std::vector<Vec3> values;
      for (const Double3& v : vectors(accessors, *accessor, draft.positions.size())) {
        values.push_back(toFloat(v));
      }
      return values;
    };
    auto positions = read("POSITION");
    auto normals = draft.normals.empty() ? std::nullopt : read("NORMAL");
    if (!positions && !normals) accessors.spend(6 * still.size());
    if (!positions && !normals) normals = still;
    MorphTarget target{positions ? std::move(*positions) : still, {}};
    if (normals) target.normals = std::move(*normals);
    for (Vec3& n : target.normals) {
      if (!isFinite(n)) n = {0, 0, 0};
    }
    targets.push_back(std::move(target));
  }
  return targets;
}

void morphBy(const std::vector<double>& weights, const std::vector<MorphTarget>& targets,
             Draft& draft) {
  for (std::size_t t = 0; t < targets.size() && t < weights.size(); ++t) {
    if (weights[t] == 0) continue;
    for (std::size_t v = 0; v < draft.positions.size(); ++v) {
      draft.positions[v] = draft.positions[v] + weights[t] * toDouble(targets[t].positions[v]);
    }
    if (targets[t].normals.empty()) continue;
    for (std::size_t v = 0; v < draft.normals.size(); ++v) {
      draft.normals[v] = draft.normals[v] + weights[t] * toDouble(targets[t].normals[v]);
    }
  }
}

/// The base of a rig: the vertices before anything moves them. Normals that the file lacks are
/// zero.
Rig rigOf(const Draft& draft) {
  Rig rig;
  rig.positions.reserve(draft.positions.size());
  for (const Double3& p : draft.positions) rig.positions.push_back(toFloat(p));
  rig.normals.reserve(draft.positions.size());
  for (const Double3& n : draft.normals) rig.normals.push_back(unitOrZero(n));
  rig.normals.resize(draft.positions.size(), Vec3{0, 0, 0});
  return rig;
}

bool moves(const GltfMotion& motion, std::size_t node, const GltfSkin& skin) {
  if (!motion.any()) return false;
  if (motion.weighted[node]) return true;
  if (skin.empty()) return motion.moved[node];
  return std::any_of(skin.joints.begin(), skin.joints.end(),
                     [&](const GltfJoint& joint) { return motion.moved[joint.node]; });
}

/// Attaches a rig to the nodes of the scene.
void hang(Rig& rig, const GltfMotion& motion, std::size_t node, GltfSkin&& skin) {
  rig.node = motion.place[node];
  if (skin.empty()) return;
  for (const GltfJoint& joint : skin.joints) {
    rig.joints.push_back({motion.place[joint.node], affineFrom(joint.inverseBind)});
  }
  rig.firstInfluence = std::move(skin.firstInfluence);
  rig.influences = std::move(skin.influences);
}

void transformBy(const Matrix4& matrix, Draft& draft) {
  for (Double3& p : draft.positions) p = matrix.point(p);
  for (Double3& n : draft.normals) n = matrix.normal(n);
  draft.mirrored = matrix.determinant() < 0;
}

/// glTF 2.0, section 3.7.2.1: without normals every triangle is flat, so each gets its own
/// vertices. Vertices that no triangle names stay, to be counted.
RawMesh flatMesh(const Draft& draft) {
  RawMesh mesh;
  std::vector<bool> used(draft.positions.size());
  for (const Triangle& t : draft.triangles) {
    for (const std::uint32_t v : t) used[v] = true;
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) {
      ++mesh.badPolygons;
      continue;
    }
    const Vec3 normal =
        unitOrZero(areaVector(draft.positions[t[0]], draft.positions[t[1]], draft.positions[t[2]]));
    Triangle own{};
    for (std::size_t c = 0; c < 3; ++c) {
      own[c] = static_cast<std::uint32_t>(mesh.positions.size());
      mesh.positions.push_back(toFloat(draft.positions[t[c]]));
      mesh.normals.push_back(normal);
      mesh.provenance.push_back({t[c]});
    }
    mesh.triangles.push_back(own);
  }
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (used[v]) continue;
    mesh.positions.push_back(toFloat(draft.positions[v]));
    mesh.normals.push_back({0, 0, 1});
    mesh.provenance.push_back({static_cast<std::uint32_t>(v)});
  }
  mesh.facetted = true;
  mesh.tags.resize(mesh.positions.size());
  std::iota(mesh.tags.begin(), mesh.tags.end(), std::uint64_t{0});
  return mesh;
}

RawMesh smoothMesh(const Draft& draft) {
  RawMesh mesh;
  mesh.positions.reserve(draft.positions.size());
  mesh.normals.reserve(draft.positions.size());
  for (const Double3& p : draft.positions) mesh.positions.push_back(toFloat(p));
  for (const Double3& n : draft.normals) mesh.normals.push_back(unitOrZero(n));
  mesh.tags = draft.tags;
  mesh.triangles = draft.triangles;
  startProvenance(mesh);
  return mesh;
}

}  // namespace

bool isSurface(const tinygltf::Primitive& primitive) {
  return primitive.mode == TINYGLTF_MODE_TRIANGLES ||
         primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP ||
         primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN;
}

BakedPrimitive bakePrimitive(const Input& input, const tinygltf::Model& model,
                             const GltfNodes& nodes, const GltfMotion& motion,
                             GltfAccessors& accessors, std::size_t nodeIndex,
                             const tinygltf::Primitive& primitive) {
  const tinygltf::Node& node = model.nodes[nodeIndex];
  const auto position = attribute(primitive.attributes, "POSITION");
  if (!position) failGltf(input, "a mesh has no positions");
  Draft draft;
  draft.positions = vectors(accessors, *position, std::nullopt);
  const std::size_t vertices = draft.positions.size();
  if (const auto normal = attribute(primitive.attributes, "NORMAL")) {
    draft.normals = vectors(accessors, *normal, vertices);
  }
  draft.triangles = assemble(primitive.mode, indicesOf(input, accessors, primitive, vertices));
  if (!draft.normals.empty()) draft.tags = tagsOf(model, accessors, primitive, vertices);

  GltfSkin skin;
  if (node.skin != -1) {
    skin = readSkin(input, model, accessors, node.skin, primitive, vertices);
  }
  const bool moving = moves(motion, nodeIndex, skin);
  const bool weighted = moving && motion.weighted[nodeIndex];
  const std::vector<double>& weights = defaultWeights(model, node);
  std::vector<MorphTarget> targets = readTargets(accessors, primitive, draft, [&](std::size_t t) {
    return weighted || (t < weights.size() && weights[t] != 0);
  });
  std::optional<Rig> rig;
  if (weighted) rig = rigOf(draft);
  morphBy(weights, targets, draft);
  // Weights that never change need no targets at run time.
  if (moving && !weighted) rig = rigOf(draft);
  if (weighted) rig->targets = std::move(targets);

  if (skin.empty()) {
    transformBy(nodes.world[nodeIndex], draft);
  } else {
    skinBy(skin, nodes, draft);
  }
  if (draft.mirrored) {
    for (Triangle& t : draft.triangles) std::swap(t[1], t[2]);
  }
  if (rig) hang(*rig, motion, nodeIndex, std::move(skin));
  return {draft.normals.empty() ? flatMesh(draft) : smoothMesh(draft),
          attributesOf(model, accessors, primitive, vertices), std::move(rig)};
}

}  // namespace opaline::scene
