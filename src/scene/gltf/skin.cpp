#include "scene/gltf/skin.h"

#include <fmt/format.h>

#include <cmath>
#include <span>

namespace opaline::scene {

namespace {

std::vector<GltfJoint> readJoints(const Input& input, const tinygltf::Model& model,
                                  GltfAccessors& accessors, int skin) {
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
  accessors.spend(16 * of.joints.size());
  std::vector<GltfJoint> joints;
  for (std::size_t j = 0; j < of.joints.size(); ++j) {
    if (of.joints[j] < 0 || static_cast<std::size_t>(of.joints[j]) >= model.nodes.size()) {
      failGltf(input, fmt::format("skin {} names a joint that does not exist", skin));
    }
    GltfJoint joint{static_cast<std::size_t>(of.joints[j]), {}};
    if (!inverse.empty()) {
      joint.inverseBind = matrixFromColumns(std::span(inverse).subspan(16 * j, 16));
    }
    joints.push_back(joint);
  }
  return joints;
}

/// One set of four joints and weights per vertex.
struct InfluenceSet {
  std::vector<std::uint32_t> joints;
  std::vector<float> weights;
};

std::vector<InfluenceSet> influencesOf(const Input& input, GltfAccessors& accessors,
                                       const tinygltf::Primitive& primitive, std::size_t vertices,
                                       std::size_t jointCount) {
  std::vector<InfluenceSet> sets;
  for (int set = 0; set < 16; ++set) {
    const auto joints = attribute(primitive.attributes, fmt::format("JOINTS_{}", set));
    const auto weights = attribute(primitive.attributes, fmt::format("WEIGHTS_{}", set));
    if (!joints || !weights) break;
    sets.push_back(
        {accessors.integers(*joints, 4, vertices), accessors.floats(*weights, 4, vertices)});
    for (std::size_t i = 0; i < sets.back().joints.size(); ++i) {
      float& weight = sets.back().weights[i];
      if (!(weight >= 0 && std::isfinite(weight))) weight = 0;
      if (weight > 0 && sets.back().joints[i] >= jointCount) {
        failGltf(input, fmt::format("a vertex names joint {}, but its skin has {} joints",
                                    sets.back().joints[i], jointCount));
      }
    }
  }
  return sets;
}

}  // namespace

GltfSkin readSkin(const Input& input, const tinygltf::Model& model, GltfAccessors& accessors,
                  int skin, const tinygltf::Primitive& primitive, std::size_t vertices) {
  GltfSkin result;
  result.joints = readJoints(input, model, accessors, skin);
  const std::vector<InfluenceSet> sets =
      influencesOf(input, accessors, primitive, vertices, result.joints.size());
  if (sets.empty()) return result;
  result.firstInfluence.push_back(0);
  for (std::size_t v = 0; v < vertices; ++v) {
    double sum = 0;
    for (const InfluenceSet& set : sets) {
      for (std::size_t i = 4 * v; i < 4 * v + 4; ++i) {
        if (!(set.weights[i] > 0)) continue;
        result.influences.push_back({set.joints[i], set.weights[i]});
        sum += double{set.weights[i]};
      }
    }
    const std::size_t first = result.firstInfluence.back();
    if (result.influences.size() == first) {
      result.influences.push_back({0, 1});
      sum = 1;
    }
    for (std::size_t i = first; i < result.influences.size(); ++i) {
      float& weight = result.influences[i].weight;
      weight = static_cast<float>(double{weight} / sum);
    }
    result.firstInfluence.push_back(static_cast<std::uint32_t>(result.influences.size()));
  }
  return result;
}

void skinBy(const GltfSkin& skin, const GltfNodes& nodes, Draft& draft) {
  std::vector<Matrix4> matrices;
  for (const GltfJoint& joint : skin.joints) {
    matrices.push_back(nodes.world[joint.node] * joint.inverseBind);
  }
  std::size_t mirrored = 0;
  for (std::size_t v = 0; v < draft.positions.size(); ++v) {
    MatrixSum sum;
    for (std::size_t i = skin.firstInfluence[v]; i < skin.firstInfluence[v + 1]; ++i) {
      sum.add(double{skin.influences[i].weight}, matrices[skin.influences[i].joint]);
    }
    const Matrix4 map = sum.mean();
    draft.positions[v] = map.point(draft.positions[v]);
    if (!draft.normals.empty()) draft.normals[v] = map.normal(draft.normals[v]);
    mirrored += map.determinant() < 0 ? 1U : 0U;
  }
  draft.mirrored = 2 * mirrored > draft.positions.size();
}

}  // namespace opaline::scene
