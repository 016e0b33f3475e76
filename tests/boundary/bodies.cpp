#include "boundary/bodies.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "icosphere.h"

namespace opaline::test::boundary {

using namespace reference;

namespace {

struct Surface {
  std::vector<Vector> positionsMm;
  std::vector<Triangle> triangles;
};

Surface unitSphere(int divisions) {
  const Icosphere sphere = icosphere(divisions);
  Surface s{sphere.directions, sphere.triangles};
  double area = 0;
  for (const Triangle& t : s.triangles) {
    const Vector& a = s.positionsMm[t[0]];
    area += length(cross(s.positionsMm[t[1]] - a, s.positionsMm[t[2]] - a)) / 2;
  }
  for (Vector& p : s.positionsMm) p = std::sqrt(4 * std::numbers::pi / area) * p;
  return s;
}

reference::Scene sceneOf(Surface surface) {
  Body body;
  body.normals.resize(surface.positionsMm.size());
  for (const Triangle& t : surface.triangles) {
    const Vector& a = surface.positionsMm[t[0]];
    const Vector normal = cross(surface.positionsMm[t[1]] - a, surface.positionsMm[t[2]] - a);
    for (const std::uint32_t corner : t) body.normals[corner] += normal;
  }
  for (Vector& normal : body.normals) normal = unitOr(normal, {0, 0, 1});
  body.positionsMm = std::move(surface.positionsMm);
  body.triangles = std::move(surface.triangles);
  body.medium = {"any", {1, 1, 1}, {0.1, 0.1, 0.1}, 1.3};
  reference::Scene scene;
  scene.camera.positionMm = {0, 0, 1000};
  scene.bodies.push_back(std::move(body));
  return scene;
}

ClusteredBody everyTriangle(Surface surface) {
  ClusteredBody body;
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) body.clusterOfTriangle.push_back(t);
  body.scene = sceneOf(std::move(surface));
  return body;
}

/// A box of square cells; vertices are shared.
class BoxOfCells {
 public:
  BoxOfCells(double halfWidthMm, double thicknessMm, int cells)
      : halfWidthMm_(halfWidthMm),
        edgeMm_(2 * halfWidthMm / cells),
        layers_(std::max(1, static_cast<int>(std::lround(thicknessMm / edgeMm_)))),
        heightMm_(thicknessMm / layers_) {}

  int layers() const { return layers_; }

  using Place = std::array<int, 3>;
  void add(const Place& a, const Place& b, const Place& c, const Place& d) {
    const std::array<std::uint32_t, 4> at{vertex(a), vertex(b), vertex(c), vertex(d)};
    surface.triangles.push_back({at[0], at[1], at[2]});
    surface.triangles.push_back({at[0], at[2], at[3]});
    cellOfTriangle.insert(cellOfTriangle.end(), 2, cells_++);
  }

  Surface surface;
  std::vector<std::uint32_t> cellOfTriangle;

 private:
  std::uint32_t vertex(const Place& place) {
    const auto [found, isNew] =
        vertices_.try_emplace(place, static_cast<std::uint32_t>(surface.positionsMm.size()));
    if (isNew) {
      surface.positionsMm.push_back({place[0] * edgeMm_ - halfWidthMm_,
                                     place[1] * edgeMm_ - halfWidthMm_, -place[2] * heightMm_});
    }
    return found->second;
  }

  double halfWidthMm_;
  double edgeMm_;
  int layers_;
  double heightMm_;
  std::map<Place, std::uint32_t> vertices_;
  std::uint32_t cells_ = 0;
};

}  // namespace

ClusteredBody sphere(double radiusMm, int divisions) {
  Surface surface = unitSphere(divisions);
  for (Vector& p : surface.positionsMm) p = radiusMm * p;
  return everyTriangle(std::move(surface));
}

ClusteredBody hollowSphere(double outerRadiusMm, double innerRadiusMm, int divisions) {
  const Surface unit = unitSphere(divisions);
  Surface surface;
  const auto first = static_cast<std::uint32_t>(unit.positionsMm.size());
  for (const Vector& p : unit.positionsMm) surface.positionsMm.push_back(outerRadiusMm * p);
  for (const Vector& p : unit.positionsMm) surface.positionsMm.push_back(innerRadiusMm * p);
  surface.triangles = unit.triangles;
  for (const Triangle& t : unit.triangles)
    surface.triangles.push_back({t[0] + first, t[2] + first, t[1] + first});
  return everyTriangle(std::move(surface));
}

ClusteredBody slab(double halfWidthMm, double thicknessMm, int cells) {
  BoxOfCells box(halfWidthMm, thicknessMm, cells);
  const int n = cells;
  const int m = box.layers();
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) box.add({i, j, 0}, {i + 1, j, 0}, {i + 1, j + 1, 0}, {i, j + 1, 0});
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) box.add({i, j, m}, {i, j + 1, m}, {i + 1, j + 1, m}, {i + 1, j, m});
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < m; ++k) {
      box.add({i, 0, k}, {i, 0, k + 1}, {i + 1, 0, k + 1}, {i + 1, 0, k});
      box.add({i, n, k}, {i + 1, n, k}, {i + 1, n, k + 1}, {i, n, k + 1});
      box.add({0, i, k}, {0, i + 1, k}, {0, i + 1, k + 1}, {0, i, k + 1});
      box.add({n, i, k}, {n, i, k + 1}, {n, i + 1, k + 1}, {n, i + 1, k});
    }
  return {sceneOf(std::move(box.surface)), std::move(box.cellOfTriangle)};
}

}  // namespace opaline::test::boundary
