#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "opaline/export.h"
#include "opaline/image.h"
#include "opaline/scene.h"
#include "opaline/types.h"

namespace opaline {

/// The map that an atlas is made for.
struct AtlasOptions {
  int mapSize = 512;  ///< edge of the map, in whose texels gutters are measured, in [64, 4096]
  int gutter = 2;  ///< least distance between charts, texels, in [1, 16]; less only if the map has
                   ///< no room for so many charts
};

/// A vertex and its place in the atlas. A vertex on a seam has several.
struct AtlasVertex {
  std::uint32_t vertex = 0;  ///< counted through the meshes of all objects
  Vec2 uv{};                 ///< in [0,1]²
};

/// How an atlas came out.
struct AtlasStatistics {
  std::size_t charts = 0;
  double coverage = 0;           ///< share of texels whose centre lies in a triangle
  double areaDistortionRms = 0;  ///< rms over the surface of ln(uv area / surface area, relative to
                                 ///< its mean)
  double seconds = 0;            ///< time that making it took
};

/// An equiareal atlas: charts laid out in the unit square without overlap and without mirrored
/// triangles, every chart scaled to its true area.
struct Atlas {
  std::vector<AtlasVertex> vertices;
  /// Indices into vertices: the triangles of all objects, in their order.
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> chartOfTriangle;
  double mmPerUnit = 0;  ///< sqrt(surface area / uv area): edge of the unit square, mm
  AtlasStatistics statistics;
};

/// Texture coordinates for a whole scene, for baking light or painting. The diffusion source map of
/// Sum::Pattern uses them too. Charts never cross from one object to another. Vertices that share a
/// position count as one. Degenerate triangles get no area. Throws UsageError for options out of
/// range, positions that are not finite and triangles that name vertices that do not exist.
OPALINE_API Atlas makeAtlas(const Scene& scene, const AtlasOptions& options = {});

/// A picture of the charts, each in its own colour on a dark ground, with triangles told apart by
/// shade and borders outlined. Linear values; v grows downwards. Throws UsageError unless the size
/// is in [16, 16384] pixels.
OPALINE_API Image drawAtlas(const Atlas& atlas, int size);

}  // namespace opaline
