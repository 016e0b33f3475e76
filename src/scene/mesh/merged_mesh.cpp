#include "scene/mesh/merged_mesh.h"

#include "scene/mesh/bodies.h"

namespace opaline::scene {

MergedMesh mergedMesh(const Scene& scene) {
  MergedMesh merged;
  merged.bodyOfObject = bodyOfObjects(scene);
  std::uint32_t index = 0;
  for (const Object& object : scene.objects) {
    append(object.mesh, merged.positionsMm, merged.triangles);
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
