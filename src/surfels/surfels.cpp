#include "surfels/surfels.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "surfels/clusters.h"

namespace opaline::surfels {

namespace {

// How much coarser the largest pieces become from one try to the next that fits the budget.
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

// The fewest pieces that each object may have at the spacing wanted. Pieces of a spacing h have at
// most the area √3/2 h², that of an equilateral triangle, and bisecting halves a spacing at most.
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

// The largest share such that objects which take what they want, or one share where that is less,
// take no more than the budget together.
double fairShare(std::vector<double> wanted, double budget) {
  std::sort(wanted.begin(), wanted.end());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const double share = budget / static_cast<double>(wanted.size() - i);
    if (wanted[i] > share) return share;
    budget -= wanted[i];
  }
  return wanted.back();
}

// As fine as wanted, or as the budget allows: a large object takes nothing from a small one that
// needs less than its share. The budget holds every triangle as one piece.
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

// The sides of parts thinner than what is joined, surfels or clusters, are further apart than such
// a group is large.
void tellSidesApart(const core::RestSurface& surface, std::span<const Piece> pieces,
                    std::uint32_t piecesPerSurfel, std::span<TreeItem> items) {
  double area = 0;
  for (const TreeItem& item : items) {
    const Piece& piece = pieces[item.index];
    area += static_cast<double>(piece.fraction) * areaMm2(surface, piece.triangle);
  }
  const double surfels = static_cast<double>(items.size()) / piecesPerSurfel;
  const double sizeMm = std::max(usualClusterMm(area), std::sqrt(area / surfels));
  for (TreeItem& item : items) {
    const std::array<double, 3> cross = crossOf(surface, pieces[item.index].triangle);
    const double length = std::hypot(cross[0], cross[1], cross[2]);
    for (std::size_t axis = 0; axis < 3 && length > 0; ++axis)
      item.facingMm[axis] = static_cast<float>(sizeMm * cross[axis] / length);
  }
}

// The pieces of each object as the tree's items, filled up with empty ones to whole surfels.
std::vector<std::vector<TreeItem>> itemsOfObjects(const core::RestSurface& surface,
                                                  std::vector<Piece>& pieces, std::size_t objects,
                                                  std::uint32_t piecesPerSurfel) {
  std::vector<std::vector<TreeItem>> items(objects);
  for (std::uint32_t i = 0; i < pieces.size(); ++i) {
    items[surface.objectOfTriangle[pieces[i].triangle]].push_back(
        {middleOfMm(surface, pieces[i]), i});
  }
  for (std::vector<TreeItem>& list : items) {
    tellSidesApart(surface, pieces, piecesPerSurfel, list);
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

// In the order in which the surfels' triangles meet them.
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

// Where surfels join triangles they are as large as the surface over their number.
void coarsenToMean(const core::RestSurface& surface, SurfelDivision& surfels) {
  std::vector<double> area(surfels.spacingOfObjectMm.size(), 0);
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t)
    area[surface.objectOfTriangle[t]] += areaMm2(surface, t);
  for (std::size_t i = 0; i < area.size(); ++i) {
    const std::uint32_t count = surfels.firstOfObject[i + 1] - surfels.firstOfObject[i];
    double& mm = surfels.spacingOfObjectMm[i];
    mm = std::max(mm, std::sqrt(area[i] / std::max(count, 1U)));
  }
}

// With every triangle one piece.
std::size_t leastSurfels(const core::RestSurface& surface, std::size_t objects,
                         std::uint32_t piecesPerSurfel) {
  std::vector<std::size_t> triangles(objects, 0);
  for (const std::uint32_t object : surface.objectOfTriangle) ++triangles[object];
  std::size_t surfels = 0;
  for (const std::size_t count : triangles)
    surfels += (count + piecesPerSurfel - 1) / piecesPerSurfel;
  return surfels;
}

}  // namespace

SurfelDivision makeSurfels(const core::RestSurface& surface,
                           std::span<const double> wantedSpacingMm, std::size_t maxSurfels) {
  const std::size_t objects = wantedSpacingMm.size();
  SurfelDivision surfels;
  while (leastSurfels(surface, objects, surfels.piecesPerSurfel) > maxSurfels &&
         surfels.piecesPerSurfel < surface.triangles.size()) {
    surfels.piecesPerSurfel *= 2;
  }
  // An object's last surfel may be a part of one: room for that is kept.
  const std::size_t full =
      surfels.piecesPerSurfel == 1 ? maxSurfels : maxSurfels - std::min(objects, maxSurfels);
  Cut made = cut(surface, wantedSpacingMm,
                 std::max(full * surfels.piecesPerSurfel, surface.triangles.size()));
  surfels.spacingOfObjectMm = std::move(made.spacingOfObjectMm);
  std::vector<std::vector<TreeItem>> items =
      itemsOfObjects(surface, made.pieces, objects, surfels.piecesPerSurfel);
  const std::vector<std::span<TreeItem>> spans(items.begin(), items.end());
  surfels.tree = makeTree(spans, surfels.piecesPerSurfel);

  surfels.firstOfObject.push_back(0);
  for (const std::vector<TreeItem>& list : items) {
    for (const TreeItem& item : list) surfels.pieces.push_back(made.pieces[item.index]);
    surfels.firstOfObject.push_back(
        static_cast<std::uint32_t>(surfels.pieces.size() / surfels.piecesPerSurfel));
  }
  if (surfels.piecesPerSurfel > 1) coarsenToMean(surface, surfels);
  surfels.vertexOrder = orderVertices(surface, surfels.pieces);
  return surfels;
}

}  // namespace opaline::surfels
