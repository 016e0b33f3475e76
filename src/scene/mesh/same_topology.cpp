#include "scene/mesh/same_topology.h"

#include <fmt/format.h>

#include "opaline/error.h"
#include "scene/hash.h"

namespace opaline::scene {

FaceList faceListOf(const RawMesh& mesh) {
  FaceList list{mesh.positions.size(), mesh.polygons, mesh.polygonHash};
  if (mesh.polygons > 0) return list;
  list.faces = mesh.triangles.size() + mesh.badPolygons;
  for (const Triangle& t : mesh.triangles) {
    mix(list.hash, t.size());
    for (const std::uint32_t v : t) mix(list.hash, v);
  }
  return list;
}

std::string differenceOf(const FaceList& first, const FaceList& second) {
  if (first.vertices != second.vertices) {
    return fmt::format("{} vertices against {}", first.vertices, second.vertices);
  }
  if (first.faces != second.faces) {
    return fmt::format("{} faces against {}", first.faces, second.faces);
  }
  return first.hash != second.hash ? "their faces join other vertices" : "";
}

RawObject& onlyStillObject(RawScene& scene, const std::string& file, const std::string& use) {
  if (scene.objects.size() != 1) {
    throw Error(fmt::format("{}: {} needs a file of one object, but it has {}", file, use,
                            scene.objects.size()));
  }
  if (scene.objects[0].rig || !scene.clips.empty()) {
    throw Error(fmt::format("{}: {} needs a model without animation", file, use));
  }
  return scene.objects[0];
}

}  // namespace opaline::scene
