#include "surfels/surfels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "surfels/clusters.h"
#include "surfels/layers.h"
#include "surfels/vector.h"

namespace opaline::surfels {

namespace {

// By what factor the largest pieces become coarser from one try to fit the budget to the next.
constexpr double coarserPieces = 1.1;

struct Cut {
  std::vector<Piece> pieces;
  std::vector<double> spacingOfObjectMm;
};

std::vector<double> largestTriangleOfObjectMm(const core::RestSurface& surface,
                                              std::size_t objects) {
  std::vector<double> largest(objects, 0);
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
    double& mm = largest[surface.objectOfTriangle[t]];
    mm = std::max(mm, spacingOfMm(surface, t));
  }
  return largest;
}

// A lower bound of the pieces that each object needs for the wanted spacing. Pieces of a spacing h
// have at most the area √3/2 h², that of an equilateral triangle, and bisecting halves a spacing at
// most.
std::vector<double> leastPiecesOfObject(const core::RestSurface& surface,
                                        std::span<const double> wantedMm,
                                        std::span<const double> largestMm) {
  std::vector<double> pieces(wantedMm.size(), 0);
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
    const double mm = wantedMm[surface.objectOfTriangle[t]];
    pieces[surface.objectOfTriangle[t]] += areaMm2(surface, t) / (std::sqrt(3.0) / 2 * mm * mm);
  }
  for (std::size_t i = 0; i < pieces.size(); ++i)
    pieces[i] = std::max(pieces[i], largestMm[i] / wantedMm[i]);
  return pieces;
}

// The largest share that fits the budget if every object takes what it wants, but at most one
// share.
double fairShare(std::vector<double> wanted, double budget) {
  std::sort(wanted.begin(), wanted.end());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const double share = budget / static_cast<double>(wanted.size() - i);
    if (wanted[i] > share) return share;
    budget -= wanted[i];
  }
  return wanted.back();
}

// Cuts the surface as finely as wanted, or as the budget allows. A large object takes nothing from
// a small one that needs less than its share. The budget is at least the number of triangles.
Cut cut(const core::RestSurface& surface, std::span<const double> wantedMm, std::size_t budget) {
  const std::vector<double> largestMm = largestTriangleOfObjectMm(surface, wantedMm.size());
  const std::vector<double> wanted = leastPiecesOfObject(surface, wantedMm, largestMm);
  double share = fairShare(wanted, static_cast<double>(budget));
  Cut result;
  while (true) {
    result.spacingOfObjectMm.assign(wantedMm.begin(), wantedMm.end());
    for (std::size_t i = 0; i < wanted.size(); ++i)
      result.spacingOfObjectMm[i] *= std::max(1.0, std::sqrt(wanted[i] / share));
    if (std::optional<std::vector<Piece>> pieces =
            subdivide(surface, result.spacingOfObjectMm, budget)) {
      result.pieces = std::move(*pieces);
      return result;
    }
    share /= coarserPieces * coarserPieces;
  }
}

// Sets the items' facings and layers so that the two sides of a thin part, and parts that lie upon
// each other, are further apart than a surfel or cluster is large, and so are not joined.
void tellSidesApart(const core::RestSurface& surface, std::span<const Piece> pieces,
                    const Layers& layers, std::uint32_t piecesPerSurfel,
                    std::span<TreeItem> items) {
  double area = 0;
  for (const TreeItem& item : items) area += areaMm2(surface, pieces[item.index]);
  const double surfels = static_cast<double>(items.size()) / piecesPerSurfel;
  const double sizeMm = std::max(usualClusterMm(area), 2 * std::sqrt(area / surfels));
  const std::vector<std::uint8_t> layerOfItem = layers.ofItems(pieces, items, sizeMm);
  for (std::size_t i = 0; i < items.size(); ++i) {
    items[i].layerMm = static_cast<float>(2 * sizeMm * layerOfItem[i]);
    const std::array<double, 3> cross = crossOf(surface, pieces[items[i].index].triangle);
    const double length = std::hypot(cross[0], cross[1], cross[2]);
    for (std::size_t axis = 0; axis < 3 && length > 0; ++axis)
      items[i].facingMm[axis] = static_cast<float>(sizeMm * cross[axis] / length);
  }
}

// The pieces of each object as items of the tree, filled up with empty ones to whole surfels. If
// there are linings, each object's lining follows as a list of its own.
std::vector<std::vector<TreeItem>> itemsOfObjects(const core::RestSurface& surface,
                                                  std::vector<Piece>& pieces, std::size_t objects,
                                                  std::uint32_t piecesPerSurfel,
                                                  const Linings& linings) {
  const std::size_t lists = linings.any() ? 2 : 1;
  const Layers layers(surface);
  std::vector<std::vector<TreeItem>> items(lists * objects);
  for (std::uint32_t i = 0; i < pieces.size(); ++i) {
    const std::uint32_t triangle = pieces[i].triangle;
    const std::size_t lining = triangle >= linings.firstTriangle() ? 1 : 0;
    items[lists * surface.objectOfTriangle[triangle] + lining].push_back(
        {middleOfMm(surface, pieces[i]), i});
  }
  for (std::vector<TreeItem>& list : items) {
    tellSidesApart(surface, pieces, layers, piecesPerSurfel, list);
    while (list.size() % piecesPerSurfel != 0) {
      Piece empty = pieces[list.back().index];
      empty.fraction = 0;
      TreeItem item = list.back();
      item.index = static_cast<std::uint32_t>(pieces.size());
      list.push_back(item);
      pieces.push_back(empty);
    }
  }
  return items;
}

// Removes pieces inside the solids that line a body or inside other parts of it, but never all of
// an object.
void uncover(const core::RestSurface& surface, const Linings& linings, const Overlaps& overlaps,
             std::size_t objects, std::vector<Piece>& pieces) {
  std::vector<bool> covered(pieces.size(), false);
  std::vector<std::size_t> left(objects, 0);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    Vector normal = crossOf(surface, pieces[i].triangle);
    const double length = lengthOf(normal);
    for (double& axis : normal) axis /= std::max(length, std::numeric_limits<double>::min());
    const std::uint32_t object = surface.objectOfTriangle[pieces[i].triangle];
    const Vector middle = vectorOf(middleOfMm(surface, pieces[i]));
    covered[i] = linings.isCovered(object, middle, normal) ||
                 overlaps.isWithin(pieces[i].triangle, middle, normal);
    if (!covered[i]) ++left[object];
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const bool goes = covered[i] && left[surface.objectOfTriangle[pieces[i].triangle]] > 0;
    if (!goes) pieces[kept++] = pieces[i];
  }
  pieces.resize(kept);
}

// All vertices in the order in which the surfels' triangles first use them.
std::vector<std::uint32_t> orderVertices(const core::RestSurface& surface,
                                         std::span<const Piece> pieces) {
  std::vector<std::uint32_t> order;
  std::vector<bool> met(surface.positionsMm.size(), false);
  const auto meet = [&](std::uint32_t vertex) {
    if (met[vertex]) return;
    met[vertex] = true;
    order.push_back(vertex);
  };
  for (const Piece& piece : pieces) {
    for (const std::uint32_t vertex : surface.triangles[piece.triangle]) meet(vertex);
  }
  for (std::uint32_t vertex = 0; vertex < met.size(); ++vertex) meet(vertex);
  return order;
}

// Surfels that join triangles get the mean size: the surface divided by their number.
void coarsenToMean(const core::RestSurface& surface, SurfelDivision& surfels) {
  std::vector<double> area(surfels.spacingOfObjectMm.size(), 0);
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t)
    area[surface.objectOfTriangle[t]] += areaMm2(surface, t);
  for (std::size_t i = 0; i < area.size(); ++i) {
    const std::uint32_t count = surfels.firstLiningOfObject[i] - surfels.firstOfObject[i];
    double& mm = surfels.spacingOfObjectMm[i];
    mm = std::max(mm, std::sqrt(area[i] / std::max(count, 1U)));
  }
}

// The number of surfels if every triangle is one piece.
std::size_t leastSurfels(const core::RestSurface& surface, std::size_t objects,
                         std::uint32_t piecesPerSurfel) {
  std::vector<std::size_t> triangles(objects, 0);
  for (const std::uint32_t object : surface.objectOfTriangle) ++triangles[object];
  std::size_t surfels = 0;
  for (const std::size_t count : triangles)
    surfels += (count + piecesPerSurfel - 1) / piecesPerSurfel;
  return surfels;
}

core::RestSurface withoutLinings(const core::RestSurface& surface, const Linings& linings) {
  if (!linings.any()) return surface;
  const std::size_t first = linings.firstTriangle();
  return {surface.positionsMm, surface.triangles.first(first),
          surface.objectOfTriangle.first(first)};
}

// Assigns consecutive lists to their objects: one per object, or two if there are linings.
void takeLists(std::span<const std::uint32_t> firstOfList, std::size_t objects,
               SurfelDivision& surfels) {
  const std::vector<std::uint32_t> roots = surfels.tree.rootOfObject;
  const std::size_t lists = (firstOfList.size() - 1) / std::max<std::size_t>(objects, 1);
  surfels.tree.rootOfObject.clear();
  for (std::size_t i = 0; i < objects; ++i) {
    surfels.firstOfObject.push_back(firstOfList[lists * i]);
    surfels.tree.rootOfObject.push_back(roots[lists * i]);
    surfels.firstLiningOfObject.push_back(firstOfList[lists * i + 1]);
    surfels.liningRootOfObject.push_back(roots[lists * i + 1]);
  }
  surfels.firstOfObject.push_back(firstOfList.back());
  surfels.tree.rootOfObject.push_back(roots.back());
}

}  // namespace

SurfelDivision makeSurfels(const core::RestSurface& surface,
                           std::span<const double> wantedSpacingMm, std::size_t maxSurfels,
                           const Linings& linings, const Overlaps& overlaps) {
  const std::size_t objects = wantedSpacingMm.size();
  const core::RestSurface outer = withoutLinings(surface, linings);
  const std::size_t lining = linings.pieces().size();
  SurfelDivision surfels;
  const auto need = [&](std::uint32_t perSurfel) {
    const std::size_t ofLinings = (lining + perSurfel - 1) / perSurfel + (lining > 0 ? objects : 0);
    return leastSurfels(outer, objects, perSurfel) + ofLinings;
  };
  while (need(surfels.piecesPerSurfel) > maxSurfels &&
         surfels.piecesPerSurfel < surface.triangles.size() + lining) {
    surfels.piecesPerSurfel *= 2;
  }
  // The last surfel of an object and that of its lining may be incomplete; room for that is kept.
  const std::size_t partly = surfels.piecesPerSurfel == 1 ? 0 : lining > 0 ? 2 * objects : objects;
  const std::size_t full = maxSurfels - std::min(partly, maxSurfels);
  const std::size_t pieces = full * surfels.piecesPerSurfel;
  Cut made = cut(outer, wantedSpacingMm,
                 std::max(pieces - std::min(lining, pieces), outer.triangles.size()));
  if (linings.any() || overlaps.any()) uncover(outer, linings, overlaps, objects, made.pieces);
  made.pieces.insert(made.pieces.end(), linings.pieces().begin(), linings.pieces().end());
  surfels.spacingOfObjectMm = std::move(made.spacingOfObjectMm);
  std::vector<std::vector<TreeItem>> items =
      itemsOfObjects(surface, made.pieces, objects, surfels.piecesPerSurfel, linings);
  const std::vector<std::span<TreeItem>> spans(items.begin(), items.end());
  surfels.tree = makeTree(spans, surfels.piecesPerSurfel);

  std::vector<std::uint32_t> firstOfList{0};
  for (const std::vector<TreeItem>& list : items) {
    for (const TreeItem& item : list) surfels.pieces.push_back(made.pieces[item.index]);
    firstOfList.push_back(
        static_cast<std::uint32_t>(surfels.pieces.size() / surfels.piecesPerSurfel));
  }
  takeLists(firstOfList, objects, surfels);
  if (surfels.piecesPerSurfel > 1) coarsenToMean(outer, surfels);
  surfels.vertexOrder = orderVertices(surface, surfels.pieces);
  return surfels;
}

}  // namespace opaline::surfels
