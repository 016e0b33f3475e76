#include "paper/flat_scene.h"

#include "gpu/device.h"
#include "gpu/transfer.h"
#include "paper/shaders/shared/atlas.h"

namespace opaline::paper {

namespace {

std::vector<shared::AtlasCorner> makeCorners(const atlas::Atlas& atlas,
                                             const core::RestSurface& surface) {
  std::vector<shared::AtlasCorner> corners(atlas.vertices.size());
  for (std::size_t i = 0; i < corners.size(); ++i)
    corners[i] = {.vertex = atlas.vertices[i].vertex,
                  .u = atlas.vertices[i].uv[0],
                  .v = atlas.vertices[i].uv[1]};
  for (std::size_t t = 0; t < atlas.triangles.size(); ++t)
    for (const std::uint32_t corner : atlas.triangles[t]) {
      corners[corner].object = surface.objectOfTriangle[t];
      corners[corner].chart = atlas.chartOfTriangle[t];
    }
  return corners;
}

// One corner for each vertex: the first of those it has.
std::vector<shared::AtlasCorner> cornerOfVertex(const std::vector<shared::AtlasCorner>& corners,
                                                std::size_t vertices) {
  std::vector<shared::AtlasCorner> chosen(vertices, shared::AtlasCorner{});
  for (auto corner = corners.rbegin(); corner != corners.rend(); ++corner)
    chosen[corner->vertex] = *corner;
  return chosen;
}

}  // namespace

FlatScene makeFlatScene(gpu::Device& device, const core::RestSurface& surface, int mapSize) {
  constexpr VkBufferUsageFlags storage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
  FlatScene flat{.mapSize = mapSize, .atlas = atlas::makeAtlas(surface, {mapSize})};
  const std::vector<shared::AtlasCorner> corners = makeCorners(flat.atlas, surface);
  flat.corners = gpu::makeBuffer(device, "corners", corners, storage);
  flat.vertexCorners =
      gpu::makeBuffer(device, "corner of each vertex",
                      cornerOfVertex(corners, surface.positionsMm.size()), storage);
  flat.indices = gpu::makeBuffer(device, "indices of corners", flat.atlas.triangles,
                                 VK_BUFFER_USAGE_INDEX_BUFFER_BIT | storage);
  flat.indexCount = static_cast<std::uint32_t>(3 * flat.atlas.triangles.size());
  return flat;
}

}  // namespace opaline::paper
