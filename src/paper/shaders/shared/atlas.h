// The atlas in storage buffers. Included by C++ and GLSL.
#ifndef OPALINE_PAPER_SHARED_ATLAS_H
#define OPALINE_PAPER_SHARED_ATLAS_H

#ifdef __cplusplus
#include <cstdint>
namespace opaline::shared {
using uint = std::uint32_t;  // NOLINT(readability-identifier-naming): GLSL's word
#endif

/// A corner in the atlas; several share a vertex along seams.
struct AtlasCorner {
  uint vertex;
  uint object;
  float u;
  float v;
  uint chart;
};

/// Where a chart lies in the map of neighbourhoods: place = uv · scale + shift.
struct ChartPlace {
  float shiftU;
  float shiftV;
  float scale;
};

/// A far sample of a vertex: its place in the map of cells, in [0,1]², and how much surface it
/// stands for, relative to what it would on a plane; 0 beyond the surface's border.
struct FarPlace {
  float u;
  float v;
  float weight;
};

#ifdef __cplusplus
}  // namespace opaline::shared
#endif

#endif
