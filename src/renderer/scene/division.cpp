#include "renderer/scene/division.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "bssrdf/profile.h"
#include "opaline/options/picture.h"
#include "scene/changes.h"

namespace opaline {

namespace {

// Size of surfels in mean free paths, with some room for surfaces that stretch.
constexpr double sizeInFreePaths = 0.65;

// Largest edge of clusters, in mean free paths of the channel where they are longest: light that
// enters larger ones stays too near the surface.
constexpr double clusterInFreePaths = 4;

// Clusters larger than wanted by up to this factor make no visible difference.
constexpr double notableCoarseness = 1.5;

double longestMeanFreePathMm(const Medium& medium) {
  double longest = 0;
  for (int channel = 0; channel < 3; ++channel)
    longest = std::max(longest, bssrdf::coefficients(medium, channel).meanFreePathMm);
  return longest;
}

// If clips change the medium, the shortest over time.
double longestInAnyClipMm(const Scene& scene, std::size_t object) {
  double longest = longestMeanFreePathMm(scene.objects[object].medium);
  scene::forEachMediumOf(scene, object, [&](const Medium& medium) {
    longest = std::min(longest, longestMeanFreePathMm(medium));
  });
  return longest;
}

// Sizes for opaque bodies, in diagonals of the scene: the resolution of light between them.
constexpr double opaqueSpacing = 0.01;
constexpr double opaqueCluster = 0.03;

constexpr double infinity = std::numeric_limits<double>::infinity();

double spacingOfObjectMm(const Scene& scene, std::size_t object, double sceneMm) {
  if (scene.objects[object].isGround) return infinity;
  if (scene.objects[object].opaque) return opaqueSpacing * sceneMm;
  return sizeInFreePaths * bssrdf::shortestMeanFreePathMm(scene::finestMedium(scene, object));
}

// Nothing is solved in an open body: its clusters only serve the light that it sends to others.
double clusterOfObjectMm(const Scene& scene, const Insides& insides, std::size_t object,
                         double sceneMm) {
  if (scene.objects[object].isGround) return surfels::asItsTriangles;
  if (scene.objects[object].opaque) return opaqueCluster * sceneMm;
  return insides.objectHasInside[object] ? clusterInFreePaths * longestInAnyClipMm(scene, object)
                                         : infinity;
}

// Whether light falls on both sides of an object's surface.
bool hasBack(const Scene& scene, const Insides& insides, std::size_t object) {
  return scene.objects[object].opaque &&
         (insides.objectIsOpen[object] || scene::letsLightThrough(scene, object));
}

constexpr const char* noRoom = "this device has no room for more";

std::string cureOfClusters(const Division& division, const DeviceRoom& room) {
  if (division.order.maxClusters >= room.clusters) return noRoom;
  const std::size_t wanted = division.clusters->wanted;
  const bool mayBeAsked =
      wanted <= room.clusters && options::fieldOf<options::PictureSettings>("max_clusters")
                                     .allowed.range.holds(static_cast<double>(wanted));
  return mayBeAsked ? fmt::format("raise RenderOptions::maxClusters to {}, which is enough", wanted)
                    : "raise RenderOptions::maxClusters for more accuracy";
}

void noteClusters(const Division& division, const DeviceRoom& room, const LogCallback& log) {
  if (!division.clusters || !(division.clusters->coarseness() > notableCoarseness)) return;
  log(LogLevel::Note,
      fmt::format("the budget of {} clusters leaves them {:.1f} times as large as shape and medium "
                  "ask for; {}",
                  division.order.maxClusters, division.clusters->coarseness(),
                  cureOfClusters(division, room)));
}

}  // namespace

DivisionOrder divisionFor(const Scene& scene, const scene::MergedMesh& merged,
                          const Insides& insides, std::size_t maxSurfels,
                          std::optional<std::size_t> maxClusters) {
  DivisionOrder order{.maxSurfels = maxSurfels};
  const double sceneMm{diagonalMm(scene)};
  const std::size_t bodies = merged.firstObjectOfBody.size();
  order.spacingOfBodyMm.assign(bodies, infinity);
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    double& mm = order.spacingOfBodyMm[merged.bodyOfObject[i]];
    mm = std::min(mm, spacingOfObjectMm(scene, i, sceneMm));
  }
  if (!maxClusters) return order;
  order.maxClusters = *maxClusters;
  order.clustersOfBody.assign(bodies, {infinity, false});
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    surfels::ClusterOrder& body = order.clustersOfBody[merged.bodyOfObject[i]];
    body.largestMm = std::min(body.largestMm, clusterOfObjectMm(scene, insides, i, sceneMm));
    body.bothSides = body.bothSides || hasBack(scene, insides, i);
  }
  return order;
}

Division divide(const scene::MergedMesh& merged, const DivisionOrder& order, const Within& within) {
  const core::RestSurface surface = within.linings.lined(scene::bodiesOf(merged));
  Division made{order,
                surfels::makeSurfels(surface, order.spacingOfBodyMm, order.maxSurfels,
                                     within.linings, within.overlaps),
                std::nullopt};
  if (order.maxClusters > 0)
    made.clusters =
        surfels::makeClusters(surface, made.surfels, order.clustersOfBody, order.maxClusters);
  return made;
}

void noteCoarseness(const Division& division, const DeviceRoom& room, const LogCallback& log) {
  if (!log) return;
  double coarsest = 1;
  for (std::size_t i = 0; i < division.order.spacingOfBodyMm.size(); ++i)
    coarsest = std::max(coarsest,
                        division.surfels.spacingOfObjectMm[i] / division.order.spacingOfBodyMm[i]);
  if (coarsest > 1)
    log(LogLevel::Note,
        fmt::format("the budget of {} surfels leaves them {:.1f} times as large as the medium asks "
                    "for; {}",
                    division.order.maxSurfels, coarsest,
                    division.order.maxSurfels < room.surfels
                        ? "raise RenderOptions::maxSurfels for more accuracy"
                        : noRoom));
  noteClusters(division, room, log);
}

}  // namespace opaline
