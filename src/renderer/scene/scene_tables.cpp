#include "renderer/scene/scene_tables.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "bssrdf/exit_directions.h"
#include "bssrdf/fresnel.h"
#include "bssrdf/paint.h"
#include "bssrdf/profile.h"
#include "gpu/device.h"
#include "gpu/transfer.h"
#include "lights/fresnel_lobes.h"
#include "lights/reflection_lobe.h"
#include "passes/scatter/nearby_shares.h"
#include "passes/shade/reflected_lights_pass.h"
#include "passes/shade/specular_albedo.h"
#include "shaders/profile_packing.h"
#include "shaders/shared/boundary.h"
#include "shaders/shared/frame.h"
#include "shaders/shared/medium.h"
#include "shaders/shared/nearby.h"
#include "shaders/shared/opaque.h"
#include "shaders/shared/paint.h"

namespace opaline {

namespace {

// The medium's index of refraction; 1 for opaque surfaces, which light does not enter.
double etaOf(const SceneResources& resources, std::size_t medium) {
  return resources.opaqueOfMedium[medium] ? 1 : resources.media[medium].eta;
}

std::vector<double> differentEtas(const SceneResources& resources) {
  std::vector<double> etas;
  for (std::size_t i = 0; i < resources.media.size(); ++i)
    if (const double eta = etaOf(resources, i);
        std::find(etas.begin(), etas.end(), eta) == etas.end())
      etas.push_back(eta);
  return etas;
}

// No light diffuses in it, and all light that falls on it is absorbed.
shared::BoundaryMedium insideOfOpaque() {
  return {.diffusion = {1, 1, 1, 1},
          .sigma = {1, 1, 1, static_cast<float>(bssrdf::meanCosineInside(1))},
          .extinction = {1, 1, 1, 1},
          .albedo = {0, 0, 0, 0},
          .collision = {1, 1, 1, 0},
          .scatters = {0, 0, 0, 0},
          .reflected = {0, 0, 0, 0}};
}

shared::MediumData dataOfOpaque() {
  shared::MediumData data{};
  data.inside = insideOfOpaque();
  data.boundary = {1, 1 / std::numbers::pi_v<float>, 1, 1};
  return data;
}

// The medium for Transport::Boundary: Grosjean's diffusion, as in the better dipole.
shared::BoundaryMedium insideOf(const Medium& medium) {
  const std::array<bssrdf::Profile, 3> profiles =
      bssrdf::makeProfiles(bssrdf::Model::BetterDipole, medium);
  shared::BoundaryMedium inside{};
  for (int c = 0; c < 3; ++c) {
    const bssrdf::Profile& profile = profiles[static_cast<std::size_t>(c)];
    const bssrdf::Coefficients coefficients = bssrdf::coefficients(medium, c);
    inside.diffusion[c] = static_cast<float>(profile.diffusionMm);
    inside.sigma[c] = static_cast<float>(profile.sigmaTrPerMm);
    inside.extinction[c] = static_cast<float>(coefficients.sigmaTPrimePerMm);
    inside.albedo[c] = static_cast<float>(coefficients.albedo);
    const bssrdf::ScaledScattering scaled = bssrdf::scaledScattering(medium, c);
    inside.collision[c] = static_cast<float>(scaled.sigmaTPerMm);
    inside.scatters[c] = static_cast<float>(scaled.albedo);
    inside.reflected[c] = static_cast<float>(profile.totalReflectance());
    inside.collision.w = static_cast<float>(scaled.g);
  }
  const double eta = medium.eta;
  inside.diffusion.w = static_cast<float>((1 + bssrdf::threeC2(eta)) / (1 - bssrdf::twoC1(eta)));
  inside.sigma.w = static_cast<float>(bssrdf::meanCosineInside(eta));
  inside.scatters.w = static_cast<float>(bssrdf::mirroredOfEntered(eta));
  inside.extinction.w = static_cast<float>(bssrdf::meanTransmittance(eta));
  inside.albedo.w = static_cast<float>(std::sqrt(1 - 1 / (eta * eta)));
  return inside;
}

// Whether `holds` is true for any medium that light enters, in any clip.
template <typename Holds>
bool anyInside(const SceneResources& resources, const std::vector<shared::MediumData>& media,
               const Holds& holds) {
  for (std::size_t i = 0; i < media.size(); ++i)
    if (!resources.opaqueOfMedium[i] && holds(media[i].inside)) return true;
  return std::any_of(resources.mediaInClips.begin(), resources.mediaInClips.end(),
                     [&](const Medium& medium) { return holds(insideOf(medium)); });
}

bool followsLight(const shared::BoundaryMedium& inside) {
  const shared::vec4& albedo = inside.albedo;
  return std::min({albedo.r, albedo.g, albedo.b}) < shared::albedoNotFollowed;
}

bool entersAtSurface(const shared::BoundaryMedium& inside) {
  const shared::vec4& albedo = inside.albedo;
  return std::max({albedo.r, albedo.g, albedo.b}) > shared::albedoFollowed;
}

bool scattersUnevenly(const shared::BoundaryMedium& inside) {
  return inside.collision.w != 0;
}

// Collects the tables of all media.
class TableBuilder {
 public:
  TableBuilder(const SceneResources& resources, const RenderOptions& options)
      : options_(options), etas_(differentEtas(resources)) {
    for (const double eta : etas_) {
      const std::vector<float> entries =
          passes::specularAlbedo(eta, static_cast<double>(options.roughness));
      albedo_.insert(albedo_.end(), entries.begin(), entries.end());
    }
    for (std::size_t i = 0; i < resources.media.size(); ++i) {
      const auto& opaque = resources.opaqueOfMedium[i];
      const bool painted = resources.paintOfMedium[i].has_value();
      media_.push_back(opaque ? dataOfOpaque() : dataOf(resources.media[i]));
      const auto eta = static_cast<std::uint32_t>(
          std::find(etas_.begin(), etas_.end(), etaOf(resources, i)) - etas_.begin());
      const auto& surface = resources.surfaceOfMedium[i];
      if (surface) media_.back().surface = {1, albedoByRoughness(etas_[eta]), 0, 0};
      hasOwnSurfaces_ = hasOwnSurfaces_ || surface;
      hasOwnNormals_ = hasOwnNormals_ || (surface && surface->normalTexture);
      media_.back().tables = {eta, resources.materialOfMedium[i],
                              painted ? addPaint(resources.media[i]) : 0,
                              eta * passes::specularAlbedoEntries};
    }
  }

  const std::vector<double>& etas() const { return etas_; }
  const std::vector<shared::MediumData>& media() const { return media_; }
  const std::vector<float>& albedo() const { return albedo_; }
  const std::vector<shared::PaintEntry>& paints() const { return paints_; }
  bool hasOwnSurfaces() const { return hasOwnSurfaces_; }
  bool hasOwnNormals() const { return hasOwnNormals_; }

 private:
  // The first entry of the tables for all roughnesses that surfaces of their own may have.
  std::uint32_t albedoByRoughness(double eta) {
    const auto known = albedoOfEta_.find(eta);
    if (known != albedoOfEta_.end()) return known->second;
    const auto first = static_cast<std::uint32_t>(albedo_.size());
    for (std::uint32_t row = 0; row < shared::albedoRows; ++row) {
      const std::vector<float> entries =
          passes::specularAlbedo(eta, (row + 0.5) / shared::albedoRows);
      albedo_.insert(albedo_.end(), entries.begin(), entries.end());
    }
    return albedoOfEta_.emplace(eta, first).first->second;
  }

  // Adds a medium's paint and returns its number plus 1.
  std::uint32_t addPaint(const Medium& medium) {
    const auto channels = bssrdf::paints(medium, shared::paintEntries);
    for (std::size_t i = 0; i < shared::paintEntries; ++i) {
      shared::PaintEntry entry{};
      for (int c = 0; c < 3; ++c) {
        const bssrdf::PaintedBoundary& layer = channels[static_cast<std::size_t>(c)][i];
        entry.thickness[c] = static_cast<float>(layer.thickness);
        entry.entering[c] = static_cast<float>(layer.entering);
        entry.layer[c] = static_cast<float>(layer.layer);
        entry.leaving[c] = static_cast<float>(layer.leaving);
        entry.takenOff[c] = static_cast<float>(layer.takenOff);
        entry.source[c] = static_cast<float>(layer.source);
        entry.deep[c] = static_cast<float>(layer.deep);
      }
      paints_.push_back(entry);
    }
    const Rgb color = colorOf(medium);
    paints_.push_back({.thickness = {color[0], color[1], color[2], 0}});
    return static_cast<std::uint32_t>(paints_.size() / (shared::paintEntries + 1));
  }

  shared::MediumData dataOf(const Medium& medium) const {
    const bssrdf::Model model = bssrdf::modelOf(options_.transport);
    const FresnelLobes lobes = fresnelLobesOf(medium.eta);
    shared::MediumData data{};
    const bssrdf::ExitDirections exits = bssrdf::exitDirections(medium.eta);
    data.exits = {exits.cosines[0], exits.cosines[1], exits.mirrored[0], exits.mirrored[1]};
    data.boundary = {static_cast<float>(medium.eta),
                     static_cast<float>(bssrdf::exitFactor(model, medium.eta)),
                     static_cast<float>(lobes.plain), static_cast<float>(1 / lobes.stretch)};
    setMedium(medium, options_.transport, data);
    return data;
  }

  const RenderOptions& options_;
  std::vector<double> etas_;
  std::vector<shared::MediumData> media_;
  std::vector<float> albedo_;
  std::map<double, std::uint32_t> albedoOfEta_;
  std::vector<shared::PaintEntry> paints_;
  bool hasOwnSurfaces_ = false;
  bool hasOwnNormals_ = false;
};

// Exitance below which nothing visible depends on it, relative to that of the body's mean
// irradiance.
constexpr double darkestOfMean = 1e-4;

void setSum(const SurfelsOfObject& surfels, const std::array<bssrdf::Profile, 3>& profiles,
            shared::ObjectData& object) {
  const double reachMm =
      surfels.coarse ? static_cast<double>(shared::reachInSpacings) * surfels.sourceSpacingMm : 0;
  object.darkest.w = static_cast<float>(reachMm);
  for (int c = 0; c < 3; ++c) {
    const bssrdf::Profile& profile = profiles[static_cast<std::size_t>(c)];
    if (surfels.areaMm2 > 0)
      object.darkest[c] =
          static_cast<float>(darkestOfMean * profile.totalReflectance() / surfels.areaMm2);
    if (!surfels.coarse) continue;
    const passes::NearbyShares shares = passes::nearbyShares(profile, reachMm);
    object.nearbyDisc[c] = static_cast<float>(shares.disc);
    object.nearbyInner[c] = static_cast<float>(shares.innerRing);
    object.nearbyOuter[c] = static_cast<float>(shares.outerRing);
    object.nearbyKept[c] = static_cast<float>(shares.kept);
  }
}

std::vector<shared::ObjectData> makeObjects(const SceneResources& resources, Transport transport) {
  std::vector<shared::ObjectData> objects(resources.objects);
  for (std::uint32_t i = 0; i < resources.objects; ++i) {
    objects[i].table = {resources.mediumOfObject[i], 0, 0, wantsVertices(resources, i) ? 0U : 1U};
    if (resources.surfelsOfObject.empty()) continue;
    const SurfelsOfObject& surfels = resources.surfelsOfObject[i];
    objects[i].table.y = surfels.first;
    objects[i].table.z = surfels.count;
    objects[i].tree = {surfels.root, surfels.endNode, surfels.backClusters, surfels.liningEndNode};
    const bool isOpaque = resources.isOpaque(i);
    const bool carries = isOpaque || (surfels.hasInside && transport == Transport::Boundary);
    objects[i].clusters = {surfels.clusterRoot, surfels.clusterEndNode, carries ? 1U : 0U,
                           isOpaque ? (resources.letsLightThrough[i] ? 2U : 1U) : 0U};
    objects[i].body = {surfels.firstObject, 0, 0, 0};
    if (isOpaque) continue;
    setMediumOf(resources, i, resources.media[resources.mediumOfObject[i]], transport, objects[i]);
  }
  return objects;
}

}  // namespace

void setMedium(const Medium& medium, Transport transport, shared::MediumData& data) {
  data.profile = shaders::packProfile(bssrdf::makeProfiles(bssrdf::modelOf(transport), medium));
  data.inside = insideOf(medium);
}

void setMediumOf(const SceneResources& resources, std::size_t object, const Medium& medium,
                 Transport transport, shared::ObjectData& data) {
  if (resources.surfelsOfObject.empty()) return;
  setSum(resources.surfelsOfObject[object],
         bssrdf::makeProfiles(bssrdf::modelOf(transport), medium), data);
}

std::vector<shared::vec4> reflectionLobes(double roughness) {
  std::vector<shared::vec4> lobes;
  for (int i = 0; i < passes::reflectionLobeEntries; ++i) {
    const ReflectionLobe lobe =
        reflectionLobeOf(roughness * roughness, (i + 0.5) / passes::reflectionLobeEntries);
    lobes.emplace_back(lobe.tilt, lobe.along, lobe.across, lobe.skew);
  }
  return lobes;
}

passes::SceneTables makeSceneTables(gpu::Device& device, const SceneResources& resources,
                                    const RenderOptions& options, TablesOnHost& onHost) {
  const TableBuilder builder(resources, options);
  constexpr VkBufferUsageFlags storage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
  passes::SceneTables tables;
  onHost = {makeObjects(resources, options.transport), builder.media()};
  tables.objects = gpu::makeBuffer(device, "objects", onHost.objects, storage);
  tables.media = gpu::makeBuffer(device, "media", onHost.media, storage);
  tables.mediumCount = static_cast<std::uint32_t>(resources.media.size());
  tables.haveThinParts = anyInside(resources, builder.media(), [&](const auto& inside) {
    const shared::vec4& collision = inside.collision;
    return shared::letsThrough(resources.clusters.thinnestMm,
                               std::min({collision.r, collision.g, collision.b}));
  });
  tables.followsLight = anyInside(resources, builder.media(), followsLight);
  tables.entersAtSurface = anyInside(resources, builder.media(), entersAtSurface);
  tables.scattersEvenly = !anyInside(resources, builder.media(), scattersUnevenly);
  tables.specularAlbedo = gpu::makeBuffer(device, "specular albedo", builder.albedo(), storage);
  tables.reflectionLobes = gpu::makeBuffer(device, "lobes of the reflection",
                                           reflectionLobes(double{options.roughness}), storage);
  tables.paint.any = !builder.paints().empty();
  tables.paint.entries = gpu::makeBuffer(device, "paints", builder.paints(), storage);
  tables.surfaces.any = builder.hasOwnSurfaces();
  tables.surfaces.anyNormals = builder.hasOwnNormals();
  tables.anyBacks =
      std::any_of(resources.surfelsOfObject.begin(), resources.surfelsOfObject.end(),
                  [](const SurfelsOfObject& surfels) { return surfels.backClusters > 0; });
  tables.etas = builder.etas();
  return tables;
}

}  // namespace opaline
