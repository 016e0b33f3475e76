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

/// Data that passes hand to each other. A pass depends on these, never on another pass.
namespace opaline::passes {

/// The profile by which light scatters.
enum class ScatterTransport : std::uint32_t { Dipole = 0, BetterDipole = 1 };

/// Where light is summed: as shared::ObjectData says for each object, or in the same way for all.
enum class ScatterSite : std::uint32_t { PerObject = 0, Vertices = 1, Fragments = 2 };

/// What moves the vertices: constant tables, and data that the host sets for every frame.
struct Motion {
  gpu::Buffer rest;            ///< shared::RestVertex, one per vertex
  gpu::Buffer firstDelta;      ///< one per vertex and one more
  gpu::Buffer deltas;          ///< shared::MorphDelta
  gpu::Buffer firstInfluence;  ///< one per vertex and one more
  gpu::Buffer influences;      ///< shared::JointInfluence
  gpu::Buffer edgeRange;       ///< uvec2 per vertex: first edge, number of edges
  gpu::Buffer edges;           ///< shared::TriangleEdge
  gpu::Buffer frame;           ///< shared::DeformFrame
  gpu::Buffer weights;         ///< float, of morph targets
  gpu::Buffer matrices;        ///< three vec4 per joint: the rows of an affine map
  gpu::Buffer objects;         ///< shared::ObjectMotion
  gpu::Buffer replaced;        ///< three floats per vertex, mm, for objects with given positions
  bool hasDeltas = false;
  bool hasInfluences = false;
  bool normalsFromMesh = false;  ///< for any object in this frame
};

/// Some indices of a mesh.
struct IndexRange {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

/// The surface as it is in this frame.
struct DeformedMesh {
  gpu::Buffer positions;  ///< vec4 per vertex, mm
  gpu::Buffer normals;    ///< vec4 per vertex, unit; w is -1 where the body is mirrored, else 1
  gpu::Buffer bounds;     ///< of the positions; see lib/bounds.glsl
  gpu::Buffer objectOf;   ///< uint per vertex
  gpu::Buffer indices;    ///< uint, of vertices, three per triangle
  std::uint32_t vertexCount = 0;
  std::uint32_t indexCount = 0;
  std::uint32_t castingIndexCount = 0;  ///< those that cast shadows, which come first
  std::vector<IndexRange> whole;        ///< surfaces without holes; see cutOut for the others
  std::vector<IndexRange> cutOut;
};

/// Shaders' tables of opaque materials (shared/opaque.h). If nothing is opaque, they have minimal
/// buffers that can be bound.
struct OpaqueTables {
  gpu::Buffer materials;   ///< shared::OpaqueData
  gpu::Buffer texels;      ///< uvec2, half floats
  gpu::Buffer attributes;  ///< shared::VertexAttributes, one per vertex, if a material reads them
  gpu::Buffer tangents;    ///< shared::CornerTangents, one per triangle, if a material has a normal
                           ///< texture
  gpu::Buffer gloss;       ///< vec2 (passes/shade/gloss.h)
  gpu::Buffer lobes;       ///< vec4, like SceneTables::reflectionLobes, for several roughnesses
};

inline shaders::SurfaceMaterials surfaceMaterials(OpaqueTables& tables) {
  return {.opaques = tables.materials,
          .attributes = tables.attributes,
          .tangents = tables.tangents,
          .texels = tables.texels};
}

/// Shaders' tables of paint (shared/paint.h). If nothing is painted, they have minimal buffers that
/// can be bound.
struct PaintTables {
  bool any = false;
  gpu::Buffer entries;         ///< shared::PaintEntry
  gpu::Buffer throughSurfels;  ///< vec4 per surfel: share of the diffuse light on it that enters
  gpu::Buffer clusters;        ///< shared::ClusterPaint
};

/// Shaders' data of translucent bodies whose surface has a roughness or normals of its own.
struct OwnSurfaces {
  bool any = false;
  bool anyNormals = false;
  gpu::Buffer tilts;  ///< vec4 per piece: its normal, see lib/tilted_normal.glsl
};

struct SceneTables;

/// Tables that tell where surfaces have holes.
struct CutOuts {
  SceneTables& tables;
  OpaqueTables& opaque;
};

/// Shaders' tables of bodies and media.
struct SceneTables {
  gpu::Buffer objects;  ///< shared::ObjectData
  gpu::Buffer media;    ///< shared::MediumData
  std::uint32_t mediumCount = 0;
  bool followsLight = false;     ///< followed to its second collision in any medium; see
                                 ///< shared/boundary.h
  bool scattersEvenly = true;    ///< g of every medium is 0
  bool haveThinParts = false;    ///< light goes through some bodies without being scattered
  bool entersAtSurface = false;  ///< for some channel of some medium, diffuse light is treated by
                                 ///< diffusion at the surface itself; see lib/boundary.glsl
  gpu::Buffer specularAlbedo;    ///< float, see MediumData::tables.w
  gpu::Buffer reflectionLobes;   ///< vec4, by the cosine of the view (lights/reflection_lobe.h)
  bool anyBacks = false;         ///< some opaque bodies have clusters of their back
  gpu::Buffer opaqueShares;      ///< shared::OpaqueShare per cluster, if something is opaque
  gpu::Buffer opaqueExitances;   ///< vec4 per cluster of an opaque body, for all light
  PaintTables paint;
  OwnSurfaces surfaces;
  std::vector<double> etas;  ///< the distinct ones, see MediumData::tables.x

  std::uint32_t sidesOfVertices() const { return anyBacks ? 2 : 1; }
};

/// The sky and its tables for passes (lib/sky.glsl).
struct Sky {
  SkyParts parts;
  gpu::GpuImage radiance;  ///< by direction: a cube with levels for rays that each stand for a part
                           ///< of the sphere
  gpu::Buffer bright;      ///< shared::BrightSky
  gpu::GpuImage irradiance;  ///< that enters, by normal: one cube for each of SceneTables::etas
  gpu::GpuImage reflected;   ///< radiance filtered by the surface's lobe, a cube
  gpu::GpuImage glossy;      ///< radiance filtered by lobes of several roughnesses, one level each
};

/// What a picture shows where no surface is.
struct Backdrop {
  gpu::GpuImage environment;  ///< latitude-longitude, with levels; a dark texel if there is none
};

/// Lights, shadow views and camera of this frame, fitted to the surface: shared::FrameData.
struct FrameView {
  gpu::Buffer data;
  std::uint32_t shadowViews = 0;
};

/// Some of a frame's shadow views.
using ShadowViews = std::bitset<shared::maxShadowViews>;

/// Depth from the lights, one layer for each shadow view.
struct ShadowMaps {
  gpu::GpuImage depth;
  gpu::Buffer drawn;  ///< maps before they are copied there, if invocations draw triangles
  std::uint32_t roomForViews = 0;
  bool cutOut = false;  ///< for surfaces with holes
};

/// A tree whose nodes frames fit to the surface (passes/fitted_tree.h).
struct FittedTree {
  gpu::Buffer links;  ///< constant
  gpu::Buffer leafNodes;
  gpu::Buffer treeletNodes;  ///< this and the next two as in surfels::Treelets
  gpu::Buffer firstOfLevel;
  gpu::Buffer levelOfTreelet;
  std::vector<std::uint32_t> firstOfStage;  ///< first treelet; one more entry than there are stages
  std::uint32_t leafCount = 0;
  std::uint32_t nodeCount = 0;
};

/// The surface as surfels and their tree.
struct Surfels {
  gpu::Buffer pieces;                 ///< shared::SurfelPiece
  std::uint32_t piecesPerSurfel = 1;  ///< consecutive ones
  gpu::Buffer triangleOfPiece;        ///< uint, if normal textures need it
  gpu::Buffer piecesOfTriangles;  ///< for each triangle and for the end, where its pieces begin in
                                  ///< the list of pieces that follows
  std::uint32_t triangleCount = 0;
  gpu::Buffer sources;       ///< shared::Source, sourcesPerSurfel of each
  gpu::Buffer normals;       ///< vec4 per surfel, unit
  gpu::Buffer skyShares;     ///< vec4 per surfel: part of the sky's irradiance that enters
  gpu::Buffer visibilities;  ///< of lights, if boundary transport reads them: a word for each light
                             ///< and piece, see lib/piece.glsl
  std::uint32_t lights = 0;  ///< for which there is room
  std::uint32_t count = 0;   ///< of surfels
  gpu::Buffer nodes;         ///< shared::TreeNode, depth first
  gpu::Buffer boxes;         ///< shared::NodeBox, one per node
  FittedTree tree;
  bool coarse = false;      ///< for any object, so that NearbyPass is needed
  gpu::Buffer vertexOrder;  ///< vertices, neighbours in space together
  gpu::Buffer places;       ///< vec4 per surfel, mm
  gpu::Buffer objectOf;     ///< uint per surfel
  gpu::Buffer order;        ///< every surfel's own index
};

/// Places where a compute shader sums light, one invocation each: vertices, surfels or patches.
struct Places {
  gpu::Buffer& positions;  ///< vec4, mm
  gpu::Buffer& normals;    ///< vec4, unit
  gpu::Buffer& objectOf;   ///< uint
  gpu::Buffer& order;      ///< neighbours in space together
  gpu::Buffer& exitances;  ///< vec4
  std::uint32_t count = 0;
};

/// The surface of this frame for rays (lib/rays.glsl): texel buffers on the surfels' tree and, if
/// the device has ray queries, its acceleration structure.
struct RayHierarchy {
  gpu::Buffer corners;                   ///< shared::RayPiece, one per piece
  gpu::Buffer boxes;                     ///< shared::RayUnits, then a shared::RayBox for each node
  gpu::AccelerationStructure structure;  ///< of the pieces, one body per object; may be none
};

/// Light in the body under each cluster: points where it collides.
struct Beams {
  gpu::Buffer points;      ///< shared::BeamPoint, maxPoints per cluster and light
  gpu::Buffer collisions;  ///< shared::FirstCollision, maxFirstPoints per cluster and light
  gpu::Buffer strengths;   ///< vec4 per cluster and light: power that entered; numbers of points
  gpu::Buffer strongest;   ///< largest power of points followed to second collisions, as a float's
                           ///< bits
  gpu::Buffer guided;      ///< shared::Guided, pathsOfBeam per cluster and light
  std::uint32_t room = 1;  ///< lights for which there is room
  std::uint32_t lights = 1;  ///< whose points are there
};

/// Clusters of surfels, their tree, and the results of boundary transport in a frame.
struct Clusters {
  gpu::Buffer ranges;           ///< shared::ClusterRange
  gpu::Buffer clusterOfSurfel;  ///< one per surfel, of its front
  std::uint32_t patchCount = 0;
  gpu::Buffer patches;        ///< vec4 per patch: its middle, mm, and its area, mm²
  gpu::Buffer objectOfPatch;  ///< uint per patch
  FittedTree tree;
  std::uint32_t count = 0;           ///< of clusters
  std::uint32_t partsOfSurfels = 1;  ///< of the largest, shared::surfelsOfPart
  bool haveSeveralMedia = false;     ///< the clusters of some body have
  float thinnestMm = 0;      ///< a tenth of some body's clusters are where it is thinner, at rest
  gpu::Buffer objectOfNode;  ///< uint per node of their tree: object of most clusters below it
  bool haveLinings = false;  ///< some clusters are on opaque things in bodies, where the bodies'
                             ///< light ends
  std::uint32_t tileCount = 0;
  gpu::Buffer tiles;  ///< shared::ClusterTile
  std::uint32_t groupCount = 0;
  gpu::Buffer groups;  ///< shared::ClusterGroup
  std::uint32_t innerCount = 0;
  std::uint32_t smallInnerCount = 0;  ///< inner nodes of few clusters, which come first
  gpu::Buffer inner;                  ///< shared::InnerNode
  gpu::Buffer lists;                  ///< interaction lists: roomOfList per tile
  std::uint32_t roomOfList = 0;       ///< of numbers
  gpu::Buffer around;                 ///< clusters whose values are interpolated in each tile:
                                      ///< shared::roomOfAround
  gpu::Buffer clusters;               ///< shared::Cluster
  gpu::Buffer nodes;                  ///< shared::ClusterNode
  gpu::Buffer entries;         ///< shared::Entry per cluster for each light, then for light from
                               ///< everywhere
  std::uint32_t lights = 0;    ///< of the frame
  gpu::Buffer meetings;        ///< shared::Meeting, for the outward rays of each cluster
  gpu::Buffer meetingsBehind;  ///< shared::MeetingBehind, a few for each of these; none if no body
                               ///< lets light through
  std::uint32_t raysOutwards = 0;  ///< of each cluster
  std::uint32_t raysAtOnce = 0;    ///< of these
  gpu::Buffer skySums;             ///< shared::SkySum per cluster, of the rays sent so far
  Beams fromLights;                ///< of a few lights at a time
  Beams fromEverywhere;
  gpu::Buffer mirrored;    ///< shared::Mirrored per cluster and light, of a few lights at a time
  gpu::Buffer peaks;       ///< see shared::peaksOfMirrored; the power of `mirrored` at the first of
                           ///< the lights
  gpu::Buffer sums;        ///< of `mirrored`, three integers per cluster; 0 between lights
  gpu::Buffer guidedSums;  ///< of guided light, three integers per cluster: for lights, then for
                           ///< light from everywhere
  gpu::Buffer arrived;    ///< vec4 per cluster: power that enters after it was mirrored, of all but
                          ///< the last of these few lights
  gpu::Buffer beamNodes;  ///< shared::BeamNode, for the trees of lib/beam_trees.glsl
  std::uint32_t mostNodesOfBody = 0;  ///< of the tree
  std::uint32_t roomOfBeamList = 0;
  gpu::Buffer beamLists;         ///< for each tree and group, how many nodes and which
  gpu::Buffer beamCoefficients;  ///< none before a frame solves; shared::texelsOfPoints per kept
                                 ///< entry of the lists for light from everywhere
  gpu::Buffer keptBeams;         ///< the kept entries, see shared::countsOfKept
  std::uint32_t roomOfKept = 0;  ///< entries of all tiles and kinds
  gpu::Buffer sources;           ///< vec4 per cluster: fluence in an infinite medium
  gpu::Buffer withheld;   ///< float per cluster: part of the even light that enters and that the
                          ///< other side mirrors because it is concave
  gpu::Buffer skyShares;  ///< vec4 per cluster: part of the sky's irradiance that enters
  gpu::Buffer entered;    ///< vec4 per cluster: irradiance of the diffuse light that entered last
  gpu::Buffer fromAfar;   ///< the part of it that comes from afar; none for one body alone
  gpu::Buffer enteredBefore;  ///< the same for the light before that, if it is mirrored to one side
  gpu::Buffer enteredInAll;   ///< vec4 per translucent cluster: irradiance of all that has entered
  gpu::Buffer power;   ///< vec4: of all diffuse light of the last bounce but one; then the factor
                       ///< that further bounces add to the last
  gpu::Buffer latest;  ///< vec4 per cluster: exitance of the light that entered last
  gpu::Buffer exitances;  ///< vec4 per cluster, for all light; for an opaque body, the irradiance
                          ///< that surfaces do not find themselves
  gpu::Buffer nearby;     ///< vec4 per cluster: exitance of a half-space for the light that entered
                          ///< here, without further bounces; w: reciprocal of the thickness, 1/mm
  gpu::Buffer bareLights;       ///< shared::BareLight, of painted bodies
  gpu::Buffer means;            ///< vec4 per cluster: exitance of a half-space
  gpu::Buffer exitancesWithin;  ///< vec4 per patch or surfel: of a half-space
};

/// Data of boundary transport's solver.
struct Solver {
  gpu::Buffer coefficients;  ///< none before a frame solves; shared::texelsOfActions per node of a
                             ///< tile's list
  std::uint32_t roomOfCoefficients = 0;  ///< nodes per tile; coefficients of further nodes are not
                                         ///< kept
  gpu::Buffer densities;                 ///< shared::DensityNode
  gpu::Buffer products;                  ///< vec4 per cluster
  gpu::Buffer basis;                     ///< vec4 per cluster for each step and one more
  gpu::Buffer sums;                      ///< vec4, of tiles
  gpu::Buffer states;                    ///< shared::SolverState, for every solution of a frame
};

/// What is kept in addition about surfaces that the camera sees.
struct KeptOfSeen {
  bool materials = false;  ///< of opaque surfaces, of translucent ones with their own, or for
                           ///< bodies that translucent ones mirror
  bool paint = false;      ///< of painted ones
  bool origins = false;    ///< of those with an inside
  bool ofPixels = false;   ///< for passes that look at neighbours
  bool drawn = false;      ///< triangles of all samples, if the device draws these at once

  bool operator==(const KeptOfSeen&) const = default;
};

/// Lists of surfaces that the camera sees: where light is summed first, where it is summed because
/// it cannot be interpolated, and where rays have to tell whether the sky is mirrored.
enum class Asked : std::uint32_t { Knots, InWideBlocks, InNarrowBlocks, OfSky };
constexpr std::size_t askedLists = 4;

/// Which surfaces the camera sees (shared/seen.h), and what is found of them. The lists hold one
/// band of the picture at a time, because a pixel may see as many surfaces as it has samples.
struct VisibleSurfaces {
  gpu::GpuImage words;  ///< a layer for each sample; a pixel's surfaces are in the first layers
  gpu::GpuImage depth;  ///< of each sample, or of one sample at a time
  gpu::GpuImage drawn;  ///< triangles that all samples see, if hardware draws these at once
  gpu::GpuImage drawnDepth;
  gpu::Buffer nearest;  ///< the same if invocations do (lib/sample_words.glsl), uint
  gpu::Buffer nearestDepth;
  bool drawnAtOnce = false;  ///< in the picture that was recorded last
  gpu::Buffer mixed;         ///< pixels that see several triangles
  gpu::Buffer mixedCount;    ///< shared::SeenCount
  gpu::Buffer list;          ///< surfaces; those of a pixel follow each other
  gpu::Buffer counts;        ///< shared::SeenCount, for all and for parts
  gpu::Buffer light;         ///< vec4 for each on the list: first its exitance, then its radiance
  gpu::Buffer skyShares;     ///< float for each: share of sky in what it mirrors
  gpu::Buffer materials;     ///< shared::SeenMaterial for each, of opaque surfaces and translucent
                             ///< ones with their own
  gpu::Buffer paint;  ///< vec4 for each, on painted bodies: the light that has entered there, then
                      ///< the share of leaving light that goes towards the camera, relative to that
                      ///< without paint
  gpu::Buffer origins;  ///< vec4 for each: where the light that leaves comes from (lib/origin.glsl)
  std::array<gpu::Buffer, 2> ofPixels;  ///< 16 bytes for each pixel of a band: results of passes
                                        ///< that look at neighbours
  KeptOfSeen kept;                      ///< what there is room for
  gpu::GpuImage skyBlocks;   ///< for 2×2 pixels: share of sky in what they mirror, or unknown
  gpu::Buffer entryOfPixel;  ///< uint for each pixel of a band: its first surface in the list
  std::array<gpu::Buffer, 2> blocks;  ///< uint for each narrow block (lib/blocks.glsl) of a band:
                                      ///< before and after light of wide ones is interpolated
  gpu::Buffer asked;  ///< the lists of Asked one after the other, as indices into the list of all
  std::array<gpu::Buffer, askedLists> askedCounts;  ///< shared::SeenCount, for all and for parts
  std::uint32_t rowsOfBand = 0;
  std::uint32_t parts = 0;  ///< the largest number of parts of the list

  /// Rows of the band that begins at `firstRow`.
  std::uint32_t rowsFrom(std::uint32_t firstRow) const {
    return std::min(rowsOfBand, words.extent().height - firstRow);
  }
  gpu::Buffer& countsOf(Asked list) { return askedCounts[static_cast<std::size_t>(list)]; }
};

/// The surfaces on the list, with the data of their places (lib/seen_list.glsl).
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
  gpu::GpuImage normal;    ///< xyz unit, towards the camera; w is -1 where that is inwards, else 1
  gpu::GpuImage exitance;  ///< rgb B, a evaluations
};

/// Exitance B of the vertices, or irradiance for opaque bodies: all of it or, for the paper's
/// fragments, the part of far samples. If something is opaque, irradiance on the backs of sheets
/// follows. Sums at fragments are in VisibleSurfaces::light.
struct Exitance {
  gpu::Buffer vertices;
  gpu::Buffer origins;  ///< vec4 per vertex of bodies with an inside: where that light comes from
                        ///< (lib/origin.glsl)
};

/// Which surfels the camera sees.
struct SeenSurfels {
  gpu::GpuImage image;  ///< surfel; cluster, or -1; node of the tree; 1. All are -1 where no surfel
                        ///< is seen.
};

inline Places verticesOf(DeformedMesh& mesh, Surfels& surfels, Exitance& exitance) {
  return {mesh.positions,      mesh.normals,      mesh.objectOf,
          surfels.vertexOrder, exitance.vertices, mesh.vertexCount};
}

inline Places surfelsOf(Surfels& surfels, Clusters& clusters) {
  return {surfels.places, surfels.normals,          surfels.objectOf,
          surfels.order,  clusters.exitancesWithin, surfels.count};
}

/// Patches of bodies whose surfels are not coarse; their normals are not read.
inline Places patchesOf(Surfels& surfels, Clusters& clusters) {
  return {clusters.patches, surfels.normals,          clusters.objectOfPatch,
          surfels.order,    clusters.exitancesWithin, clusters.patchCount};
}

}  // namespace opaline::passes
