#pragma once

#include "gpu/binding.h"

/// Bindings that many shaders have, by their names in GLSL. The C++ side of a shader that has all
/// of a group has the group instead; see cmake/shader_interface.py. Of groups that share bindings
/// the last one that fits is taken.
namespace opaline::shaders {

/// What lib/opaque_material.glsl needs.
struct SurfaceMaterials {
  gpu::Read opaques;
  gpu::Read attributes;
  gpu::Read tangents;
  gpu::Read texels;
};

/// What lib/light_through.glsl needs.
struct LightThrough {
  gpu::Texels pieceCorners;
  gpu::TexelsOrRays rayHierarchy;
  gpu::Read clusterPaints;
  gpu::Read ranges;
  gpu::Read clusterOfSurfel;
  gpu::Texels clusters;
};

/// What lib/seen.glsl needs.
struct SeenPlaces {
  gpu::Uniform frame;
  gpu::Sampled seenWords;
  gpu::Read meshIndices;
  gpu::Texels positions;
  gpu::Texels normals;
  gpu::Read meshObjects;
};

/// What lib/seen_list.glsl needs.
struct ListedPlaces {
  SeenPlaces seen;
  gpu::Read seenList;
  gpu::Uniform seenCount;
};

/// What lib/treelets.glsl needs.
struct TreeletOrder {
  gpu::Read links;
  gpu::Read treeletNodes;
  gpu::Read firstOfLevel;
  gpu::Read levelOfTreelet;
};

/// What lib/beam_tile.glsl needs.
struct BeamTile {
  gpu::Read objects;
  gpu::Read media;
  gpu::Texels points;
  gpu::Texels strengths;
  gpu::Texels beamNodes;
  gpu::Read tiles;
  gpu::Texels clusterTexels;
  gpu::Read clusters;
  gpu::Read lists;
  gpu::Read objectOfNode;
};

}  // namespace opaline::shaders
