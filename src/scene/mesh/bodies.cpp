#include "scene/mesh/bodies.h"

#include <algorithm>
#include <cstddef>
#include <span>

#include "scene/repair/topology.h"

namespace opaline::scene {

namespace {

bool mayHangTogether(const Object& object) {
  return !object.opaque && !object.isGround;
}

void append(const Mesh& mesh, Mesh& all) {
  const auto base = static_cast<std::uint32_t>(all.positionsMm.size());
  all.positionsMm.insert(all.positionsMm.end(), mesh.positionsMm.begin(), mesh.positionsMm.end());
  for (const Triangle& t : mesh.triangles)
    all.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
}

}  // namespace

std::vector<std::uint32_t> bodyOfObjects(const Scene& scene) {
  const std::vector<Object>& objects = scene.objects;
  DisjointSets bodies(objects.size());
  if (std::count_if(objects.begin(), objects.end(), mayHangTogether) > 1) {
    Mesh all;
    std::vector<std::uint32_t> objectOfTriangle;
    for (std::uint32_t i = 0; i < objects.size(); ++i) {
      if (!mayHangTogether(objects[i])) continue;
      append(objects[i].mesh, all);
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
    append(scene.objects[i].mesh, bodies[bodyOfObject[i]]);
  }
  return bodies;
}

}  // namespace opaline::scene
