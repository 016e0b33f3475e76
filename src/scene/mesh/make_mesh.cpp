#include "opaline/mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <utility>

#include "core/disjoint_sets.h"
#include "core/possible_position.h"
#include "opaline/error.h"
#include "scene/mesh/bodies.h"
#include "scene/mesh/insides.h"
#include "scene/mesh/merged_mesh.h"
#include "scene/mesh/normals.h"
#include "scene/repair/topology.h"

namespace opaline {

namespace scene {

void requireSound(std::span<const Vec3> positionsMm, std::span<const Triangle> triangles) {
  for (std::size_t i = 0; i < positionsMm.size(); ++i) {
    const Vec3& p = positionsMm[i];
    if (core::isPossible(p)) continue;
    throw UsageError(fmt::format(
        "The position of vertex {} is ({}, {}, {}); it must be finite and within 1e18 mm.", i, p[0],
        p[1], p[2]));
  }
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (const std::uint32_t vertex : triangles[i]) {
      if (vertex < positionsMm.size()) continue;
      throw UsageError(fmt::format("Triangle {} names vertex {}, but there are {}.", i, vertex,
                                   positionsMm.size()));
    }
  }
}

}  // namespace scene

Mesh makeMesh(std::vector<Vec3> positionsMm, std::vector<Triangle> triangles) {
  scene::requireSound(positionsMm, triangles);
  std::vector<scene::Double3> positions;
  positions.reserve(positionsMm.size());
  for (const Vec3& position : positionsMm) positions.push_back(scene::toDouble(position));
  Mesh mesh;
  mesh.normals.reserve(positions.size());
  for (const scene::Double3& normal : scene::smoothNormals(positions, triangles)) {
    mesh.normals.push_back(scene::toFloat(normal));
  }
  mesh.positionsMm = std::move(positionsMm);
  mesh.triangles = std::move(triangles);
  return mesh;
}

namespace {

// All facts but whether a part has an inside.
MeshFacts bordersAndParts(std::span<const Vec3> positionsMm, std::span<const Triangle> triangles) {
  scene::requireSound(positionsMm, triangles);
  const std::vector<Triangle> surface =
      scene::renamed(triangles, scene::sewn(positionsMm, triangles));
  core::DisjointSets vertices(positionsMm.size());
  for (const Triangle& t : surface) {
    vertices.join(t[0], t[1]);
    vertices.join(t[0], t[2]);
  }
  std::vector<bool> used(positionsMm.size());
  for (const Triangle& t : surface) used[t[0]] = used[t[1]] = used[t[2]] = true;
  MeshFacts facts;
  for (std::uint32_t v = 0; v < used.size(); ++v) {
    if (used[v] && vertices.find(v) == v) ++facts.components;
  }
  const scene::Borders borders = scene::bordersOf(surface, scene::sortedHalfEdges(surface));
  facts.boundaryLoops = borders.loops;
  facts.closed = borders.sides == 0 && !triangles.empty();
  return facts;
}

std::size_t withoutInside(const std::vector<bool>& inside) {
  return static_cast<std::size_t>(std::count(inside.begin(), inside.end(), false));
}

}  // namespace

MeshFacts factsOf(std::span<const Vec3> positionsMm, std::span<const Triangle> triangles) {
  MeshFacts facts = bordersAndParts(positionsMm, triangles);
  facts.trianglesWithoutInside = withoutInside(scene::trianglesWithInside(positionsMm, triangles));
  return facts;
}

std::vector<BodyFacts> bodiesOf(const Scene& scene) {
  for (const Object& object : scene.objects)
    scene::requireSound(object.mesh.positionsMm, object.mesh.triangles);
  const std::vector<std::uint32_t> bodyOf = scene::bodyOfObjects(scene);
  std::vector<BodyFacts> bodies;
  for (const Mesh& mesh : scene::meshesOfBodies(scene, bodyOf))
    bodies.push_back({.surface = bordersAndParts(mesh.positionsMm, mesh.triangles)});
  const std::vector<std::vector<bool>> inside = scene::insideOfObjects(scene, bodyOf);
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    BodyFacts& body = bodies[bodyOf[i]];
    body.objects.push_back(i);
    body.trianglesWithoutInside.push_back(withoutInside(inside[i]));
    body.surface.trianglesWithoutInside += body.trianglesWithoutInside.back();
  }
  return bodies;
}

}  // namespace opaline
