#include "scene/mesh/bodies.h"

#include <algorithm>
#include <cstddef>
#include <span>

#include "core/disjoint_sets.h"
#include "scene/mesh/insides.h"
#include "scene/repair/topology.h"

namespace opaline::scene {

namespace {

bool mayHangTogether(const Object& object) {
  return !object.opaque && !object.isGround;
}

}  // namespace

void append(const Mesh& mesh, std::vector<Vec3>& positionsMm, std::vector<Triangle>& triangles) {
  const auto base = static_cast<std::uint32_t>(positionsMm.size());
  positionsMm.insert(positionsMm.end(), mesh.positionsMm.begin(), mesh.positionsMm.end());
  for (const Triangle& t : mesh.triangles)
    triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
}

std::vector<std::uint32_t> bodyOfObjects(const Scene& scene) {
  const std::vector<Object>& objects = scene.objects;
  core::DisjointSets bodies(objects.size());
  if (std::count_if(objects.begin(), objects.end(), mayHangTogether) > 1) {
    Mesh all;
    std::vector<std::uint32_t> objectOfTriangle;
    for (std::uint32_t i = 0; i < objects.size(); ++i) {
      if (!mayHangTogether(objects[i])) continue;
      append(objects[i].mesh, all.positionsMm, all.triangles);
      objectOfTriangle.resize(all.triangles.size(), i);
    }
    const std::vector<Triangle> surface =
        renamed(all.triangles, sewn(all.positionsMm, all.triangles));
    const std::vector<HalfEdge> edges = sortedHalfEdges(surface);
    forEachEdge(edges, [&](std::span<const HalfEdge> edge) {
      if (edge.size() == 2 && edge[0].forward != edge[1].forward)
        bodies.join(objectOfTriangle[edge[0].triangle], objectOfTriangle[edge[1].triangle]);
    });
  }
  std::vector<std::uint32_t> bodyOf(objects.size());
  std::uint32_t count = 0;
  for (std::uint32_t i = 0; i < objects.size(); ++i) {
    const std::uint32_t first = bodies.find(i);
    bodyOf[i] = first == i ? count++ : bodyOf[first];
  }
  return bodyOf;
}

std::vector<Mesh> meshesOfBodies(const Scene& scene,
                                 const std::vector<std::uint32_t>& bodyOfObject) {
  std::vector<Mesh> bodies;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    if (bodyOfObject[i] == bodies.size()) bodies.emplace_back();
    Mesh& body = bodies[bodyOfObject[i]];
    append(scene.objects[i].mesh, body.positionsMm, body.triangles);
  }
  return bodies;
}

std::vector<std::vector<bool>> insideOfObjects(const Scene& scene,
                                               const std::vector<std::uint32_t>& bodyOfObject) {
  std::vector<std::vector<bool>> ofBodies;
  for (const Mesh& mesh : meshesOfBodies(scene, bodyOfObject))
    ofBodies.push_back(trianglesWithInside(mesh.positionsMm, mesh.triangles));
  std::vector<std::ptrdiff_t> seen(ofBodies.size(), 0);  // triangles
  std::vector<std::vector<bool>> ofObjects;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const std::uint32_t body = bodyOfObject[i];
    const auto first = ofBodies[body].begin() + seen[body];
    seen[body] += static_cast<std::ptrdiff_t>(scene.objects[i].mesh.triangles.size());
    ofObjects.emplace_back(first, ofBodies[body].begin() + seen[body]);
  }
  return ofObjects;
}

}  // namespace opaline::scene
