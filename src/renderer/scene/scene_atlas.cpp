#include "opaline/atlas.h"
#include "opaline/error.h"
#include "paper/atlas/atlas.h"
#include "scene/mesh/merged_mesh.h"

namespace opaline {

Atlas makeAtlas(const Scene& scene, const AtlasOptions& options) {
  if (options.mapSize < 64 || options.mapSize > 4096 || options.gutter < 1 || options.gutter > 16) {
    throw UsageError("An atlas needs a map of 64 to 4096 texels with a gutter of 1 to 16.");
  }
  for (const Object& object : scene.objects)
    scene::requireSound(object.mesh.positionsMm, object.mesh.triangles);
  const scene::MergedMesh merged = scene::mergedMesh(scene);
  return atlas::makeAtlas(scene::surfaceOf(merged), options);
}

}  // namespace opaline
