#include "scene/mesh/merged_mesh.h"

#include "scene/mesh/bodies.h"

namespace opaline::scene {

MergedMesh mergedMesh(const Scene& scene) {
  MergedMesh merged;
  merged.bodyOfObject = bodyOfObjects(scene);
  std::uint32_t index = 0;
  for (const Object& object : scene.objects) {
    const auto base = static_cast<std::uint32_t>(merged.positionsMm.size());
    const Mesh& mesh = object.mesh;
    merged.positionsMm.insert(merged.positionsMm.end(), mesh.positionsMm.begin(),
                              mesh.positionsMm.end());
    for (const Triangle& t : mesh.triangles) {
      merged.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
    }
    merged.objectOfTriangle.resize(merged.triangles.size(), index);
    const std::uint32_t body = merged.bodyOfObject[index];
    merged.bodyOfTriangle.resize(merged.triangles.size(), body);
    if (body == merged.firstObjectOfBody.size()) merged.firstObjectOfBody.push_back(index);
    ++index;
  }
  return merged;
}

core::RestSurface surfaceOf(const MergedMesh& merged) {
  return {.positionsMm = merged.positionsMm,
          .triangles = merged.triangles,
          .objectOfTriangle = merged.objectOfTriangle};
}

core::RestSurface bodiesOf(const MergedMesh& merged) {
  return {.positionsMm = merged.positionsMm,
          .triangles = merged.triangles,
          .objectOfTriangle = merged.bodyOfTriangle};
}

}  // namespace opaline::scene
