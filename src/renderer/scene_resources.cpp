#include "renderer/scene_resources.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "bssrdf/profile.h"
#include "gpu/device.h"
#include "gpu/transfer.h"
#include "shaders/shared/mesh.h"

namespace opaline {

namespace {

std::vector<shared::AtlasCorner> makeCorners(const atlas::Atlas& atlas,
                                             const scene::MergedMesh& mesh) {
  std::vector<shared::AtlasCorner> corners(atlas.vertices.size());
  for (std::size_t i = 0; i < corners.size(); ++i)
    corners[i] = {.vertex = atlas.vertices[i].vertex,
                  .u = atlas.vertices[i].uv[0],
                  .v = atlas.vertices[i].uv[1]};
  for (std::size_t t = 0; t < atlas.triangles.size(); ++t)
    for (const std::uint32_t corner : atlas.triangles[t]) {
      corners[corner].object = mesh.objectOfTriangle[t];
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

double meanEdgeMm(const Mesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3& a = mesh.positionsMm[t[i]];
      const Vec3& b = mesh.positionsMm[t[(i + 1) % 3]];
      sum += std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    }
  return mesh.triangles.empty() ? 0 : sum / (3.0 * static_cast<double>(mesh.triangles.size()));
}

double areaMm2(const Mesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    const glm::dvec3 a = glm::make_vec3(mesh.positionsMm[t[0]].data());
    const glm::dvec3 b = glm::make_vec3(mesh.positionsMm[t[1]].data());
    const glm::dvec3 c = glm::make_vec3(mesh.positionsMm[t[2]].data());
    sum += 0.5 * glm::length(glm::cross(b - a, c - a));
  }
  return sum;
}

bool same(const Medium& a, const Medium& b) {
  return a.sigmaSPrimePerMm == b.sigmaSPrimePerMm && a.sigmaAPerMm == b.sigmaAPerMm &&
         a.eta == b.eta;
}

void listMedia(const Scene& scene, SceneResources& resources) {
  for (const Object& object : scene.objects) {
    auto found = std::find_if(resources.media.begin(), resources.media.end(),
                              [&](const Medium& medium) { return same(medium, object.medium); });
    if (found == resources.media.end()) found = resources.media.insert(found, object.medium);
    resources.mediumOfObject.push_back(static_cast<std::uint32_t>(found - resources.media.begin()));
    resources.meanEdgeOfObjectMm.push_back(meanEdgeMm(object.mesh));
    resources.areaOfObjectMm2.push_back(areaMm2(object.mesh));
  }
}

}  // namespace

atlas::Surface surfaceOf(const scene::MergedMesh& merged) {
  return {.positionsMm = merged.positionsMm,
          .triangles = merged.triangles,
          .objectOfTriangle = merged.objectOfTriangle};
}

double shortestMeanFreePathMm(const Medium& medium) {
  double shortest = bssrdf::coefficients(medium, 0).meanFreePathMm;
  for (int channel = 1; channel < 3; ++channel)
    shortest = std::min(shortest, bssrdf::coefficients(medium, channel).meanFreePathMm);
  return shortest;
}

SceneResources makeSceneResources(gpu::Device& device, const Scene& scene,
                                  const scene::MergedMesh& merged, int dsmSize) {
  SceneResources resources;
  resources.merged = &merged;
  resources.atlas = atlas::makeAtlas(surfaceOf(merged), {.mapSize = dsmSize});
  const atlas::Atlas& atlas = resources.atlas;
  const std::vector<shared::AtlasCorner> corners = makeCorners(atlas, merged);

  constexpr VkBufferUsageFlags storage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
  const std::size_t vectorBytes = merged.positionsMm.size() * sizeof(glm::vec4);
  resources.mesh.positions =
      gpu::Buffer(device, {.name = "positions", .bytes = vectorBytes, .usage = storage});
  resources.mesh.normals =
      gpu::Buffer(device, {.name = "normals", .bytes = vectorBytes, .usage = storage});
  resources.mesh.bounds =
      gpu::Buffer(device, {.name = "bounds", .bytes = 6 * sizeof(std::uint32_t), .usage = storage});
  resources.mesh.corners = gpu::makeBuffer(device, "atlas corners", corners, storage);
  resources.mesh.vertexCorners =
      gpu::makeBuffer(device, "atlas corner of each vertex",
                      cornerOfVertex(corners, merged.positionsMm.size()), storage);
  resources.mesh.indices =
      gpu::makeBuffer(device, "indices", atlas.triangles, VK_BUFFER_USAGE_INDEX_BUFFER_BIT);
  resources.mesh.vertexCount = static_cast<std::uint32_t>(merged.positionsMm.size());
  resources.mesh.indexCount = static_cast<std::uint32_t>(3 * atlas.triangles.size());
  resources.objects = static_cast<std::uint32_t>(scene.objects.size());
  resources.triangles = static_cast<std::uint32_t>(merged.triangles.size());
  listMedia(scene, resources);
  return resources;
}

}  // namespace opaline
