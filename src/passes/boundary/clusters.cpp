#include "passes/boundary/clusters.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <span>
#include <string>

#include "gpu/device.h"
#include "gpu/transfer.h"
#include "passes/fitted_tree.h"
#include "passes/mechanics.h"
#include "shaders/shared/boundary.h"
#include "shaders/shared/frame.h"
#include "shaders/shared/paint.h"

namespace opaline::passes {

namespace {

std::uint32_t mostNodesOfBody(const surfels::ClusterDivision& made) {
  const std::vector<std::uint32_t>& roots = made.tree.rootOfObject;
  std::uint32_t most = 0;
  for (std::size_t object = 0; object + 1 < roots.size(); ++object)
    most = std::max(most, roots[object + 1] - roots[object]);
  return most;
}

// Room of a group's list of nodes that act on it. Bodies of more nodes are summed in several
// dispatches, so that all lists together take at most 96 MiB.
std::uint32_t roomOfBeamList(std::uint32_t nodes, std::size_t groups) {
  constexpr std::size_t ofAll = std::size_t{3} << 23U;
  const std::size_t ofOne = ofAll / std::max<std::size_t>(groups, 1);
  return std::min(nodes, static_cast<std::uint32_t>(std::clamp<std::size_t>(ofOne, 64, 16384)) - 1);
}

// Room of a tile's interaction list. With many thin parts beside each other, thousands of nodes act
// on a tile, and finding them again in each step of the solver takes twice as long as keeping them.
// Lists beyond the least length take at most 16 MiB.
std::uint32_t roomOfList(std::uint32_t nodes, std::size_t tiles) {
  constexpr std::size_t ofAll = std::size_t{1} << 22U;
  const std::size_t ofOne = ofAll / std::max<std::size_t>(tiles, 1);
  const std::size_t room = std::max<std::size_t>(ofOne, shared::leastRoomOfList);
  return static_cast<std::uint32_t>(std::min<std::size_t>(room, std::size_t{nodes} + 1));
}

// How many of them one dispatch sends. Where loops end early, that depends on how many pieces rays
// go through.
std::uint32_t raysAtOnce(const gpu::Device& device, std::uint32_t piecesPerSurfel) {
  if (!device.workGroups().loopsEnd) return raysOutwards;
  return std::max(raysOutwards / (piecesPerSurfel + 1), 1U);
}

constexpr VkBufferUsageFlags clusterBuffer = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;

std::vector<std::uint32_t> leafOfCluster(const surfels::ClusterDivision& made) {
  std::vector<std::uint32_t> leaf(made.count());
  for (std::uint32_t node = 0; node < made.tree.links.size(); ++node) {
    const surfels::NodeLink link = surfels::linkOf(made.tree, node);
    if (link.leaf) leaf[link.first] = node;
  }
  return leaf;
}

std::vector<std::uint32_t> objectsOfPatches(const std::vector<shared::ClusterRange>& ranges) {
  std::vector<std::uint32_t> objects;
  for (const shared::ClusterRange& range : ranges)
    objects.insert(objects.end(), patchesOf(range), range.object);
  return objects;
}

std::uint32_t mostOf(const std::map<std::uint32_t, double>& counts) {
  const auto less = [](const auto& a, const auto& b) { return a.second < b.second; };
  return std::max_element(counts.begin(), counts.end(), less)->first;
}

// The object of a cluster: of several objects of one body, the one with the largest part of its
// area.
std::uint32_t objectOfMost(const core::RestSurface& surface,
                           std::span<const surfels::Piece> pieces) {
  std::map<std::uint32_t, double> areas;
  for (const surfels::Piece& piece : pieces)
    areas[surface.objectOfTriangle[piece.triangle]] += surfels::areaMm2(surface, piece);
  return mostOf(areas);
}

std::vector<shared::ClusterRange> rangesOf(const surfels::ClusterDivision& made,
                                           const core::RestSurface& surface,
                                           const surfels::SurfelDivision& surfels,
                                           const BodyKinds& kinds) {
  const auto hasInside = [&](const surfels::Piece& piece) {
    return kinds.triangleHasInside[piece.triangle];
  };
  const std::vector<std::uint32_t> leaf = leafOfCluster(made);
  const std::size_t perSurfel = surfels.piecesPerSurfel;
  std::vector<shared::ClusterRange> ranges;
  std::uint32_t firstPatch = 0;
  for (std::uint32_t i = 0; i < made.count(); ++i) {
    const auto [first, end, isBack, thicknessMm] = made.clusters[i];
    const std::span<const surfels::Piece> pieces =
        std::span(surfels.pieces).subspan(first * perSurfel, (end - first) * perSurfel);
    const std::uint32_t object = objectOfMost(surface, pieces);
    std::uint32_t kind = shared::opaqueBody;
    if (pieces.front().triangle >= kinds.firstLining) {
      kind = shared::lining;
    } else if (!kinds.objectIsOpaque[object]) {
      const bool inside = std::all_of(pieces.begin(), pieces.end(), hasInside);
      kind = inside ? shared::bodyWithInside : shared::openBody;
    }
    ranges.push_back({first, end, object, leaf[i], kind, isBack ? -1.0F : 1.0F, firstPatch, 0,
                      static_cast<float>(thicknessMm)});
    firstPatch += patchesOf(ranges.back());
  }
  return ranges;
}

// See Clusters::thinnestMm.
float thinnestMm(const surfels::ClusterDivision& made,
                 const std::vector<shared::ClusterRange>& ranges) {
  float thinnest = std::numeric_limits<float>::infinity();
  for (std::size_t object = 0; object + 1 < made.firstOfObject.size(); ++object) {
    std::vector<float> thickness;
    for (std::uint32_t i = made.firstOfObject[object]; i < made.firstOfObject[object + 1]; ++i)
      if (ranges[i].kind == shared::bodyWithInside) thickness.push_back(ranges[i].thickness);
    if (thickness.empty()) continue;
    const auto nth = thickness.begin() + static_cast<std::ptrdiff_t>(thickness.size() / 10);
    std::nth_element(thickness.begin(), nth, thickness.end());
    thinnest = std::min(thinnest, *nth);
  }
  return thinnest;
}

// The cluster of every surfel; of two, that of the front.
std::vector<std::uint32_t> clusterOfSurfel(const surfels::ClusterDivision& made,
                                           std::uint32_t surfels) {
  std::vector<std::uint32_t> cluster(surfels);
  for (std::uint32_t i = 0; i < made.count(); ++i) {
    const surfels::ClusterDivision::Cluster& its = made.clusters[i];
    if (!its.isBack)
      std::fill(cluster.begin() + its.firstSurfel, cluster.begin() + its.endSurfel, i);
  }
  return cluster;
}

std::vector<shared::ClusterTile> tilesOf(const std::vector<shared::ClusterRange>& ranges) {
  std::vector<shared::ClusterTile> tiles;
  for (std::uint32_t i = 0; i < ranges.size(); ++i) {
    const bool fits = !tiles.empty() && tiles.back().object == ranges[i].object &&
                      i - tiles.back().firstCluster < shared::maxClustersOfTile;
    if (!fits) tiles.push_back({i, i, ranges[i].object, 0});
    tiles.back().endCluster = i + 1;
  }
  return tiles;
}

// For each node of the clusters' tree, the object of most clusters below it.
std::vector<std::uint32_t> objectsOfNodes(const surfels::ClusterDivision& made,
                                          const std::vector<shared::ClusterRange>& ranges) {
  std::vector<std::uint32_t> objects;
  std::uint32_t first = 0;  // cluster
  for (std::uint32_t node = 0; node < made.tree.links.size(); ++node) {
    const surfels::NodeLink link = surfels::linkOf(made.tree, node);
    const std::uint32_t end = surfels::linkOf(made.tree, link.end - 1).first + 1;
    std::map<std::uint32_t, double> counts;
    for (std::uint32_t i = first; i < end; ++i) ++counts[ranges[i].object];
    objects.push_back(mostOf(counts));
    if (link.leaf) first = end;
  }
  return objects;
}

// Whether the clusters of any body have several media.
bool haveSeveralMedia(const surfels::ClusterDivision& made,
                      const std::vector<shared::ClusterRange>& ranges) {
  for (std::size_t body = 0; body + 1 < made.firstOfObject.size(); ++body)
    for (std::uint32_t i = made.firstOfObject[body]; i < made.firstOfObject[body + 1]; ++i)
      if (ranges[i].object != ranges[made.firstOfObject[body]].object) return true;
  return false;
}

std::uint32_t partsOf(const shared::ClusterRange& range) {
  return (range.endSurfel - range.firstSurfel + shared::surfelsOfPart - 1) / shared::surfelsOfPart;
}

void tellTiles(const std::vector<shared::ClusterTile>& tiles,
               std::vector<shared::ClusterRange>& ranges) {
  for (std::uint32_t tile = 0; tile < tiles.size(); ++tile) {
    for (std::uint32_t i = tiles[tile].firstCluster; i < tiles[tile].endCluster; ++i)
      ranges[i].tile = tile;
  }
}

// Makes groups of tiles and tells each tile its group.
std::vector<shared::ClusterGroup> groupsOf(std::vector<shared::ClusterTile>& tiles) {
  std::vector<shared::ClusterGroup> groups;
  for (shared::ClusterTile& tile : tiles) {
    const bool fits = !groups.empty() && groups.back().object == tile.object &&
                      tile.endCluster - groups.back().firstCluster <= shared::maxClustersOfGroup;
    if (!fits) groups.push_back({tile.firstCluster, 0, tile.object, 0});
    groups.back().endCluster = tile.endCluster;
    tile.group = static_cast<std::uint32_t>(groups.size()) - 1;
  }
  return groups;
}

// Inner nodes, ordered by their number of clusters, so that neighbours take equally long.
std::vector<shared::InnerNode> innerNodesOf(const surfels::ClusterDivision& made,
                                            const std::vector<shared::ClusterRange>& ranges) {
  const std::vector<std::uint32_t>& roots = made.tree.rootOfObject;
  std::vector<shared::InnerNode> inner;
  for (std::uint32_t object = 0; object + 1 < roots.size(); ++object) {
    std::uint32_t cluster = made.firstOfObject[object];
    for (std::uint32_t node = roots[object]; node < roots[object + 1]; ++node) {
      const surfels::NodeLink link = surfels::linkOf(made.tree, node);
      if (link.leaf)
        cluster = link.first + 1;
      else
        inner.push_back({node, cluster, surfels::linkOf(made.tree, link.end - 1).first + 1,
                         ranges[cluster].object});
    }
  }
  std::stable_sort(inner.begin(), inner.end(), [](const auto& a, const auto& b) {
    return a.endCluster - a.firstCluster < b.endCluster - b.firstCluster;
  });
  return inner;
}

Beams makeBeams(gpu::Device& device, const std::string& from, std::size_t beams) {
  const auto name = [&](const char* what) { return what + (" from " + from); };
  return {
      makeRoom<shared::BeamPoint>(device, name("points"), shared::maxPoints * beams),
      makeRoom<shared::FirstCollision>(device, name("collisions"), shared::maxFirstPoints * beams),
      makeRoom<shared::vec4>(device, name("strengths"), beams),
      makeRoom<std::uint32_t>(device, name("strongest"), 1),
      makeRoom<shared::Guided>(device, name("guided light"), shared::pathsOfBeam * beams)};
}

// How many lights' points are found and summed together, as far as buffers may be that large.
std::uint32_t lightsAtOnce(const gpu::Device& device, std::uint32_t clusters) {
  constexpr std::size_t most = 2;
  const std::size_t ofOne = sizeof(shared::BeamPoint) * shared::maxPoints * clusters;
  return static_cast<std::uint32_t>(std::clamp<std::size_t>(
      mostBytes(device.limits()) / std::max<std::size_t>(ofOne, 1), 1, most));
}

}  // namespace

Clusters makeClusters(gpu::Device& device, const surfels::ClusterDivision& made,
                      const core::RestSurface& surface, const surfels::SurfelDivision& surfels,
                      const BodyKinds& kinds) {
  const std::size_t count = made.count();
  const std::size_t nodes = made.tree.links.size();
  Clusters clusters;
  clusters.count = made.count();
  clusters.raysOutwards = raysOutwards;
  clusters.raysAtOnce = raysAtOnce(device, surfels.piecesPerSurfel);
  clusters.tree = makeFittedTree(device, made.tree);
  std::vector<shared::ClusterRange> ranges = rangesOf(made, surface, surfels, kinds);
  std::vector<shared::ClusterTile> tiles = tilesOf(ranges);
  const std::vector<shared::ClusterGroup> groups = groupsOf(tiles);
  tellTiles(tiles, ranges);
  for (const shared::ClusterRange& range : ranges)
    clusters.partsOfSurfels = std::max(clusters.partsOfSurfels, partsOf(range));
  clusters.ranges = gpu::makeBuffer(device, "ranges of clusters", ranges, clusterBuffer);
  clusters.thinnestMm = thinnestMm(made, ranges);
  clusters.haveSeveralMedia = haveSeveralMedia(made, ranges);
  clusters.objectOfNode = gpu::makeBuffer(device, "objects of nodes of clusters",
                                          objectsOfNodes(made, ranges), clusterBuffer);
  clusters.haveLinings = std::any_of(
      ranges.begin(), ranges.end(), [](const auto& range) { return range.kind == shared::lining; });
  const std::vector<std::uint32_t> objectOfPatch = objectsOfPatches(ranges);
  clusters.patchCount = static_cast<std::uint32_t>(objectOfPatch.size());
  clusters.objectOfPatch =
      gpu::makeBuffer(device, "object of each patch", objectOfPatch, clusterBuffer);
  clusters.patches = makeRoom<shared::vec4>(device, "patches", clusters.patchCount);
  clusters.clusterOfSurfel = gpu::makeBuffer(device, "cluster of each surfel",
                                             clusterOfSurfel(made, surfels.count()), clusterBuffer);
  clusters.tileCount = static_cast<std::uint32_t>(tiles.size());
  clusters.tiles = gpu::makeBuffer(device, "tiles of clusters", tiles, clusterBuffer);
  clusters.groupCount = static_cast<std::uint32_t>(groups.size());
  clusters.groups = gpu::makeBuffer(device, "groups of clusters", groups, clusterBuffer);
  clusters.roomOfList = roomOfList(clusters.tree.nodeCount, tiles.size());
  clusters.lists =
      makeRoom<std::uint32_t>(device, "interaction lists", tiles.size() * clusters.roomOfList);
  clusters.around =
      makeRoom<std::uint32_t>(device, "clusters around tiles", tiles.size() * shared::roomOfAround);
  const std::vector<shared::InnerNode> inner = innerNodesOf(made, ranges);
  clusters.innerCount = static_cast<std::uint32_t>(inner.size());
  clusters.smallInnerCount =
      static_cast<std::uint32_t>(std::count_if(inner.begin(), inner.end(), [](const auto& node) {
        return node.endCluster - node.firstCluster <= shared::fewClusters;
      }));
  clusters.inner = gpu::makeBuffer(device, "inner nodes of clusters", inner, clusterBuffer);
  clusters.clusters = makeRoom<shared::Cluster>(device, "clusters", count);
  clusters.nodes = makeRoom<shared::ClusterNode>(device, "tree of clusters", nodes);
  clusters.entries = makeRoom<shared::Entry>(device, "light that enters",
                                             count * (shared::maxLights + std::size_t{1}));
  clusters.meetings = makeRoom<shared::Meeting>(device, "meetings", count * raysOutwards);
  clusters.skySums = makeRoom<shared::SkySum>(device, "sums of the sky", count);
  const std::uint32_t lights = lightsAtOnce(device, clusters.count);
  const std::size_t trees = 2 * (1 + std::size_t{lights});
  clusters.fromLights = makeBeams(device, "lights", count * lights);
  clusters.fromLights.room = lights;
  clusters.fromEverywhere = makeBeams(device, "everywhere", count);
  clusters.mirrored = makeRoom<shared::Mirrored>(device, "mirrored light", count * lights);
  // Each frame resets these to 0 itself.
  const auto zeros = [&](const char* name, std::size_t words) {
    return gpu::makeBuffer(device, name, std::vector<std::uint32_t>(words, 0), clusterBuffer);
  };
  static_assert(shared::maxLights <= shared::peaksOfMirrored);
  constexpr std::size_t entering = std::size_t{shared::peakOfFirstLight} + shared::maxLights;
  clusters.peaks = zeros("peaks of clusters", shared::peaksOfMirrored + 3 * entering);
  clusters.sums = zeros("sums of mirrored light", 4 * count);
  clusters.guidedSums = makeRoom<std::uint32_t>(device, "sums of guided light", 6 * count);
  clusters.arrived = makeRoom<shared::vec4>(device, "arrived mirrored light", count);
  clusters.beamNodes = makeRoom<shared::BeamNode>(device, "trees of points", trees * nodes);
  clusters.mostNodesOfBody = mostNodesOfBody(made);
  clusters.roomOfBeamList = roomOfBeamList(clusters.mostNodesOfBody, trees * groups.size());
  clusters.beamLists =
      makeRoom<std::uint32_t>(device, "lists of points",
                              trees * groups.size() * (std::size_t{clusters.roomOfBeamList} + 1));
  clusters.sources = makeRoom<shared::vec4>(device, "sources of fluence", count);
  clusters.skyShares = makeRoom<shared::vec4>(device, "share of the sky of clusters", count);
  clusters.withheld = makeRoom<float>(device, "light withheld by other sides", count);
  clusters.entered = makeRoom<shared::vec4>(device, "diffuse light that enters", count);
  if (surfels.firstOfObject.size() > 2)
    clusters.fromAfar = makeRoom<shared::vec4>(device, "diffuse light from afar", count);
  clusters.enteredBefore = makeRoom<shared::vec4>(device, "diffuse light that entered", count);
  clusters.enteredInAll = makeRoom<shared::vec4>(device, "all light that entered", count);
  clusters.power = makeRoom<shared::vec4>(device, "power of a bounce", 1);
  clusters.nearby = makeRoom<shared::vec4>(device, "nearby exitances", count);
  clusters.latest = makeRoom<shared::vec4>(device, "latest exitances", count);
  clusters.exitances = makeRoom<shared::vec4>(device, "exitances of clusters", count);
  clusters.means = makeRoom<shared::vec4>(device, "means over clusters", count);
  clusters.bareLights = makeRoom<shared::BareLight>(device, "light below paint", count);
  clusters.exitancesWithin =
      makeRoom<shared::vec4>(device, "exitances within clusters", surfels.count());
  return clusters;
}

}  // namespace opaline::passes
