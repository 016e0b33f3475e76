#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "reference/geometry.h"

namespace opaline::reference {

/// Pieces of the surfaces of media, or of opaque bodies, on which light is counted. Triangles
/// larger than a cell are divided into equal parts. Parts in one cube of that edge count as one
/// cell if their normals are nearest to the same axis. Far out on a ground, cells are larger.
class Cells {
 public:
  enum class Of { Media, Opaque };
  Cells(const Scene& scene, double edgeMm, Of of);

  std::size_t count() const { return areasMm2_.size(); }
  double areaMm2(std::size_t cell) const { return areasMm2_[cell]; }
  /// The cell of a point of the surface.
  std::size_t at(const SurfacePoint& point) const;

  /// A piece of a triangle within one cell.
  struct Part {
    std::size_t cell = 0;
    std::size_t body = 0;
    double areaMm2 = 0;
    Vector middleMm{};
    Vector normal{};  ///< unit, of the triangle
  };
  /// `scene` must be the one of the cells.
  void forEachPart(const Scene& scene, const std::function<void(const Part&)>& visit) const;

 private:
  /// How a triangle is divided: into n² equal triangles.
  struct Division {
    std::uint32_t firstPart = 0;
    std::uint32_t edgeParts = 1;
  };
  static std::uint32_t partOf(std::uint32_t edgeParts, const std::array<double, 3>& weights);

  std::vector<std::vector<Division>> divisions_;  ///< by body and triangle
  std::vector<std::uint32_t> cellOfPart_;
  std::vector<double> areasMm2_;
};

}  // namespace opaline::reference
