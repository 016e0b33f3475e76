// Boundary transport in storage buffers. Included by C++ and GLSL.
#ifndef OPALINE_SHARED_BOUNDARY_H
#define OPALINE_SHARED_BOUNDARY_H

#ifdef __cplusplus
#include <cmath>
#include <cstdint>
#include <glm/vec4.hpp>
namespace opaline::shared {
using uint = std::uint32_t;  // NOLINT(readability-identifier-naming): GLSL's word
using glm::uvec4;
using glm::vec4;
using std::exp;
#define OPALINE_BOUNDARY_CONSTANT constexpr std::uint32_t
#define OPALINE_BOUNDARY_NUMBER constexpr float
#define OPALINE_BOUNDARY_INLINE inline
#else
#define OPALINE_BOUNDARY_CONSTANT const uint
#define OPALINE_BOUNDARY_NUMBER const float
#define OPALINE_BOUNDARY_INLINE
#endif

/// The surfels of which a cluster consists, the same in every frame.
struct ClusterRange {
  uint firstSurfel;
  uint endSurfel;
  uint object;
  uint node;   // its leaf in the tree of clusters
  uint kind;   // of its body, as below
  float side;  // -1 on the back of a sheet, else 1
  uint firstPatch;
  uint tile;
  float thickness;  // of the body in the rest pose, the least below the cluster, mm
};

/// Kinds of bodies. Light diffuses only in one with an inside; for diffusion the others have no
/// area. A lining is where such a body ends within, at an opaque object.
OPALINE_BOUNDARY_CONSTANT openBody = 0u;
OPALINE_BOUNDARY_CONSTANT bodyWithInside = 1u;
OPALINE_BOUNDARY_CONSTANT opaqueBody = 2u;
OPALINE_BOUNDARY_CONSTANT lining = 3u;

/// Light that goes through bodies unscattered is not followed further when less than this is left.
OPALINE_BOUNDARY_NUMBER leastThrough = 0.02f;

/// How many surfaces light may cross on its way through bodies: two for each wall, and some that
/// are met twice.
OPALINE_BOUNDARY_CONSTANT mostSurfacesOfWay = 8u;

/// Whether more is left where a body is that thick, mm, by its least extinction of any channel,
/// 1/mm.
OPALINE_BOUNDARY_INLINE bool letsThrough(float thickness, float extinction) {
  return exp(-extinction * thickness) > leastThrough;
}

/// Whether clusters of that kind bound the diffusion.
OPALINE_BOUNDARY_INLINE bool boundsDiffusion(uint kind) {
  return kind == bodyWithInside || kind == lining;
}

/// A patch has this many consecutive surfels, or what is left of a cluster. Opaque bodies and
/// linings have none.
OPALINE_BOUNDARY_CONSTANT surfelsOfPatch = 4u;

/// How many there are, one after the other from range.firstPatch.
OPALINE_BOUNDARY_INLINE uint patchesOf(ClusterRange range) {
  if (range.kind == opaqueBody || range.kind == lining) return 0u;
  return (range.endSurfel - range.firstSurfel + surfelsOfPatch - 1u) / surfelsOfPatch;
}

/// What a cluster of an opaque body sends out of the light that falls on it and on its other side.
/// A lining sends out light of the body.
struct OpaqueShare {
  vec4 share;     // rgb: given back
  vec4 through;   // rgb: let through from the other side
  vec4 emission;  // rgb: exitance of its own
};

/// A cluster in this frame.
struct Cluster {
  vec4 centroidArea;  // mm; a, mm²
  vec4 normal;        // unit, of the vector area; w: ρ = √(a/π), mm
  vec4 vectorArea;  // A = Σ a n, mm²; w: c, the share of the solid angle that the body fills there,
                    // found from the other clusters
  vec4 start;   // a place on the surface near the centroid, mm; w: thickness of the body, or in
                // front of an opaque one the harmonic mean distance to what lies there, mm
  vec4 along;   // unit, in the surface there, moving with it; w: 1, or -1 where its triangles are
                // wound the other way, because the body is mirrored or this is its back
  vec4 facet;   // unit, outwards there; w: mean cosine inside the body of sky light that enters
  vec4 second;  // rgb: part of the light that is followed to its second collision; w: how much
                // the cluster counts among those around a place; 0 in an open body
  vec4 escape;  // rgb: A of a plane over that of the cluster (lib/escape.glsl); w: mean curvature,
                // 1/mm, above 0 where the body is convex
};
OPALINE_BOUNDARY_CONSTANT texelsOfCluster = 8u;
#ifdef __cplusplus
static_assert(sizeof(Cluster) == texelsOfCluster * sizeof(vec4));
#endif

/// Index of one of a cluster's vectors, in the order above, where clusters are read as texels.
OPALINE_BOUNDARY_INLINE int texelOfCluster(uint cluster, uint vector) {
  return int(texelsOfCluster * cluster + vector);
}

/// A tile has at most this many consecutive clusters of one body. The same nodes act on all of
/// them, so what is known of a node serves each.
OPALINE_BOUNDARY_CONSTANT maxClustersOfTile = 8u;

/// What a node does to each cluster of a tile, see lib/cluster_action.glsl: two numbers of two
/// bytes each per channel, in texels of four floats.
OPALINE_BOUNDARY_CONSTANT texelsOfActions = 3u * maxClustersOfTile / 4u;
/// What light of unit power that enters through a cluster gives each cluster of a tile, see
/// lib/beam_sum.glsl: a number of two bytes per channel.
OPALINE_BOUNDARY_CONSTANT texelsOfPoints = 3u * maxClustersOfTile / 8u;
/// What is kept of a tile's list of points of light, for each kind of sums: where it begins, how
/// many of the list's entries there is room for, how many are kept, and how many of these are inner
/// nodes near the tile, inner nodes apart from it, and clusters. After the counts of all tiles come
/// two words for each entry that there is room for. The first half of a tile's words holds the
/// clusters; the second holds near nodes from its start and apart ones from its end.
OPALINE_BOUNDARY_CONSTANT countsOfKept = 6u;
OPALINE_BOUNDARY_CONSTANT kindsOfBeams = 2u;
struct ClusterTile {
  uint firstCluster;
  uint endCluster;
  uint object;
  uint group;  // of tiles
};

/// A group is at most this many clusters, in consecutive tiles. The points of light that act on
/// them are found for all of them together.
OPALINE_BOUNDARY_CONSTANT maxClustersOfGroup = 32u;
OPALINE_BOUNDARY_CONSTANT maxTilesOfGroup = maxClustersOfGroup / maxClustersOfTile;
struct ClusterGroup {
  uint firstCluster;
  uint endCluster;
  uint object;
  uint unused;
};

/// The interaction list of a tile: how many nodes act on it, and then which. A tile with more nodes
/// than there is room for has no list, and they are found again each time. Lists have room for at
/// least this many numbers, or for all nodes.
OPALINE_BOUNDARY_CONSTANT leastRoomOfList = 1024u;

/// Room for the clusters that are felt in a tile, and their leaves. Clusters beyond it, the last in
/// the tree, are left out.
OPALINE_BOUNDARY_CONSTANT roomOfAround = 512u;
/// Rays from this many places of a cluster ask how thick the body is, straight on and at a slant.
OPALINE_BOUNDARY_CONSTANT placesInwards = 4u;
/// The surfels of a large cluster find out in parts of this many how much of the sky they see.
OPALINE_BOUNDARY_CONSTANT surfelsOfPart = 512u;

/// Light of one kind that enters through a cluster.
struct Entry {
  vec4 irradiance;  // rgb, mean over the cluster
  vec4 place;       // mean place where it enters, mm
  vec4 normal;      // unit, mean normal where it enters
  vec4 start;       // a place near there on the surface that it reaches, mm
};

/// Light that entered through a cluster is spread over points in the body: first those of its first
/// collision, then, for the part that is followed further, those of its second.
OPALINE_BOUNDARY_CONSTANT pointsOfFirstSegment = 3u;
OPALINE_BOUNDARY_CONSTANT pointsOfReflection = 2u;
OPALINE_BOUNDARY_CONSTANT maxReflections = 4u;
OPALINE_BOUNDARY_CONSTANT maxFirstPoints =
    pointsOfFirstSegment + pointsOfReflection * maxReflections;
/// In how many directions light is followed on from each point of the first segment, and from its
/// last point, which has a sixteenth of the light in a thick body. Light from everywhere enters
/// everywhere, so fewer directions are enough for it. Each point of a reflection has one.
OPALINE_BOUNDARY_CONSTANT directionsOfPoint = 6u;
OPALINE_BOUNDARY_CONSTANT directionsOfLastPoint = 2u;
OPALINE_BOUNDARY_CONSTANT directionsOfEvenPoint = 4u;
OPALINE_BOUNDARY_CONSTANT directionsOfLastEvenPoint = 1u;
OPALINE_BOUNDARY_CONSTANT maxSecondPoints = (pointsOfFirstSegment - 1u) * directionsOfPoint +
                                            directionsOfLastPoint +
                                            pointsOfReflection * maxReflections;
OPALINE_BOUNDARY_CONSTANT maxPoints = maxFirstPoints + maxSecondPoints;

/// All light is followed to its second collision up to the first of these albedos, and none from
/// the second on.
OPALINE_BOUNDARY_NUMBER albedoFollowed = 0.96f;
OPALINE_BOUNDARY_NUMBER albedoNotFollowed = 0.99f;

/// One of those points: a place and a share of the light for each channel.
struct BeamPoint {
  vec4 red;  // mm; share
  vec4 green;
  vec4 blue;
};

/// What second collisions need of the point they come from.
struct FirstCollision {
  vec4 arrival;  // unit: direction in which light arrives there
  vec4 onward;   // rgb: how far the point lies beyond the collision itself, mm
};

/// For each way that is followed to a second collision, in a channel: what leaves where the way
/// meets the surface again after it was mirrored inside, and the cluster through which most of that
/// leaves.
struct Guided {
  uint cluster;
  float share;  // of the light that entered
};
OPALINE_BOUNDARY_CONSTANT pathsOfBeam = 3u * maxSecondPoints;

/// What a ray from a cluster met outside: another cluster, and the part of the light from there
/// that enters here by this ray.
struct Meeting {
  uint cluster;  // or noCluster
  float share;
  float transmitted;  // F_t there: the light is that part of what leaves there plus the rest of
                      // what entered there
};
OPALINE_BOUNDARY_CONSTANT noCluster = 0xffffffffu;

/// What it met behind thin parts of bodies, with the share by channel (lib/meeting_behind.glsl).
struct MeetingBehind {
  uint cluster;  // or noCluster
  uint redGreen;
  uint blueTransmitted;
};
OPALINE_BOUNDARY_CONSTANT meetingsBehind = 2u;  // of a ray at most

/// Numbers of all clusters are kept as the bits of floats: for each light the largest power of
/// mirrored light, and then, three channels each, the largest irradiances that entered: after a
/// bounce that of all light, of light from everywhere, and of each light (lib/peaks.glsl).
OPALINE_BOUNDARY_CONSTANT peaksOfMirrored = 32u;
OPALINE_BOUNDARY_CONSTANT peakOfAll = 0u;
OPALINE_BOUNDARY_CONSTANT peakOfEverywhere = 1u;
OPALINE_BOUNDARY_CONSTANT peakOfFirstLight = 2u;

/// Sums over a cluster's rays outwards.
struct SkySum {
  vec4 free;        // what gets here of the sky's light; w: of even light
  vec4 all;         // the same as if nothing were in its way
  float slant;      // free light times its cosine inside
  float nearness;   // one over the distance to what rays meet, 1/mm
  float meets;      // number of rays that meet anything
  float closeEven;  // even light that is hidden by something within a few edges of the cluster
};

/// Where the sky is brighter than its mean (environment/bright_directions.h).
OPALINE_BOUNDARY_CONSTANT brightDirections = 256u;
struct BrightSky {
  vec4 light;  // x: mean of R + G + B; y: integral of the excess over that, 0 where it is small
  vec4 towards[brightDirections];
};

/// Light of a cluster that its surface mirrors on arrival and that enters another.
struct Mirrored {
  vec4 power;    // rgb
  uint cluster;  // where it enters, or noCluster
  uint unused0;
  uint unused1;
  uint unused2;
};

/// A node of the tree of clusters in this frame.
struct ClusterNode {
  vec4 centroidLink;  // of the area, mm; link, as in shared/surfels.h with clusters for surfels
  vec4 spread;        // x: no place lies further from the centroid, mm; y: mean square of that
                // distance, mm²; z: no cluster is felt further from it by the interpolation, mm;
                // w: a, mm²
  vec4 vectorArea;  // mm²; w: the object's index
  vec4 moment;  // Σ A δ with the offset δ from the centroid, mm³; xx yy zz xy, see lib/moment.glsl
  vec4 momentRest;  // xz yz
};

/// An inner node of the tree of clusters, and the clusters below it. Nodes of few clusters come
/// first.
struct InnerNode {
  uint node;
  uint firstCluster;
  uint endCluster;
  uint object;
};
OPALINE_BOUNDARY_CONSTANT fewClusters = 32u;
/// Leaves, and inner nodes of few clusters, per work group.
OPALINE_BOUNDARY_CONSTANT nodesOfGroup = 64u;
OPALINE_BOUNDARY_INLINE uint groupsOfNodes(uint nodes) {
  return (nodes + nodesOfGroup - 1u) / nodesOfGroup;
}

/// Fluence φ over what is below a node, for each channel: Σ φ (A + a δ / 2AD), with the offset δ
/// from the node's centroid; Σ a φ.
struct DensityNode {
  vec4 red;
  vec4 green;
  vec4 blue;
};

/// Light from points below a node. Channels without power have the others' centroid.
struct BeamNode {
  vec4 greenLink;  // centroid of the green power, mm; link as in ClusterNode
  vec4 extent;    // x: size of the points below as sums over them feel it, mm, or -1 where there is
                  // no power; y: largest distance of the other centroids from that of green, mm; z:
                  // root mean square distance, mm; w: power of green
  vec4 redPower;  // centroid, mm; power
  vec4 bluePower;
  vec4 square;  // mean square distances along xx, yy, zz, mm²; w: the part that the power does not
                // include yet
  vec4 across;  // along xy, xz, yz; for light that scatters once, its mean direction of arrival; w:
                // for leaves by the shape alone, the power that enters in each channel
};

/// Most steps that the solver takes before it makes do with what it has.
OPALINE_BOUNDARY_CONSTANT maxSolverSteps = 8u;

/// Generalised minimal residuals (Saad and Schultz 1986), each channel by itself.
struct SolverState {
  vec4 hessenberg[maxSolverSteps * (maxSolverSteps + 1u)];  // column after column
  vec4 cosine[maxSolverSteps];                              // Givens rotations
  vec4 sine[maxSolverSteps];
  vec4 rotated[maxSolverSteps + 1u];  // right-hand side under these rotations
  vec4 wanted;                        // rgb: norm below which the residual is small enough
  vec4 residual;                      // rgb: relative to the right-hand side
  vec4
      projections[maxSolverSteps + 1u];  // of the last product on the basis, and what is left of it
  // The dispatches of the next step: none where the residual is small enough.
  uvec4 groupsOfDensities;
  uvec4 groupsOfProduct;
  uint steps;      // made so far
  uint tilesDone;  // of the product under way
  uint unused[2];
};

#ifdef __cplusplus
}  // namespace opaline::shared
#endif

#endif
