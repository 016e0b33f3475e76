#include "scene/gltf_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <span>
#include <string_view>

namespace opaline::scene {

namespace {

/// A primitive while it is baked.
struct Draft {
  std::vector<Double3> positions;
  std::vector<Double3> normals;  ///< empty where the file has none
  std::vector<std::uint64_t> tags;
  std::vector<Triangle> triangles;
  bool mirrored = false;
};

std::optional<int> attribute(const std::map<std::string, int>& attributes, const char* name) {
  const auto found = attributes.find(name);
  return found == attributes.end() ? std::nullopt : std::optional(found->second);
}

std::vector<Double3> vectors(GltfAccessors& accessors, int accessor,
                             std::optional<std::size_t> count) {
  const std::vector<float> numbers = accessors.floats(accessor, 3, count);
  std::vector<Double3> result(numbers.size() / 3);
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = {double{numbers[3 * i]}, double{numbers[3 * i + 1]}, double{numbers[3 * i + 2]}};
  }
  return result;
}

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

void mix(std::uint64_t& hash, std::uint64_t value) {
  hash = (hash ^ value) * 0x9E3779B97F4A7C15U;
  hash ^= hash >> 29U;
}

/// Vertices that differ in texture coordinates, colours, joints or morph targets are different,
/// although those do not show in a still.
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

void morph(const tinygltf::Model& model, GltfAccessors& accessors, const tinygltf::Node& node,
           const tinygltf::Primitive& primitive, Draft& draft) {
  const std::vector<double>& weights =
      node.weights.empty() ? model.meshes[static_cast<std::size_t>(node.mesh)].weights
                           : node.weights;
  for (std::size_t t = 0; t < primitive.targets.size() && t < weights.size(); ++t) {
    if (weights[t] == 0) continue;
    const auto addTo = [&](const char* name, std::vector<Double3>& values) {
      const auto accessor = attribute(primitive.targets[t], name);
      if (!accessor || values.empty()) return;
      const std::vector<Double3> deltas = vectors(accessors, *accessor, values.size());
      for (std::size_t v = 0; v < values.size(); ++v)
        values[v] = values[v] + weights[t] * deltas[v];
    };
    addTo("POSITION", draft.positions);
    addTo("NORMAL", draft.normals);
  }
}

void transformBy(const Matrix4& matrix, Draft& draft) {
  for (Double3& p : draft.positions) p = matrix.point(p);
  for (Double3& n : draft.normals) n = matrix.normal(n);
  draft.mirrored = matrix.determinant() < 0;
}

/// Joint matrices of glTF 2.0, section 3.7.3, at the transforms that the file gives its nodes.
std::vector<Matrix4> jointMatrices(const Input& input, const tinygltf::Model& model,
                                   const GltfNodes& nodes, GltfAccessors& accessors, int skin) {
  if (skin < 0 || static_cast<std::size_t>(skin) >= model.skins.size()) {
    failGltf(input, fmt::format("skin {} does not exist", skin));
  }
  const tinygltf::Skin& of = model.skins[static_cast<std::size_t>(skin)];
  std::vector<float> inverse;
  if (of.inverseBindMatrices != -1) {
    inverse = accessors.floats(of.inverseBindMatrices, 16);
    if (inverse.size() / 16 < of.joints.size()) {
      failGltf(input, fmt::format("skin {} has fewer inverse bind matrices than joints", skin));
    }
  }
  std::vector<Matrix4> matrices;
  for (std::size_t j = 0; j < of.joints.size(); ++j) {
    if (of.joints[j] < 0 || static_cast<std::size_t>(of.joints[j]) >= nodes.world.size()) {
      failGltf(input, fmt::format("skin {} names a joint that does not exist", skin));
    }
    const Matrix4& world = nodes.world[static_cast<std::size_t>(of.joints[j])];
    matrices.push_back(inverse.empty()
                           ? world
                           : world * matrixFromColumns(std::span(inverse).subspan(16 * j, 16)));
  }
  return matrices;
}

/// One set of four joints and weights per vertex; there may be several sets.
struct Influences {
  std::vector<std::uint32_t> joints;
  std::vector<float> weights;
};

std::vector<Influences> influencesOf(const Input& input, GltfAccessors& accessors,
                                     const tinygltf::Primitive& primitive, std::size_t vertices,
                                     std::size_t jointCount) {
  std::vector<Influences> sets;
  for (int set = 0; set < 16; ++set) {
    const auto joints = attribute(primitive.attributes, fmt::format("JOINTS_{}", set).c_str());
    const auto weights = attribute(primitive.attributes, fmt::format("WEIGHTS_{}", set).c_str());
    if (!joints || !weights) break;
    sets.push_back(
        {accessors.integers(*joints, 4, vertices), accessors.floats(*weights, 4, vertices)});
    for (std::size_t i = 0; i < sets.back().joints.size(); ++i) {
      const float weight = sets.back().weights[i];
      if (!(weight >= 0 && std::isfinite(weight))) sets.back().weights[i] = 0;
      if (sets.back().weights[i] > 0 && sets.back().joints[i] >= jointCount) {
        failGltf(input, fmt::format("a vertex names joint {}, but its skin has {} joints",
                                    sets.back().joints[i], jointCount));
      }
    }
  }
  return sets;
}

/// Weights are brought to a sum of 1; vertices without any stay with the first joint.
void skinBy(const std::vector<Matrix4>& matrices, const std::vector<Influences>& sets,
            Draft& draft) {
  std::size_t mirrored = 0;
  for (std::size_t v = 0; v < draft.positions.size(); ++v) {
    Matrix4 blended{{Double3{}, Double3{}, Double3{}, Double3{}}};
    double sum = 0;
    const auto add = [&](double weight, const Matrix4& matrix) {
      for (std::size_t c = 0; c < 4; ++c) {
        blended.column[c] = blended.column[c] + weight * matrix.column[c];
      }
      sum += weight;
    };
    for (const Influences& set : sets) {
      for (std::size_t i = 4 * v; i < 4 * v + 4; ++i) {
        if (set.weights[i] > 0) add(double{set.weights[i]}, matrices[set.joints[i]]);
      }
    }
    if (!(sum > 0)) add(1, matrices[0]);
    for (Double3& column : blended.column) column = (1 / sum) * column;
    draft.positions[v] = blended.point(draft.positions[v]);
    if (!draft.normals.empty()) draft.normals[v] = blended.normal(draft.normals[v]);
    mirrored += blended.determinant() < 0 ? 1U : 0U;
  }
  draft.mirrored = 2 * mirrored > draft.positions.size();
}

Vec3 unit(const Double3& v) {
  const double size = length(v);
  return size > 0 && isFinite(v) ? toFloat((1 / size) * v) : Vec3{0, 0, 0};
}

/// glTF 2.0, section 3.7.2.1: without normals every triangle is flat, so it gets vertices of its
/// own. Vertices that no triangle names stay, to be counted.
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
        unit(areaVector(draft.positions[t[0]], draft.positions[t[1]], draft.positions[t[2]]));
    Triangle own{};
    for (std::size_t c = 0; c < 3; ++c) {
      own[c] = static_cast<std::uint32_t>(mesh.positions.size());
      mesh.positions.push_back(toFloat(draft.positions[t[c]]));
      mesh.normals.push_back(normal);
    }
    mesh.triangles.push_back(own);
  }
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (used[v]) continue;
    mesh.positions.push_back(toFloat(draft.positions[v]));
    mesh.normals.push_back({0, 0, 1});
  }
  mesh.tags.resize(mesh.positions.size());
  std::iota(mesh.tags.begin(), mesh.tags.end(), std::uint64_t{0});
  return mesh;
}

RawMesh smoothMesh(const Draft& draft) {
  RawMesh mesh;
  mesh.positions.reserve(draft.positions.size());
  mesh.normals.reserve(draft.positions.size());
  for (const Double3& p : draft.positions) mesh.positions.push_back(toFloat(p));
  for (const Double3& n : draft.normals) mesh.normals.push_back(unit(n));
  mesh.tags = draft.tags;
  mesh.triangles = draft.triangles;
  return mesh;
}

}  // namespace

bool isSurface(const tinygltf::Primitive& primitive) {
  return primitive.mode == TINYGLTF_MODE_TRIANGLES ||
         primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP ||
         primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN;
}

RawMesh bakePrimitive(const Input& input, const tinygltf::Model& model, const GltfNodes& nodes,
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
  morph(model, accessors, node, primitive, draft);
  const bool flat = draft.normals.empty();
  if (!flat) draft.tags = tagsOf(model, accessors, primitive, vertices);

  std::vector<Matrix4> joints;
  std::vector<Influences> influences;
  if (node.skin != -1) {
    joints = jointMatrices(input, model, nodes, accessors, node.skin);
    influences = influencesOf(input, accessors, primitive, vertices, joints.size());
  }
  if (joints.empty() || influences.empty()) {
    transformBy(nodes.world[nodeIndex], draft);
  } else {
    skinBy(joints, influences, draft);
  }
  if (draft.mirrored) {
    for (Triangle& t : draft.triangles) std::swap(t[1], t[2]);
  }
  return flat ? flatMesh(draft) : smoothMesh(draft);
}

}  // namespace opaline::scene
