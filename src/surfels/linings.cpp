#include "surfels/linings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "surfels/box.h"
#include "surfels/clusters.h"
#include "surfels/winding.h"

namespace opaline::surfels {

namespace {

// How far a solid has to reach into a body, in diagonals of the body. A solid that stands upon the
// body, or exactly fills a hole made for it, does not count.
constexpr double reachesIn = 1e-4;

// Size of pieces relative to the body's usual clusters; the smallest clusters have this size, too.
constexpr double pieceOverCluster = 0.25;

// The limit for pieces beyond one per triangle; beyond it pieces become larger.
constexpr std::size_t mostMorePieces = 100'000;
constexpr double coarserLinings = 1.5;

Vector moved(const Vector& place, double by, const Vector& along) {
  Vector sum = place;
  addTimes(by, along, sum);
  return sum;
}

Box boxOf(const core::RestSurface& surface, std::span<const std::uint32_t> triangles) {
  Box box;
  for (const std::uint32_t t : triangles)
    for (const std::uint32_t vertex : surface.triangles[t])
      box.include(vectorOf(surface.positionsMm[vertex]));
  return box;
}

// A piece, turned round: its second and third corner change places.
Piece turned(const Piece& piece, std::uint32_t triangle) {
  Piece other = piece;
  other.triangle = triangle;
  std::swap(other.corners[1], other.corners[2]);
  for (std::array<float, 2>& corner : other.corners) std::swap(corner[0], corner[1]);
  return other;
}

Triangle turned(const Triangle& triangle) {
  return {triangle[0], triangle[2], triangle[1]};
}

}  // namespace

// Results of the search that are kept for Linings::isCovered().
struct Linings::Solids {
  std::map<std::uint32_t, WindingNumber> bodies;  // by their object
  std::map<std::uint32_t, WindingNumber> solids;
  std::map<std::uint32_t, std::vector<std::uint32_t>> solidsOfBody;  // those that line the body

  double reachMm(std::uint32_t body) const { return reachesIn * bodies.at(body).box().diagonal(); }
};

class Linings::Finder {
 public:
  Finder(const core::RestSurface& surface, std::span<const Substance> substances)
      : surface_(surface), found_(std::make_shared<Solids>()) {
    for (std::uint32_t t = 0; t < surface.triangles.size(); ++t)
      if (substances[t] != Substance::Other)
        of_[substances[t]][surface.objectOfTriangle[t]].push_back(t);
    // Most scenes have no linings, so boxes are compared first.
    std::map<std::uint32_t, Box> boxes;
    for (const auto& [substance, objects] : of_)
      for (const auto& [object, triangles] : objects)
        if (substance != Substance::Medium) boxes[object].include(boxOf(surface, triangles));
    for (const auto& [body, triangles] : of_[Substance::Medium]) {
      const Box box = boxOf(surface, triangles);
      bool any = false;
      for (const auto& [object, other] : boxes) {
        if (!box.meets(other)) continue;
        any = true;
        const auto solid = of_[Substance::Solid].find(object);
        if (solid == of_[Substance::Solid].end()) continue;
        mostPieces_ += solid->second.size();
        if (!found_->solids.contains(object))
          found_->solids.emplace(object, WindingNumber(surface, solid->second));
      }
      if (any) found_->bodies.emplace(body, WindingNumber(surface, triangles));
    }
  }

  void findInto(Linings& made) const {
    made.firstTriangle_ = static_cast<std::uint32_t>(surface_.triangles.size());
    for (double coarser = 1; !line(coarser, made); coarser *= coarserLinings) {
    }
    if (made.any()) {
      made.triangles_.insert(made.triangles_.begin(), surface_.triangles.begin(),
                             surface_.triangles.end());
      made.objectOfTriangle_.insert(made.objectOfTriangle_.begin(),
                                    surface_.objectOfTriangle.begin(),
                                    surface_.objectOfTriangle.end());
      made.solids_ = found_;
    }
    findSheets(made);
  }

 private:
  double usualMm(std::uint32_t body) const {
    double area = 0;
    for (const std::uint32_t t : of_.at(Substance::Medium).at(body)) area += areaMm2(surface_, t);
    return usualClusterMm(area);
  }

  // False if that takes too many pieces.
  bool line(double coarser, Linings& made) const {
    made.triangles_.clear();
    made.objectOfTriangle_.clear();
    made.triangleOfSolid_.clear();
    made.pieces_.clear();
    found_->solidsOfBody.clear();
    for (const auto& [body, inside] : found_->bodies) {
      const double spacingMm = coarser * pieceOverCluster * usualMm(body);
      if (!(spacingMm > 0)) continue;
      for (const auto& [solid, outside] : found_->solids) {
        if (!inside.box().meets(outside.box())) continue;
        const std::size_t before = made.pieces_.size();
        for (const std::uint32_t t : of_.at(Substance::Solid).at(solid))
          if (!lineBy(t, body, solid, spacingMm, made)) return false;
        if (made.pieces_.size() > before) found_->solidsOfBody[body].push_back(solid);
      }
    }
    return true;
  }

  bool lineBy(std::uint32_t triangle, std::uint32_t body, std::uint32_t solid, double spacingMm,
              Linings& made) const {
    Vector normal = crossOf(surface_, triangle);
    const double length = lengthOf(normal);
    if (!(length > 0)) return true;
    for (double& axis : normal) axis /= length;
    const WindingNumber& inside = found_->bodies.at(body);
    const auto nearBody = [&](const std::array<Vector, 3>& corners) {
      Box box;
      for (const Vector& corner : corners) box.include(corner);
      return inside.box().meets(box);
    };
    const std::optional<std::vector<Piece>> pieces =
        subdivideWhere(surface_, triangle, spacingMm, mostPieces_ - made.pieces_.size(), nearBody);
    if (!pieces) return false;
    const auto its = static_cast<std::uint32_t>(made.firstTriangle_ + made.triangleOfSolid_.size());
    bool any = false;
    for (const Piece& piece : *pieces) {
      if (!isLining(vectorOf(middleOfMm(surface_, piece)), normal, body, solid)) continue;
      made.pieces_.push_back(turned(piece, its));
      any = true;
    }
    if (!any) return true;
    made.triangles_.push_back(turned(surface_.triangles[triangle]));
    made.objectOfTriangle_.push_back(body);
    made.triangleOfSolid_.push_back(triangle);
    return true;
  }

  // Whether a place on a solid has the body's medium on one side, and the body would continue on
  // the other.
  bool isLining(const Vector& place, const Vector& normal, std::uint32_t body,
                std::uint32_t solid) const {
    const WindingNumber& inside = found_->bodies.at(body);
    const double reach = found_->reachMm(body);
    const Vector before = moved(place, reach, normal);
    if (!inside.isInside(before) || !inside.isInside(moved(place, -reach, normal))) return false;
    return std::none_of(found_->solids.begin(), found_->solids.end(), [&](const auto& other) {
      return other.first != solid && other.second.isInside(before);
    });
  }

  void findSheets(Linings& made) const {
    const auto sheets = of_.find(Substance::Sheet);
    if (sheets == of_.end()) return;
    for (const auto& [object, triangles] : sheets->second) {
      for (const auto& [body, inside] : found_->bodies) {
        std::size_t within = 0;
        for (const std::uint32_t t : triangles)
          within += inside.isInside(vectorOf(surface_.positionsMm[surface_.triangles[t][0]]));
        if (2 * within <= triangles.size()) continue;
        made.sheetsInside_.push_back(object);
        break;
      }
    }
  }

  const core::RestSurface& surface_;
  std::map<Substance, std::map<std::uint32_t, std::vector<std::uint32_t>>> of_;  // triangles
  std::shared_ptr<Solids> found_;
  std::size_t mostPieces_ = mostMorePieces;
};

Linings::Linings(const core::RestSurface& surface, std::span<const Substance> substanceOfTriangle) {
  Finder(surface, substanceOfTriangle).findInto(*this);
}

core::RestSurface Linings::lined(const core::RestSurface& surface) const {
  if (!any()) return surface;
  return {surface.positionsMm, triangles_, objectOfTriangle_};
}

bool Linings::isCovered(std::uint32_t object, const Vector& placeMm, const Vector& normal) const {
  if (!any()) return false;
  const auto found = solids_->solidsOfBody.find(object);
  if (found == solids_->solidsOfBody.end()) return false;
  const double reach = solids_->reachMm(object);
  return std::any_of(found->second.begin(), found->second.end(), [&](std::uint32_t solid) {
    const WindingNumber& its = solids_->solids.at(solid);
    return its.isInside(moved(placeMm, reach, normal)) &&
           its.isInside(moved(placeMm, -reach, normal));
  });
}

}  // namespace opaline::surfels
