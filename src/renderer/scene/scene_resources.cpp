#include "renderer/scene/scene_resources.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "bssrdf/profile.h"
#include "gpu/device.h"
#include "gpu/transfer.h"
#include "passes/boundary/clusters.h"
#include "passes/boundary/ray_pass.h"
#include "passes/boundary/solver_pass.h"
#include "passes/gather/surfel_pass.h"
#include "passes/mechanics.h"
#include "renderer/scene/device_room.h"
#include "renderer/scene/opaque_tables.h"
#include "scene/changes.h"
#include "shaders/shared/surfels.h"
#include "surfels/surfels.h"

namespace opaline {

namespace {

std::vector<std::uint32_t> objectsOfVertices(const scene::MergedMesh& mesh) {
  std::vector<std::uint32_t> objects(mesh.positionsMm.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (const std::uint32_t vertex : mesh.triangles[t]) objects[vertex] = mesh.objectOfTriangle[t];
  return objects;
}

SizeOfObject sizeOf(const Mesh& mesh) {
  SizeOfObject size;
  for (const Triangle& t : mesh.triangles) {
    const glm::dvec3 a = glm::make_vec3(mesh.positionsMm[t[0]].data());
    const glm::dvec3 b = glm::make_vec3(mesh.positionsMm[t[1]].data());
    const glm::dvec3 c = glm::make_vec3(mesh.positionsMm[t[2]].data());
    const double areaMm2 = 0.5 * glm::length(glm::cross(b - a, c - a));
    const double edgeMm = (glm::length(b - a) + glm::length(c - b) + glm::length(a - c)) / 3;
    size.areaMm2 += areaMm2;
    size.meanEdgeMm += edgeMm;
    size.meanEdgeByAreaMm += areaMm2 * edgeMm;
  }
  if (!mesh.triangles.empty()) size.meanEdgeMm /= static_cast<double>(mesh.triangles.size());
  if (size.areaMm2 > 0) size.meanEdgeByAreaMm /= size.areaMm2;
  return size;
}

bool isMadeOf(const Object& object, const SceneResources& resources, std::size_t medium) {
  const std::optional<OpaqueMaterial>& opaque = resources.opaqueOfMedium[medium];
  if (object.opaque != opaque) return false;
  return opaque || (object.paint == resources.paintOfMedium[medium] &&
                    object.surface == resources.surfaceOfMedium[medium] &&
                    bssrdf::isSameInside(object.medium, resources.media[medium]));
}

// Media that clips change are not shared, since objects of one material may change separately.
void listMedia(const Scene& scene, SceneResources& resources) {
  resources.media.clear();
  resources.mediaInClips.clear();
  resources.opaqueOfMedium.clear();
  resources.paintOfMedium.clear();
  resources.surfaceOfMedium.clear();
  resources.materialOfMedium.clear();
  resources.mediumOfObject.clear();
  resources.letsLightThrough.clear();
  std::vector<bool> shared;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Object& object = scene.objects[i];
    resources.letsLightThrough.push_back(scene::letsLightThrough(scene, i));
    const bool alone = scene::changesMaterial(scene, i);
    std::uint32_t found = 0;
    const auto end = static_cast<std::uint32_t>(resources.media.size());
    while (found < end && (alone || !shared[found] || !isMadeOf(object, resources, found))) ++found;
    if (found == end) {
      resources.media.push_back(scene::finestMedium(scene, i));
      resources.opaqueOfMedium.push_back(object.opaque);
      resources.paintOfMedium.push_back(isPainted(object) ? object.paint : std::nullopt);
      resources.surfaceOfMedium.push_back(hasOwnSurface(object) ? object.surface : std::nullopt);
      resources.materialOfMedium.push_back(resources.materialOfObject[i]);
      shared.push_back(!alone);
      scene::forEachMediumOf(
          scene, i, [&](const Medium& medium) { resources.mediaInClips.push_back(medium); });
    }
    resources.mediumOfObject.push_back(found);
  }
}

void listMaterials(const Scene& scene, SceneResources& resources) {
  std::vector<OpaqueMaterial>& materials = resources.materials;
  materials.clear();
  resources.materialOfObject.clear();
  std::vector<bool> shared;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const std::optional<OpaqueMaterial> material = surfaceMaterialOf(scene.objects[i]);
    const bool alone = scene::changesMaterial(scene, i);
    std::size_t found = 0;
    if (material)
      while (found < materials.size() &&
             (alone || !shared[found] || !(materials[found] == *material)))
        ++found;
    if (material && found == materials.size()) {
      materials.push_back(*material);
      shared.push_back(!alone);
    }
    resources.materialOfObject.push_back(static_cast<std::uint32_t>(found));
  }
}

// A ground comes last and does not cast shadows.
std::uint32_t castingTriangles(const Scene& scene) {
  std::size_t triangles = 0;
  for (const Object& object : scene.objects)
    if (!object.isGround) triangles += object.mesh.triangles.size();
  return static_cast<std::uint32_t>(triangles);
}

void measure(const Scene& scene, SceneResources& resources) {
  for (const Object& object : scene.objects) resources.sizeOfObject.push_back(sizeOf(object.mesh));
}

// Objects that follow each other share a range.
void findHoles(const Scene& scene, passes::DeformedMesh& mesh) {
  mesh.cutOut.clear();
  mesh.whole.clear();
  std::uint32_t first = 0;
  for (const Object& object : scene.objects) {
    const auto count = static_cast<std::uint32_t>(3 * object.mesh.triangles.size());
    const bool holes = object.opaque && object.opaque->alphaCutoff > 0;
    std::vector<passes::IndexRange>& ranges = holes ? mesh.cutOut : mesh.whole;
    if (!ranges.empty() && ranges.back().first + ranges.back().count == first)
      ranges.back().count += count;
    else
      ranges.push_back({first, count});
    first += count;
  }
}

void makeMesh(gpu::Device& device, const Scene& scene, SceneResources& resources) {
  const scene::MergedMesh& merged = *resources.merged;
  constexpr VkBufferUsageFlags storage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
  passes::DeformedMesh& mesh = resources.mesh;
  mesh.positions = passes::makeRoom<shared::vec4>(device, "positions", merged.positionsMm.size());
  mesh.normals = passes::makeRoom<shared::vec4>(device, "normals", merged.positionsMm.size());
  mesh.bounds =
      gpu::Buffer(device, {.name = "bounds", .bytes = 6 * sizeof(std::uint32_t), .usage = storage});
  mesh.objectOf =
      gpu::makeBuffer(device, "objects of vertices", objectsOfVertices(merged), storage);
  mesh.indices = gpu::makeBuffer(device, "indices", merged.triangles,
                                 VK_BUFFER_USAGE_INDEX_BUFFER_BIT | storage);
  mesh.vertexCount = static_cast<std::uint32_t>(merged.positionsMm.size());
  mesh.indexCount = static_cast<std::uint32_t>(3 * merged.triangles.size());
  mesh.castingIndexCount = 3 * resources.castingTriangles;
  findHoles(scene, mesh);
}

// The spacing of sources, in mean free paths, from which on sums need NearbyPass. The error of a
// lattice of that spacing is about 2 e^{-2π / this}.
constexpr double coarseInFreePaths = 0.8;

// Surfels may be coarse for a medium if their size follows another one.
void noteSpacing(SceneResources& resources) {
  resources.surfels.coarse = false;
  // Two triangles fill two of a surfel's sources.
  const double sourcesPerSurfel =
      resources.surfels.piecesPerSurfel == 2 ? 2 : shared::sourcesPerSurfel;
  for (std::size_t i = 0; i < resources.objects; ++i) {
    SurfelsOfObject& object = resources.surfelsOfObject[i];
    const double sources = std::max(1.0, sourcesPerSurfel * object.count);
    object.sourceSpacingMm = std::sqrt(object.areaMm2 / sources);
    const Medium& medium = resources.media[resources.mediumOfObject[i]];
    object.coarse =
        !resources.isOpaque(i) &&
        object.sourceSpacingMm > coarseInFreePaths * bssrdf::shortestMeanFreePathMm(medium);
    resources.surfels.coarse = resources.surfels.coarse || object.coarse;
  }
}

std::vector<double> areasOfBodiesMm2(const SceneResources& resources) {
  std::vector<double> areas(resources.merged->firstObjectOfBody.size(), 0);
  for (std::size_t i = 0; i < resources.objects; ++i)
    areas[resources.merged->bodyOfObject[i]] += resources.sizeOfObject[i].areaMm2;
  return areas;
}

// The objects of the triangles of bodies, followed by those of linings.
std::vector<std::uint32_t> objectsOfTriangles(const core::RestSurface& bodies,
                                              const scene::MergedMesh& merged) {
  std::vector<std::uint32_t> objects = merged.objectOfTriangle;
  for (std::size_t t = objects.size(); t < bodies.triangles.size(); ++t)
    objects.push_back(merged.firstObjectOfBody[bodies.objectOfTriangle[t]]);
  return objects;
}

// The roles of the scene's parts and linings in boundary transport.
passes::BodyKinds kindsOf(const SceneResources& resources) {
  passes::BodyKinds kinds;
  kinds.triangleHasInside = resources.insides.triangleHasInside;
  for (std::size_t i = 0; i < resources.objects; ++i)
    kinds.objectIsOpaque.push_back(resources.isOpaque(i));
  if (resources.within.linings.any()) kinds.firstLining = resources.within.linings.firstTriangle();
  return kinds;
}

bool hasNormals(const SceneResources& resources) {
  return std::any_of(resources.surfaceOfMedium.begin(), resources.surfaceOfMedium.end(),
                     [](const auto& own) { return own && own->normalTexture; });
}

void takeClusters(gpu::Device& device, const core::RestSurface& surface, const Division& division,
                  SceneResources& resources) {
  const surfels::ClusterDivision& made = *division.clusters;
  for (std::size_t i = 0; i < resources.objects; ++i) {
    const std::uint32_t body = resources.merged->bodyOfObject[i];
    SurfelsOfObject& object = resources.surfelsOfObject[i];
    object.clusterRoot = made.tree.rootOfObject[body];
    object.clusterEndNode = made.tree.rootOfObject[body + 1];
    object.hasInside = resources.insides.objectHasInside[i];
    if (division.order.clustersOfBody[body].bothSides)
      object.backClusters = (made.firstOfObject[body + 1] - made.firstOfObject[body]) / 2;
  }
  resources.clusters =
      passes::makeClusters(device, made, surface, division.surfels, kindsOf(resources));
  resources.solver =
      passes::SolverPass::makeSolver(device, resources.clusters, RenderOptions::maxBounces + 1);
}

}  // namespace

// Limit for the mean edge weighted by area, in mean free paths. For a fine mesh that stands on a
// coarse floor that is the floor's.
constexpr double longestByArea = 3;

bool wantsVertices(const SceneResources& resources, std::size_t object) {
  // Detail of paint and of normal textures shows only at fragments.
  if (resources.isOpaque(object) || resources.isPainted(object) || resources.hasOwnNormals(object))
    return false;
  const SizeOfObject& size = resources.sizeOfObject[object];
  const double freePathMm =
      bssrdf::shortestMeanFreePathMm(resources.media[resources.mediumOfObject[object]]);
  return size.meanEdgeMm <= freePathMm && size.meanEdgeByAreaMm <= longestByArea * freePathMm;
}

// Mean edge weighted by area, in mean free paths, far beyond what can be interpolated well.
constexpr double loseDetail = 30;

void noteSite(const Scene& scene, const SceneResources& resources, Site site,
              const LogCallback& log) {
  if (site != Site::Vertex || !log) return;
  for (std::size_t i = 0; i < resources.objects; ++i) {
    if (resources.isOpaque(i)) continue;
    const double edgeMm = resources.sizeOfObject[i].meanEdgeByAreaMm;
    const double freePathMm =
        bssrdf::shortestMeanFreePathMm(resources.media[resources.mediumOfObject[i]]);
    if (edgeMm > loseDetail * freePathMm)
      log(LogLevel::Note,
          fmt::format("light on object '{}' is summed at vertices that are about {:.0f} mean free "
                      "paths apart: shadows and detail between them are lost; RenderOptions::site "
                      "auto keeps them",
                      scene.objects[i].name, edgeMm / freePathMm));
  }
}

paper::RestScene restSceneOf(const SceneResources& resources) {
  paper::RestScene rest{
      surfaceOf(*resources.merged), resources.media, resources.mediumOfObject, {}};
  for (const SizeOfObject& size : resources.sizeOfObject)
    rest.areaOfObjectMm2.push_back(size.areaMm2);
  return rest;
}

bool SceneResources::hasInside() const {
  return std::any_of(surfelsOfObject.begin(), surfelsOfObject.end(),
                     [](const SurfelsOfObject& object) { return object.hasInside; });
}

bool SceneResources::isOpaque(std::size_t object) const {
  return opaqueOfMedium[mediumOfObject[object]].has_value();
}

bool SceneResources::anyLetsLightThrough() const {
  return std::find(letsLightThrough.begin(), letsLightThrough.end(), true) !=
         letsLightThrough.end();
}

bool SceneResources::hasOpaque() const {
  return std::any_of(opaqueOfMedium.begin(), opaqueOfMedium.end(),
                     [](const auto& opaque) { return opaque.has_value(); });
}

bool SceneResources::hasOwnNormals(std::size_t object) const {
  const std::optional<TranslucentSurface>& surface = surfaceOfMedium[mediumOfObject[object]];
  return surface && surface->normalTexture;
}

bool SceneResources::isPainted(std::size_t object) const {
  return paintOfMedium[mediumOfObject[object]].has_value();
}

SceneResources makeSceneResources(gpu::Device& device, const Scene& scene,
                                  const scene::MergedMesh& merged, const SceneNeeds& needs,
                                  const LogCallback& log) {
  SceneResources resources;
  resources.merged = &merged;
  resources.needs = needs;
  resources.objects = static_cast<std::uint32_t>(scene.objects.size());
  resources.triangles = static_cast<std::uint32_t>(merged.triangles.size());
  listMaterials(scene, resources);
  listMedia(scene, resources);
  resources.opaque = makeOpaqueTables(device, scene, resources.materials, resources.textures, log,
                                      resources.materialsOnHost);
  measure(scene, resources);
  resources.castingTriangles = castingTriangles(scene);
  if (needs.maxSurfels)
    requireRoom(resources.triangles, roomOf(device.limits()), device.info().name);
  makeMesh(device, scene, resources);
  if (needs.maxClusters) {
    resources.insides = findInsides(scene, merged, log);
    resources.within = findWithin(scene, merged, resources.insides, needs.keepsOverlaps, log);
  }
  if (needs.maxSurfels) {
    const Division division = divide(merged, orderFor(device, scene, resources), resources.within);
    noteCoarseness(division, roomOf(device.limits()), log);
    takeDivision(device, division, resources);
  }
  return resources;
}

void takeMedia(gpu::Device& device, const Scene& scene, SceneResources& resources) {
  const std::vector<OpaqueMaterial> before = std::exchange(resources.materials, {});
  listMaterials(scene, resources);
  listMedia(scene, resources);
  if (resources.materials != before) {
    if (!retakeMaterials(device, scene, resources.materials, resources.textures, resources.opaque,
                         resources.materialsOnHost))
      resources.opaque = makeOpaqueTables(device, scene, resources.materials, resources.textures,
                                          {}, resources.materialsOnHost);
    findHoles(scene, resources.mesh);
  }
  // Normal textures added later need the triangles of surfels.
  if (hasNormals(resources) && !resources.surfels.triangleOfPiece) resources.divided = {};
  if (resources.needs.maxSurfels) noteSpacing(resources);
}

DivisionOrder orderFor(const gpu::Device& device, const Scene& scene,
                       const SceneResources& resources) {
  const DeviceRoom room = roomOf(device.limits());
  const SceneNeeds& needs = resources.needs;
  std::optional<std::size_t> clusters;
  if (needs.maxClusters)
    clusters = std::min(static_cast<std::size_t>(*needs.maxClusters), room.clusters);
  return divisionFor(scene, *resources.merged, resources.insides,
                     std::min(static_cast<std::size_t>(*needs.maxSurfels), room.surfels), clusters);
}

void takeDivision(gpu::Device& device, const Division& division, SceneResources& resources) {
  const scene::MergedMesh& merged = *resources.merged;
  const core::RestSurface bodies = resources.within.linings.lined(scene::bodiesOf(merged));
  const std::vector<std::uint32_t> objects = objectsOfTriangles(bodies, merged);
  const core::RestSurface surface{bodies.positionsMm, bodies.triangles, objects};
  resources.divided = division.order;
  resources.surfels = {};  // freed before memory for the next is allocated
  resources.rays = {};
  resources.clusters = {};
  resources.solver = {};
  resources.surfelsOfObject.assign(resources.objects, {});
  const surfels::SurfelDivision& made = division.surfels;
  const std::vector<double> areaOfBodyMm2 = areasOfBodiesMm2(resources);
  for (std::size_t i = 0; i < resources.objects; ++i) {
    const std::uint32_t body = merged.bodyOfObject[i];
    SurfelsOfObject& object = resources.surfelsOfObject[i];
    object.firstObject = merged.firstObjectOfBody[body];
    object.areaMm2 = areaOfBodyMm2[body];
    object.first = made.firstOfObject[body];
    object.count = made.firstLiningOfObject[body] - object.first;
    object.root = made.tree.rootOfObject[body];
    object.endNode = made.liningRootOfObject[body];
    object.liningEndNode = made.tree.rootOfObject[body + 1];
  }
  resources.surfels = passes::SurfelPass::makeSurfels(device, made, surface, hasNormals(resources),
                                                      resources.within.linings);
  noteSpacing(resources);
  if (division.clusters) takeClusters(device, surface, division, resources);
  if (division.clusters || resources.needs.rays)
    resources.rays = passes::RayPass::makeHierarchy(device, resources.surfels, made, surface,
                                                    merged.firstObjectOfBody);
}

}  // namespace opaline
