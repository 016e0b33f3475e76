#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/rest_surface.h"
#include "gpu/buffer.h"
#include "gpu/image.h"
#include "opaline/medium.h"
#include "paper/atlas/atlas.h"

/// What the steps of the method pass to each other.
namespace opaline::paper {

/// What the method needs of a scene at rest.
struct RestScene {
  core::RestSurface surface;
  std::span<const Medium> media;
  std::span<const std::uint32_t> mediumOfObject;
  std::vector<double> areaOfObjectMm2;
};

/// A scene laid flat: its atlas, and its triangles by the atlas's corners.
struct FlatScene {
  int mapSize = 0;  ///< texels, edge of the map that it was packed for
  atlas::Atlas atlas;
  gpu::Buffer corners;        ///< shared::AtlasCorner, the atlas's vertices
  gpu::Buffer vertexCorners;  ///< shared::AtlasCorner, one for each vertex
  gpu::Buffer indices;        ///< into corners, three per triangle
  std::uint32_t indexCount = 0;

  double texelEdgeMm() const { return atlas.mmPerUnit / mapSize; }  ///< on the rest pose
};

/// The diffusion source map, and the same with the charts' neighbourhoods.
struct DiffusionSources {
  gpu::GpuImage positionArea;      ///< xyz mm, w mm²
  gpu::GpuImage normal;            ///< xyz
  gpu::GpuImage irradianceObject;  ///< rgb E, a object + 1
  gpu::GpuImage coverage;          ///< object + 1, 0 where no surface is
  gpu::GpuImage
      texelSurface;         ///< what a texel stands for: xy offset of the centroid, z area, texels
  gpu::Buffer charts;       ///< shared::ChartPlace
  gpu::Buffer nearOrigins;  ///< for each texel of the neighbourhoods, the packed texel of the map
  gpu::GpuImage nearPosition;  ///< xyz mm, w 1 where surface is
  gpu::GpuImage nearFlux;      ///< rgb E·A, a A in mm², 0 where no surface is
  gpu::Buffer farOrigins;      ///< the same in a layout for cells
  gpu::GpuImage farPosition;   ///< means over cells
  gpu::GpuImage farFlux;
  gpu::Buffer farPlaces;          ///< shared::FarPlace, eight per vertex
  std::uint32_t cellEdge = 1;     ///< of a cell, in texels of farOrigins
  std::uint32_t sourceCount = 0;  ///< texels that carry surface
};

/// The pattern of each medium.
struct PatternTable {
  gpu::Buffer entries;  ///< a shared::PatternHead and maxPatternEntries shared::PatternEntry each
  std::size_t stride = 0;  ///< bytes from one medium's pattern to the next
};

/// What frames of one kind read and write.
struct Map {
  DiffusionSources sources;
  PatternTable pattern;
};

}  // namespace opaline::paper
