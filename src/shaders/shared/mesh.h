// The layout of vertices in storage buffers. Included by C++ and GLSL.
#ifndef OPALINE_SHARED_MESH_H
#define OPALINE_SHARED_MESH_H

#ifdef __cplusplus
#include <cstddef>
#include <cstdint>
namespace opaline::shared {
using uint = std::uint32_t;
#endif

/// A corner in the atlas; several share a vertex along seams.
struct AtlasCorner {
  uint vertex;
  uint object;
  float u;
  float v;
  uint chart;
  float alongU;  // unit direction in the atlas in which the surface rises most, along +y
  float alongV;
};

/// Where a chart lies in the two maps of neighbourhoods: place = uv · scale + shift.
struct ChartPlaces {
  float nearShiftU;
  float nearShiftV;
  float nearScale;
  float farShiftU;
  float farShiftV;
  float farScale;
};

#ifdef __cplusplus
static_assert(sizeof(AtlasCorner) == 28);
static_assert(offsetof(AtlasCorner, u) == 8);
static_assert(sizeof(ChartPlaces) == 24);
}  // namespace opaline::shared
#endif

#endif
