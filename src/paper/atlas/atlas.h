#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/rest_surface.h"
#include "opaline/types.h"

namespace opaline::atlas {

struct AtlasOptions {
  int mapSize = 512;  ///< edge of the map the gutters are made for, texels, in [64, 4096]
  int gutter = 2;  ///< least distance of two charts, texels, in [1, 16]; less only where there are
                   ///< more charts than such a map has room for
};

/// One corner position in the atlas. A mesh vertex on a seam has several.
struct AtlasVertex {
  std::uint32_t vertex = 0;  ///< index into RestSurface::positionsMm
  Vec2 uv{};                 ///< in [0,1]²
};

struct AtlasStatistics {
  std::size_t charts = 0;
  double coverage = 0;           ///< texels whose centre lies in a triangle, of all
  double areaDistortionRms = 0;  ///< rms over the surface of ln(uv area : surface area, over mean)
  double seconds = 0;
};

/// An equiareal atlas: charts laid out in the unit square without overlap and without mirrored
/// triangles, every chart scaled to its true area.
struct Atlas {
  std::vector<AtlasVertex> vertices;
  std::vector<Triangle> triangles;  ///< indices into vertices; order of RestSurface::triangles
  std::vector<std::uint32_t> chartOfTriangle;
  double mmPerUnit = 0;  ///< sqrt(surface area / uv area): edge of the unit square, mm
  AtlasStatistics statistics;
};

/// Flattens any set of triangles; charts never cross objects, and without a table of these all is
/// one. Never fails for finite positions and valid indices. Vertices that
/// share a position are one vertex to it. Degenerate triangles get zero uv area.
Atlas makeAtlas(const core::RestSurface& surface, const AtlasOptions& options = {});

}  // namespace opaline::atlas
