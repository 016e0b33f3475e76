#pragma once

#include <algorithm>
#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "environment/sky.h"
#include "gpu/acceleration_structure.h"
#include "gpu/buffer.h"
#include "gpu/image.h"
#include "shaders/binding_groups.h"
#include "shaders/shared/frame.h"

/// What the passes hand to each other. A pass knows these, never another pass.
namespace opaline::passes {

/// The profile by which light scatters.
enum class ScatterTransport : std::uint32_t { Dipole = 0, BetterDipole = 1 };

/// Where light is summed: as shared::ObjectData has it for each object, or everywhere alike.
enum class ScatterSite : std::uint32_t { PerObject = 0, Vertices = 1, Fragments = 2 };

/// What moves the vertices: tables that stay, and what the host sets for every frame.
struct Motion {
  gpu::Buffer rest;            ///< shared::RestVertex, one a vertex
  gpu::Buffer firstDelta;      ///< one a vertex and one more
  gpu::Buffer deltas;          ///< shared::MorphDelta
  gpu::Buffer firstInfluence;  ///< one a vertex and one more
  gpu::Buffer influences;      ///< shared::JointInfluence
  gpu::Buffer edgeRange;       ///< uvec2 a vertex: first edge, number of edges
  gpu::Buffer edges;           ///< shared::TriangleEdge
  gpu::Buffer frame;           ///< shared::DeformFrame
  gpu::Buffer weights;         ///< float, of morph targets
  gpu::Buffer matrices;        ///< three vec4 a joint: the rows of an affine map
  gpu::Buffer objects;         ///< shared::ObjectMotion
  gpu::Buffer replaced;        ///< three floats a vertex, mm, where an object's are given
  bool hasDeltas = false;
  bool hasInfluences = false;
  bool normalsFromMesh = false;  ///< of any object in this frame
};

/// Some indices of a mesh.
struct IndexRange {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

/// The surface as it is in this frame.
struct DeformedMesh {
  gpu::Buffer positions;  ///< vec4 a vertex, mm
  gpu::Buffer normals;    ///< vec4 a vertex, unit; w -1 where the body is mirrored, else 1
  gpu::Buffer bounds;     ///< of the positions; see lib/bounds.glsl
  gpu::Buffer objectOf;   ///< uint a vertex
  gpu::Buffer indices;    ///< uint, of vertices, three a triangle
  std::uint32_t vertexCount = 0;
  std::uint32_t indexCount = 0;
  std::uint32_t castingIndexCount = 0;  ///< of those, which come first, that cast shadows
  std::vector<IndexRange> whole;        ///< of surfaces without holes; the rest has some
  std::vector<IndexRange> cutOut;
};

/// What the shaders know of opaque materials (shared/opaque.h). Where nothing is opaque it
/// holds no more than what is bound all the same.
struct OpaqueTables {
  gpu::Buffer materials;   ///< shared::OpaqueData
  gpu::Buffer texels;      ///< uvec2, half floats
  gpu::Buffer attributes;  ///< shared::VertexAttributes, one a vertex, where a material reads them
  gpu::Buffer tangents;    ///< shared::CornerTangents, one a triangle, where one has normals
  gpu::Buffer gloss;       ///< vec2 (passes/shade/gloss.h)
  gpu::Buffer lobes;       ///< vec4, as SceneTables::reflectionLobes, for each of some roughnesses
};

inline shaders::SurfaceMaterials surfaceMaterials(OpaqueTables& tables) {
  return {.opaques = tables.materials,
          .attributes = tables.attributes,
          .tangents = tables.tangents,
          .texels = tables.texels};
}

/// What the shaders know of paint (shared/paint.h). Where nothing is painted it holds no more than
/// what is bound all the same.
struct PaintTables {
  bool any = false;
  gpu::Buffer entries;         ///< shared::PaintEntry
  gpu::Buffer throughSurfels;  ///< vec4 a surfel: of diffuse light on it, what gets in
  gpu::Buffer clusters;        ///< shared::ClusterPaint
};

/// What the shaders know of translucent bodies whose surface has a roughness or normals of its own.
struct OwnSurfaces {
  bool any = false;
  bool anyNormals = false;
  gpu::Buffer tilts;  ///< vec4 a piece: its normal as lib/tilted_normal.glsl has it
};

struct SceneTables;

/// What tells where surfaces have holes.
struct CutOuts {
  SceneTables& tables;
  OpaqueTables& opaque;
};

/// What the shaders know of bodies and media.
struct SceneTables {
  gpu::Buffer objects;  ///< shared::ObjectData
  gpu::Buffer media;    ///< shared::MediumData
  std::uint32_t mediumCount = 0;
  bool followsLight = false;     ///< to its second collision in any medium; see shared/boundary.h
  bool scattersEvenly = true;    ///< every medium: g is 0
  bool entersAtSurface = false;  ///< diffuse light of some channel of some medium, as the diffusion
                                 ///< at the surface itself has it; see lib/boundary.glsl
  gpu::Buffer specularAlbedo;    ///< float, see MediumData::tables.w
  gpu::Buffer reflectionLobes;   ///< vec4, by the cosine of the view (lights/reflection_lobe.h)
  bool anyBacks = false;         ///< some opaque bodies have clusters of their back
  gpu::Buffer opaqueShares;      ///< shared::OpaqueShare a cluster, where something is opaque
  gpu::Buffer opaqueExitances;   ///< vec4 a cluster of an opaque body: of all light
  PaintTables paint;
  OwnSurfaces surfaces;
  std::vector<double> etas;  ///< the different ones, see MediumData::tables.x

  std::uint32_t sidesOfVertices() const { return anyBacks ? 2 : 1; }
};

/// All light that comes from everywhere, and all that passes know of it (lib/sky.glsl).
struct Sky {
  SkyParts parts;
  gpu::GpuImage radiance;    ///< by direction, a cube with levels for rays that stand for more
  gpu::Buffer bright;        ///< shared::BrightSky
  gpu::GpuImage irradiance;  ///< that enters by normal, one cube for each of SceneTables::etas
  gpu::GpuImage reflected;   ///< radiance as the surface's lobe sees it, a cube
  gpu::GpuImage glossy;      ///< as lobes of any roughness see it, a level for each
};

/// What a picture shows where no surface is.
struct Backdrop {
  gpu::GpuImage environment;  ///< latitude-longitude, with levels; of one dark texel without one
};

/// Lights, shadow views and camera of this frame, fitted to the surface: shared::FrameData.
struct FrameView {
  gpu::Buffer data;
  std::uint32_t shadowViews = 0;
};

/// Depth from the lights, one layer for each shadow view.
/// Some of a frame's shadow views.
using ShadowViews = std::bitset<shared::maxShadowViews>;

struct ShadowMaps {
  gpu::GpuImage depth;
  gpu::Buffer drawn;  ///< some maps before they are copied there, where invocations draw triangles
  std::uint32_t roomForViews = 0;
  bool cutOut = false;  ///< for surfaces with holes
};

/// A tree whose nodes frames fit to the surface (passes/fitted_tree.h).
struct FittedTree {
  gpu::Buffer links;  ///< which no frame changes
  gpu::Buffer leafNodes;
  gpu::Buffer treeletNodes;  ///< this and the next two as surfels::Treelets has them
  gpu::Buffer firstOfLevel;
  gpu::Buffer levelOfTreelet;
  std::vector<std::uint32_t> firstOfStage;  ///< treelets; one more than there are stages
  std::uint32_t leafCount = 0;
  std::uint32_t nodeCount = 0;
};

/// The surface as surfels and their tree.
struct Surfels {
  gpu::Buffer pieces;                 ///< shared::SurfelPiece
  std::uint32_t piecesPerSurfel = 1;  ///< that follow each other
  gpu::Buffer triangleOfPiece;        ///< uint, where normal textures want to know
  gpu::Buffer piecesOfTriangles;      ///< for each triangle and the end where its pieces begin in
                                      ///< the list of pieces that follows
  std::uint32_t triangleCount = 0;
  gpu::Buffer sources;       ///< shared::Source, sourcesPerSurfel of each
  gpu::Buffer normals;       ///< vec4 a surfel, unit
  gpu::Buffer skyShares;     ///< vec4 a surfel: of the sky's irradiance, what enters
  gpu::Buffer visibilities;  ///< of lights, where boundary transport reads them: a
                             ///< word for each and each piece, see lib/piece.glsl
  std::uint32_t lights = 0;  ///< that there is room for
  std::uint32_t count = 0;   ///< of surfels
  gpu::Buffer nodes;         ///< shared::TreeNode, depth first
  gpu::Buffer boxes;         ///< shared::NodeBox, one a node
  FittedTree tree;
  bool coarse = false;      ///< of any object: wants what NearbyPass adds
  gpu::Buffer vertexOrder;  ///< vertices, neighbours in space together
  gpu::Buffer places;       ///< vec4 a surfel, mm
  gpu::Buffer objectOf;     ///< uint a surfel
  gpu::Buffer order;        ///< every surfel's own index
};

/// Where light is summed in a compute shader of one invocation a place: vertices or surfels.
struct Places {
  gpu::Buffer& positions;  ///< vec4, mm
  gpu::Buffer& normals;    ///< vec4, unit
  gpu::Buffer& objectOf;   ///< uint
  gpu::Buffer& order;      ///< neighbours in space together
  gpu::Buffer& exitances;  ///< vec4
  std::uint32_t count = 0;
};

/// The surface of this frame for rays (lib/rays.glsl): texel buffers on the surfels' tree and,
/// where the device has ray queries, what it sends rays through itself.
struct RayHierarchy {
  gpu::Buffer corners;                   ///< shared::RayPiece, one a piece
  gpu::Buffer boxes;                     ///< shared::RayUnits, then a shared::RayBox for each node
  gpu::AccelerationStructure structure;  ///< of the pieces, a body an object; or none
};

/// Light in the body under each cluster: points where it collides.
struct Beams {
  gpu::Buffer points;        ///< shared::BeamPoint, maxPoints a cluster and light
  gpu::Buffer collisions;    ///< shared::FirstCollision, maxFirstPoints a cluster and light
  gpu::Buffer strengths;     ///< vec4 a cluster and light: power that entered; numbers of points
  gpu::Buffer strongest;     ///< largest power of those that are followed to second collisions, a
                             ///< float's bits
  gpu::Buffer guided;        ///< shared::Guided, pathsOfBeam a cluster and light
  std::uint32_t room = 1;    ///< lights that there is room for
  std::uint32_t lights = 1;  ///< whose points are there
};

/// Clusters of surfels, their tree, and what boundary transport makes of them in a frame.
struct Clusters {
  gpu::Buffer ranges;           ///< shared::ClusterRange
  gpu::Buffer clusterOfSurfel;  ///< one a surfel, of its front
  std::uint32_t patchCount = 0;
  gpu::Buffer patches;        ///< vec4 a patch: its middle, mm, and its area, mm²
  gpu::Buffer objectOfPatch;  ///< uint a patch
  FittedTree tree;
  std::uint32_t count = 0;           ///< of clusters
  std::uint32_t partsOfSurfels = 1;  ///< of the largest, shared::surfelsOfPart
  bool haveSeveralMedia = false;     ///< those of some body
  gpu::Buffer objectOfNode;          ///< uint a node of their tree: that of most clusters below
  bool haveLinings = false;  ///< some are of opaque things in bodies, where their light ends
  std::uint32_t tileCount = 0;
  gpu::Buffer tiles;  ///< shared::ClusterTile
  std::uint32_t groupCount = 0;
  gpu::Buffer groups;  ///< shared::ClusterGroup
  std::uint32_t innerCount = 0;
  std::uint32_t smallInnerCount = 0;  ///< those of few clusters, which come first
  gpu::Buffer inner;                  ///< shared::InnerNode
  gpu::Buffer lists;                  ///< interaction lists: roomOfList a tile
  std::uint32_t roomOfList = 0;       ///< of numbers
  gpu::Buffer around;                 ///< clusters felt in each tile: shared::roomOfAround
  gpu::Buffer clusters;               ///< shared::Cluster
  gpu::Buffer nodes;                  ///< shared::ClusterNode
  gpu::Buffer entries;                ///< shared::Entry a cluster for each light, then
                                      ///< for what comes from everywhere
  std::uint32_t lights = 0;           ///< of the frame
  gpu::Buffer meetings;               ///< shared::Meeting, of the rays outwards of each cluster
  std::uint32_t raysOutwards = 0;     ///< of each cluster
  Beams fromLights;                   ///< of a few lights after the other
  Beams fromEverywhere;
  gpu::Buffer mirrored;    ///< shared::Mirrored a cluster and light, of a few after the other
  gpu::Buffer peaks;       ///< largest power of those, a float's bits, at the first of the lights
  gpu::Buffer sums;        ///< of those, three whole numbers a cluster; 0 between lights
  gpu::Buffer guidedSums;  ///< of guided light, three whole numbers a cluster, of lights and then
                           ///< of what comes from everywhere
  gpu::Buffer arrived;     ///< vec4 a cluster: power that enters after it was mirrored
  gpu::Buffer beamNodes;   ///< shared::BeamNode, of the trees of lib/beam_trees.glsl
  std::uint32_t mostNodesOfBody = 0;  ///< of the tree
  std::uint32_t roomOfBeamList = 0;
  gpu::Buffer beamLists;         ///< of each tree and group: how many nodes, and which
  gpu::Buffer beamCoefficients;  ///< none before a frame solves; shared::texelsOfPoints an entry
                                 ///< of what is kept of lists, of what comes from everywhere
  gpu::Buffer keptBeams;         ///< that: see shared::countsOfKept
  std::uint32_t roomOfKept = 0;  ///< of entries, of all tiles and kinds
  gpu::Buffer sources;           ///< vec4 a cluster: fluence in a medium without end
  gpu::Buffer skyShares;         ///< vec4 a cluster: of the sky's irradiance, what enters
  gpu::Buffer entered;        ///< vec4 a cluster: irradiance of the diffuse light that entered last
  gpu::Buffer enteredBefore;  ///< the same of light before that, where it is mirrored to one side
  gpu::Buffer power;          ///< vec4: of all diffuse light of the last bounce but one, then what
                              ///< further bounces add to the last
  gpu::Buffer latest;         ///< vec4 a cluster: exitance of the light that entered last
  gpu::Buffer exitances;      ///< vec4 a cluster: of all light; of an opaque body the irradiance
                              ///< that surfaces do not find for themselves
  gpu::Buffer nearby;  ///< vec4 a cluster: exitance that a half-space would have of the light that
                       ///< entered here, of all but further bounces; w: 1 over the thickness, 1/mm
  gpu::Buffer bareLights;       ///< shared::BareLight, of painted bodies
  gpu::Buffer means;            ///< vec4 a cluster: exitance of a half-space
  gpu::Buffer exitancesWithin;  ///< vec4 a patch or surfel: of a half-space
};

/// What the solver of boundary transport works with.
struct Solver {
  gpu::Buffer coefficients;  ///< none before a frame solves; shared::texelsOfActions a node of a
                             ///< tile's list
  std::uint32_t roomOfCoefficients = 0;  ///< of nodes a tile; those of the others are not kept
  gpu::Buffer densities;                 ///< shared::DensityNode
  gpu::Buffer products;                  ///< vec4 a cluster
  gpu::Buffer basis;                     ///< vec4 a cluster for each step and one more
  gpu::Buffer sums;                      ///< vec4, of tiles
  gpu::Buffer states;                    ///< shared::SolverState, of every solution of a frame
};

/// What else is kept of surfaces that the camera sees.
struct KeptOfSeen {
  bool materials = false;  ///< of opaque ones, of translucent surfaces of their own, or what
                           ///< translucent ones mirror of bodies
  bool paint = false;      ///< of painted ones
  bool origins = false;    ///< of those with an inside
  bool ofPixels = false;   ///< for passes that look at neighbours
  bool drawn = false;      ///< triangles of all samples, if the device draws these at once

  bool operator==(const KeptOfSeen&) const = default;
};

/// Some of the surfaces that the camera sees: where light is summed at first, where it is summed
/// since it cannot be interpolated, and where it has to be asked whether sky is mirrored.
enum class Asked : std::uint32_t { Knots, InWideBlocks, InNarrowBlocks, OfSky };
constexpr std::size_t askedLists = 4;

/// Which surfaces the camera sees (shared/seen.h), and what is found of them. The lists are those
/// of one band of the picture after the other, since a pixel may see as many as it has samples.
struct VisibleSurfaces {
  gpu::GpuImage words;  ///< a layer for each sample; a pixel's surfaces are in the first layers
  gpu::GpuImage depth;  ///< of each sample, or of one after the other
  gpu::GpuImage drawn;  ///< triangles that all samples see, where hardware draws these at once
  gpu::GpuImage drawnDepth;
  gpu::Buffer nearest;  ///< the same where invocations do (lib/sample_words.glsl), uint
  gpu::Buffer nearestDepth;
  bool drawnAtOnce = false;  ///< of the picture that was recorded last
  gpu::Buffer mixed;         ///< pixels that see several triangles
  gpu::Buffer mixedCount;    ///< shared::SeenCount
  gpu::Buffer list;          ///< surfaces; those of a pixel follow each other
  gpu::Buffer counts;        ///< shared::SeenCount, of all and of parts
  gpu::Buffer light;         ///< vec4 for each on the list: its exitance, then its radiance
  gpu::Buffer skyShares;     ///< float for each, of what it mirrors
  gpu::Buffer materials;     ///< shared::SeenMaterial for each, of opaque surfaces and such as have
                             ///< their own
  gpu::Buffer paint;    ///< vec4 for each: what has entered at the surface of painted bodies, then
                        ///< of what leaves the part that goes towards the camera, over that without
  gpu::Buffer origins;  ///< vec4 for each: where the light that leaves comes from (lib/origin.glsl)
  std::array<gpu::Buffer, 2> ofPixels;  ///< 16 bytes for each pixel of a band: what passes find
                                        ///< that look at neighbours
  KeptOfSeen kept;                      ///< there is room for these
  gpu::GpuImage skyBlocks;   ///< of 2×2 pixels: how much of what they mirror is sky, or unknown
  gpu::Buffer entryOfPixel;  ///< uint for each pixel of a band: its first surface in the list
  std::array<gpu::Buffer, 2> blocks;  ///< uint for each narrow block (lib/blocks.glsl) of a band,
                                      ///< at first and after light of wide ones is interpolated
  gpu::Buffer asked;  ///< one of the lists of Asked after the other, as entries of the list of all
  std::array<gpu::Buffer, askedLists> askedCounts;  ///< shared::SeenCount, of all and of parts
  std::uint32_t rowsOfBand = 0;
  std::uint32_t parts = 0;  ///< of the list, at most

  /// Of the band that begins there.
  std::uint32_t rowsFrom(std::uint32_t firstRow) const {
    return std::min(rowsOfBand, words.extent().height - firstRow);
  }
  gpu::Buffer& countsOf(Asked list) { return askedCounts[static_cast<std::size_t>(list)]; }
};

/// The surfaces on the list, with what tells where they lie (lib/seen_list.glsl).
struct SeenSurfaces {
  FrameView& frame;
  DeformedMesh& mesh;
  VisibleSurfaces& surfaces;
};

inline shaders::SeenPlaces seenPlaces(const SeenSurfaces& seen, const gpu::Sampler& nearest) {
  return {.frame = seen.frame.data,
          .seenWords = {seen.surfaces.words, nearest},
          .meshIndices = seen.mesh.indices,
          .positions = seen.mesh.positions,
          .normals = seen.mesh.normals,
          .meshObjects = seen.mesh.objectOf};
}

inline shaders::ListedPlaces listedPlaces(const SeenSurfaces& seen, const gpu::Sampler& nearest) {
  return {.seen = seenPlaces(seen, nearest),
          .seenList = seen.surfaces.list,
          .seenCount = seen.surfaces.counts};
}

/// What the pixels' centres see.
struct SeenCentres {
  gpu::GpuImage position;  ///< xyz mm, w object + 1
  gpu::GpuImage normal;    ///< xyz unit, towards the camera; w -1 where that is inwards, else 1
  gpu::GpuImage exitance;  ///< rgb B, a evaluations
};

/// Exitance B of the vertices, of opaque bodies irradiance, all of it or, for the paper's
/// fragments, the far samples' part. Where something is opaque, irradiance on the backs of sheets
/// follows. What is summed at fragments is VisibleSurfaces::light.
struct Exitance {
  gpu::Buffer vertices;
  gpu::Buffer origins;  ///< vec4 a vertex of bodies with an inside: where that light comes from
                        ///< (lib/origin.glsl)
};

/// Which surfels the camera sees.
struct SeenSurfels {
  gpu::GpuImage image;  ///< surfel; cluster, or -1; node of the tree; 1. All -1 where none is.
};

inline Places verticesOf(DeformedMesh& mesh, Surfels& surfels, Exitance& exitance) {
  return {mesh.positions,      mesh.normals,      mesh.objectOf,
          surfels.vertexOrder, exitance.vertices, mesh.vertexCount};
}

inline Places surfelsOf(Surfels& surfels, Clusters& clusters) {
  return {surfels.places, surfels.normals,          surfels.objectOf,
          surfels.order,  clusters.exitancesWithin, surfels.count};
}

/// Of bodies whose surfels are not coarse; nobody asks for normals there.
inline Places patchesOf(Surfels& surfels, Clusters& clusters) {
  return {clusters.patches, surfels.normals,          clusters.objectOfPatch,
          surfels.order,    clusters.exitancesWithin, clusters.patchCount};
}

}  // namespace opaline::passes
