#include "renderer/motion/motion_tables.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include <glm/vec2.hpp>

#include "deform/deformed_vertices.h"
#include "deform/smooth_groups.h"
#include "gpu/device.h"
#include "gpu/transfer.h"
#include "shaders/shared/deform.h"

namespace opaline {

namespace {

std::vector<shared::RestVertex> restVertices(const Scene& scene) {
  std::vector<shared::RestVertex> rest;
  std::uint32_t number = 0;
  for (const Object& object : scene.objects) {
    const std::vector<Vec3>& positions =
        object.rig ? object.rig->positions : object.mesh.positionsMm;
    const std::vector<Vec3>& normals = object.rig ? object.rig->normals : object.mesh.normals;
    for (std::size_t v = 0; v < positions.size(); ++v)
      rest.push_back({.x = positions[v][0],
                      .y = positions[v][1],
                      .z = positions[v][2],
                      .object = number,
                      .normalX = normals[v][0],
                      .normalY = normals[v][1],
                      .normalZ = normals[v][2]});
    ++number;
  }
  return rest;
}

template <typename T>
struct Lists {
  std::vector<std::uint32_t> first{0};
  std::vector<T> entries;

  void close() { first.push_back(static_cast<std::uint32_t>(entries.size())); }
};

// Only deltas that are not 0, vertex after vertex: targets of faces, for example, are mostly zeros.
Lists<shared::MorphDelta> morphDeltas(const Scene& scene, const std::vector<ObjectRange>& ranges) {
  Lists<shared::MorphDelta> lists;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const std::optional<Rig>& rig = scene.objects[i].rig;
    for (std::size_t v = 0; v < ranges[i].vertexCount; ++v) {
      for (std::size_t t = 0; rig && t < rig->targets.size(); ++t) {
        const MorphTarget& target = rig->targets[t];
        const Vec3 p = target.positions.empty() ? Vec3{} : target.positions[v];
        const Vec3 n = target.normals.empty() ? Vec3{} : target.normals[v];
        if (p == Vec3{} && n == Vec3{}) continue;
        lists.entries.push_back({.weight = ranges[i].firstWeight + static_cast<std::uint32_t>(t),
                                 .x = p[0],
                                 .y = p[1],
                                 .z = p[2],
                                 .normalX = n[0],
                                 .normalY = n[1],
                                 .normalZ = n[2]});
      }
      lists.close();
    }
  }
  return lists;
}

// Weights are normalised to a sum of 1. A vertex without weights follows the first joint, as on the
// host.
void addInfluences(const Rig& rig, std::size_t vertex, std::uint32_t firstMatrix,
                   std::vector<shared::JointInfluence>& entries) {
  const auto begin = rig.influences.begin() + rig.firstInfluence[vertex];
  const auto end = rig.influences.begin() + rig.firstInfluence[vertex + 1];
  const float sum = std::accumulate(
      begin, end, 0.0F, [](float so, const Influence& influence) { return so + influence.weight; });
  if (!(sum > 0)) return entries.push_back({firstMatrix, 1});
  for (auto influence = begin; influence != end; ++influence)
    entries.push_back({firstMatrix + influence->joint, influence->weight / sum});
}

// A rig without joints moves with its node, by one influence per vertex.
Lists<shared::JointInfluence> jointInfluences(const Scene& scene,
                                              const std::vector<ObjectRange>& ranges) {
  Lists<shared::JointInfluence> lists;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const std::optional<Rig>& rig = scene.objects[i].rig;
    for (std::size_t v = 0; v < ranges[i].vertexCount; ++v) {
      if (rig && rig->joints.empty()) lists.entries.push_back({ranges[i].firstMatrix, 1});
      if (rig && !rig->joints.empty()) addInfluences(*rig, v, ranges[i].firstMatrix, lists.entries);
      lists.close();
    }
  }
  return lists;
}

std::vector<std::uint32_t> groupsOf(const Scene& scene) {
  std::vector<std::uint32_t> groups;
  for (const Object& object : scene.objects) {
    const auto first = static_cast<std::uint32_t>(groups.size());
    for (const std::uint32_t group : deform::smoothGroups(object.mesh))
      groups.push_back(first + group);
  }
  return groups;
}

struct Edges {
  std::vector<glm::uvec2> range;
  std::vector<shared::TriangleEdge> edges;
};

Edges trianglesAround(const scene::MergedMesh& merged, const std::vector<std::uint32_t>& group) {
  Edges result;
  result.range.resize(group.size(), {0, 0});
  for (const Triangle& t : merged.triangles)
    for (const std::uint32_t v : t) ++result.range[group[v]].y;
  std::uint32_t first = 0;
  for (glm::uvec2& range : result.range) {
    range.x = first;
    first += std::exchange(range.y, 0);
  }
  result.edges.resize(first);
  for (const Triangle& t : merged.triangles)
    for (std::size_t c = 0; c < 3; ++c) {
      glm::uvec2& range = result.range[group[t[c]]];
      result.edges[range.x + range.y++] = {t[(c + 1) % 3], t[(c + 2) % 3]};
    }
  for (std::size_t v = 0; v < group.size(); ++v) result.range[v] = result.range[group[v]];
  return result;
}

template <typename T>
gpu::Buffer table(gpu::Device& device, const char* name, const std::vector<T>& data) {
  return gpu::makeBuffer(device, name, data, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
}

gpu::Buffer room(gpu::Device& device, const char* name, std::size_t bytes,
                 VkBufferUsageFlags usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT) {
  constexpr std::size_t least = 16;  // so that the buffer can always be bound
  return {device, {.name = name, .bytes = std::max(bytes, least), .usage = usage}};
}

}  // namespace

std::vector<ObjectRange> rangesOf(const Scene& scene) {
  std::vector<ObjectRange> ranges;
  ObjectRange next;
  for (const Object& object : scene.objects) {
    next.vertexCount = static_cast<std::uint32_t>(object.mesh.positionsMm.size());
    next.weightCount = object.rig ? static_cast<std::uint32_t>(object.rig->targets.size()) : 0;
    next.matrixCount =
        object.rig ? std::max(static_cast<std::uint32_t>(object.rig->joints.size()), 1U) : 0;
    next.normalsFromMesh = deform::normalsFromTriangles(object);
    ranges.push_back(next);
    next.firstVertex += next.vertexCount;
    next.firstWeight += next.weightCount;
    next.firstMatrix += next.matrixCount;
  }
  return ranges;
}

passes::Motion makeMotionTables(gpu::Device& device, const Scene& scene,
                                const scene::MergedMesh& merged,
                                const std::vector<ObjectRange>& ranges) {
  const Lists<shared::MorphDelta> deltas = morphDeltas(scene, ranges);
  const Lists<shared::JointInfluence> influences = jointInfluences(scene, ranges);
  const Edges around = trianglesAround(merged, groupsOf(scene));
  const ObjectRange& last = ranges.back();

  passes::Motion motion;
  motion.rest = table(device, "rest vertices", restVertices(scene));
  motion.hasDeltas = !deltas.entries.empty();
  motion.firstDelta = table(device, "first morph deltas",
                            motion.hasDeltas ? deltas.first : std::vector<std::uint32_t>{});
  motion.deltas = table(device, "morph deltas", deltas.entries);
  motion.hasInfluences = !influences.entries.empty();
  motion.firstInfluence =
      table(device, "first influences",
            motion.hasInfluences ? influences.first : std::vector<std::uint32_t>{});
  motion.influences = table(device, "influences", influences.entries);
  motion.edgeRange = table(device, "edges around vertices", around.range);
  motion.edges = table(device, "edges", around.edges);
  motion.frame =
      room(device, "deform frame", sizeof(shared::DeformFrame), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
  motion.weights =
      room(device, "morph weights", (last.firstWeight + last.weightCount) * sizeof(float));
  motion.matrices =
      room(device, "joint matrices",
           std::size_t{3} * (last.firstMatrix + last.matrixCount) * sizeof(shared::vec4));
  motion.objects =
      room(device, "motion of objects", scene.objects.size() * sizeof(shared::ObjectMotion));
  motion.replaced = room(device, "no given positions", 0);
  return motion;
}

}  // namespace opaline
