#include "renderer/scene_tables.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numbers>

#include "atlas/geodesic.h"
#include "bssrdf/fresnel.h"
#include "bssrdf/profile.h"
#include "environment/spherical_harmonics.h"
#include "gpu/device.h"
#include "gpu/transfer.h"
#include "passes/gather/ambient_cube.h"
#include "passes/shade/specular_albedo.h"
#include "shaders/profile_packing.h"
#include "shaders/shared/frame.h"
#include "shaders/shared/medium.h"

namespace opaline {

namespace {

std::array<bssrdf::Profile, 3> profilesOf(const Medium& medium, Transport transport) {
  const bssrdf::Model model =
      transport == Transport::Dipole ? bssrdf::Model::Dipole : bssrdf::Model::BetterDipole;
  return {bssrdf::makeProfile(model, bssrdf::coefficients(medium, 0)),
          bssrdf::makeProfile(model, bssrdf::coefficients(medium, 1)),
          bssrdf::makeProfile(model, bssrdf::coefficients(medium, 2))};
}

// Radiance per exitance but for the Fresnel factor: Eq. 5 to the letter for the classic dipole,
// d'Eon's energy-conserving exit for the better one.
double exitFactor(const Medium& medium, Transport transport) {
  if (transport == Transport::Dipole) return std::numbers::inv_pi;
  return std::numbers::inv_pi / bssrdf::meanTransmittance(medium.eta);
}

std::vector<double> differentEtas(const std::vector<Medium>& media) {
  std::vector<double> etas;
  for (const Medium& medium : media)
    if (std::find(etas.begin(), etas.end(), medium.eta) == etas.end()) etas.push_back(medium.eta);
  return etas;
}

double texelEdgeMm(const SceneResources& resources, const RenderOptions& options) {
  return resources.atlas.mmPerUnit / options.dsmSize;
}

// Area of the smallest object of a medium.
double smallestAreaMm2(const SceneResources& resources, std::size_t medium) {
  double smallest = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < resources.objects; ++i)
    if (resources.mediumOfObject[i] == medium)
      smallest = std::min(smallest, resources.areaOfObjectMm2[i]);
  return smallest;
}

// Collects the tables of all media.
class TableBuilder {
 public:
  TableBuilder(const SceneResources& resources, const PatternLayout& pattern,
               const RenderOptions& options)
      : options_(options),
        texelMm_(texelEdgeMm(resources, options)),
        etas_(differentEtas(resources.media)) {
    for (const double eta : etas_) {
      const std::vector<float> entries = passes::specularAlbedo(eta, static_cast<double>(options.roughness));
      albedo_.insert(albedo_.end(), entries.begin(), entries.end());
    }
    for (std::size_t i = 0; i < resources.media.size(); ++i)
      add(resources.media[i], pattern.extentOfMedium[i]);
  }

  const std::vector<double>& etas() const { return etas_; }
  const std::vector<shared::MediumData>& media() const { return media_; }
  const std::vector<shared::PatternEntry>& pattern() const { return pattern_; }
  const std::vector<float>& albedo() const { return albedo_; }

 private:
  void add(const Medium& medium, const passes::PatternExtent& extent) {
    const std::array<bssrdf::Profile, 3> profiles = profilesOf(medium, options_.transport);
    const passes::PatternMask mask = passes::makePatternMask(profiles, extent, texelMm_);
    const auto eta = static_cast<std::uint32_t>(
        std::find(etas_.begin(), etas_.end(), medium.eta) - etas_.begin());
    media_.push_back({.profile = shaders::packProfile(profiles),
                      .boundary = {static_cast<float>(medium.eta),
                                   static_cast<float>(exitFactor(medium, options_.transport)),
                                   static_cast<float>(mask.nearSquareMm2),
                                   static_cast<float>(mask.farSquareMm2)},
                      .tables = {eta, static_cast<std::uint32_t>(pattern_.size()), mask.nearSamples,
                                 eta * passes::specularAlbedoEntries}});
    pattern_.insert(pattern_.end(), mask.entries.begin(), mask.entries.end());
  }

  const RenderOptions& options_;
  double texelMm_;
  std::vector<double> etas_;
  std::vector<shared::MediumData> media_;
  std::vector<shared::PatternEntry> pattern_;
  std::vector<float> albedo_;
};

std::vector<shared::ObjectData> makeObjects(const SceneResources& resources,
                                            const std::vector<std::uint32_t>& first) {
  std::vector<shared::ObjectData> objects(resources.objects);
  for (std::size_t i = 0; i < objects.size(); ++i)
    objects[i].table = {resources.mediumOfObject[i], first[i], first[i + 1] - first[i], 0};
  return objects;
}

ShCoefficients ambientRadiance(const Lighting& lighting) {
  ShCoefficients sum = projectUniform(lighting.ambient);
  if (!lighting.environment) return sum;
  const ShCoefficients environment = projectEnvironment(*lighting.environment);
  for (std::size_t i = 0; i < sum.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) sum[i][c] += environment[i][c];
  return sum;
}

// Where the far samples of every vertex lie among the cells.
std::vector<Vec2> farPlaces(const SceneResources& resources, const PatternLayout& layout,
                            const RenderOptions& options) {
  const atlas::Atlas& atlas = resources.atlas;
  const atlas::Neighbourhoods& cells = layout.maps.distant;
  std::vector<double> distanceMm(resources.merged.positions.size(), 0);
  for (std::size_t t = 0; t < resources.merged.triangles.size(); ++t) {
    const std::uint32_t medium = resources.mediumOfObject[resources.merged.objectOfTriangle[t]];
    for (const std::uint32_t vertex : resources.merged.triangles[t])
      distanceMm[vertex] =
          layout.extentOfMedium[medium].distance * texelEdgeMm(resources, options);
  }
  std::vector<Vec2> places;
  places.reserve(8 * distanceMm.size());
  for (const atlas::GeodesicStar& star :
       atlas::walkFromVertices(resources.merged.surface(), distanceMm))
    for (const atlas::SurfacePoint& point : star) {
      Vec2 place{-1, -1};
      if (point.triangle != atlas::SurfacePoint::nowhere) {
        const std::array<int, 2>& shift = cells.shiftOfChart[atlas.chartOfTriangle[point.triangle]];
        for (std::size_t axis = 0; axis < 2; ++axis) {
          float uv = 0;
          for (std::size_t i = 0; i < 3; ++i)
            uv += point.barycentric[i] *
                  atlas.vertices[atlas.triangles[point.triangle][i]].uv[axis];
          place[axis] = (uv * static_cast<float>(options.dsmSize) + static_cast<float>(shift[axis])) /
                        static_cast<float>(cells.size);
        }
      }
      places.push_back(place);
    }
  return places;
}

}  // namespace

PatternLayout layOutPattern(const SceneResources& resources, const RenderOptions& options) {
  // Aprons take room: where they would need more than this, the pattern shrinks.
  const int largestNear = std::max(2 * options.dsmSize, 1024);
  const int largestFar = std::max(4 * options.dsmSize, 2048);
  const double texelMm = texelEdgeMm(resources, options);
  PatternLayout layout;
  int nearReach = 1;
  int cellReach = 1;
  int cell = options.dsmSize;
  for (std::size_t i = 0; i < resources.media.size(); ++i) {
    const double freePathMm = shortestMeanFreePathMm(resources.media[i]);
    const passes::PatternExtent extent = passes::patternExtent(
        {.nearRings = options.pattern.nearRings,
         .nearSpacingMm = static_cast<double>(options.pattern.nearSpacing) * freePathMm,
         .farDistanceMm = static_cast<double>(options.pattern.farDistance) * freePathMm},
        texelMm, smallestAreaMm2(resources, i));
    layout.extentOfMedium.push_back(extent);
    nearReach = std::max(nearReach, extent.nearReach());
    cellReach = std::max(cellReach, extent.cellReach());
    cell = std::min(cell, extent.cell);
  }
  const atlas::Surface surface = resources.merged.surface();
  layout.maps.nearby = atlas::makeNeighbourhoods(
      surface, resources.atlas,
      {.mapSize = options.dsmSize, .reach = nearReach, .alignment = 1, .maxSize = largestNear});
  layout.maps.distant = atlas::makeNeighbourhoods(
      surface, resources.atlas,
      {.mapSize = options.dsmSize, .reach = cellReach, .alignment = cell, .maxSize = largestFar});
  layout.maps.cellEdge = static_cast<std::uint32_t>(cell);
  for (passes::PatternExtent& extent : layout.extentOfMedium)
    extent = passes::fitted(extent, layout.maps.nearby.reach);
  layout.maps.farPlaces = farPlaces(resources, layout, options);
  return layout;
}

passes::SceneTables makeSceneTables(gpu::Device& device, const SceneResources& resources,
                                    const PatternLayout& pattern,
                                    const std::vector<std::uint32_t>& firstSourceOfObject,
                                    const Lighting& lighting, const RenderOptions& options) {
  const TableBuilder builder(resources, pattern, options);
  constexpr VkBufferUsageFlags storage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
  passes::SceneTables tables;
  tables.objects =
      gpu::makeBuffer(device, "objects", makeObjects(resources, firstSourceOfObject), storage);
  tables.media = gpu::makeBuffer(device, "media", builder.media(), storage);
  tables.pattern = gpu::makeBuffer(device, "pattern", builder.pattern(), storage);
  tables.specularAlbedo = gpu::makeBuffer(device, "specular albedo", builder.albedo(), storage);
  tables.ambientCubes =
      passes::makeAmbientCubes(device, ambientRadiance(lighting), builder.etas());
  return tables;
}

}  // namespace opaline
