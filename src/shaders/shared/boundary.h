// Boundary transport in storage buffers. Included by C++ and GLSL.
#ifndef OPALINE_SHARED_BOUNDARY_H
#define OPALINE_SHARED_BOUNDARY_H

#ifdef __cplusplus
#include <cstdint>
#include <glm/vec4.hpp>
namespace opaline::shared {
using uint = std::uint32_t;  // NOLINT(readability-identifier-naming): GLSL's word
using glm::uvec4;
using glm::vec4;
#define OPALINE_BOUNDARY_CONSTANT constexpr std::uint32_t
#define OPALINE_BOUNDARY_NUMBER constexpr float
#define OPALINE_BOUNDARY_INLINE inline
#else
#define OPALINE_BOUNDARY_CONSTANT const uint
#define OPALINE_BOUNDARY_NUMBER const float
#define OPALINE_BOUNDARY_INLINE
#endif

/// Which surfels a cluster is of, the same in every frame.
struct ClusterRange {
  uint firstSurfel;
  uint endSurfel;
  uint object;
  uint node;   // its leaf in the tree of clusters
  uint kind;   // of its body there
  float side;  // -1 where it is of the back of a sheet, else 1
  uint firstPatch;
  uint tile;
};

/// Kinds of bodies. Only in one with an inside light diffuses; the others have no area to it. Where
/// it ends within, at an opaque thing, is the lining of such a body.
OPALINE_BOUNDARY_CONSTANT openBody = 0u;
OPALINE_BOUNDARY_CONSTANT bodyWithInside = 1u;
OPALINE_BOUNDARY_CONSTANT opaqueBody = 2u;
OPALINE_BOUNDARY_CONSTANT lining = 3u;

/// Whether clusters of that kind are a boundary of the diffusion.
OPALINE_BOUNDARY_INLINE bool boundsDiffusion(uint kind) {
  return kind == bodyWithInside || kind == lining;
}

/// A patch is of so many surfels that follow each other, or of what is left of a cluster. Opaque
/// bodies and linings have none.
OPALINE_BOUNDARY_CONSTANT surfelsOfPatch = 4u;

/// They follow each other from range.firstPatch.
OPALINE_BOUNDARY_INLINE uint patchesOf(ClusterRange range) {
  if (range.kind == opaqueBody || range.kind == lining) return 0u;
  return (range.endSurfel - range.firstSurfel + surfelsOfPatch - 1u) / surfelsOfPatch;
}

/// What a cluster of an opaque body sends out: of the light that falls on it and on its other side;
/// of a lining, of the light in the body.
struct OpaqueShare {
  vec4 share;     // rgb: given back
  vec4 through;   // rgb: let through from the other side
  vec4 emission;  // rgb: exitance of its own
};

/// A cluster in this frame.
struct Cluster {
  vec4 centroidArea;  // mm; a, mm²
  vec4 normal;        // unit, of the vector area; w: ρ = √(a/π), mm
  vec4 vectorArea;  // A = Σ a n, mm²; w: share of the solid angle that the body fills there, c, as
                    // the other clusters give it
  vec4 start;   // a place on the surface near the centroid, mm; w: thickness of the body, or before
                // an opaque one harmonic mean of how far it is to what lies there, mm
  vec4 along;   // unit, in the surface there, moving with it; w: the side to which its triangles go
                // round, 1, or -1 where the body is mirrored or it is of the back
  vec4 facet;   // unit, outwards there; w: mean cosine inside of the sky's light that enters
  vec4 second;  // rgb: part of the light that is followed to its second collision; w: 0 in an
                // open body
  vec4 escape;  // rgb: A of a plane over that of the cluster (lib/escape.glsl); w: mean curvature,
                // 1/mm, above 0 where the body is convex
};
OPALINE_BOUNDARY_CONSTANT texelsOfCluster = 8u;
#ifdef __cplusplus
static_assert(sizeof(Cluster) == texelsOfCluster * sizeof(vec4));
#endif

/// Of that one of its vectors, in the order above, where clusters are read as texels.
OPALINE_BOUNDARY_INLINE int texelOfCluster(uint cluster, uint vector) {
  return int(texelsOfCluster * cluster + vector);
}

/// Clusters of one body that follow each other: the same nodes act on all of them, so that what is
/// known of a node is used for each.
OPALINE_BOUNDARY_CONSTANT maxClustersOfTile = 8u;

/// What a node does to each of them, see lib/cluster_action.glsl: two numbers a channel of two
/// bytes each, in texels of four floats.
OPALINE_BOUNDARY_CONSTANT texelsOfActions = 3u * maxClustersOfTile / 4u;
/// What light of unit power that enters through a cluster gives to each of them, see
/// lib/beam_sum.glsl: a number a channel of two bytes.
OPALINE_BOUNDARY_CONSTANT texelsOfPoints = 3u * maxClustersOfTile / 8u;
/// What is kept of a tile's list of points of light, for each kind of sums: where it begins, for
/// how many of the list's entries there is room, how many are kept, and how many of these are inner
/// nodes near the tile, inner nodes apart from it, and clusters. After those of all tiles come two
/// words for each entry that there is room for: first the clusters, in the second half the nodes
/// that are near, and from its end those that are apart.
OPALINE_BOUNDARY_CONSTANT countsOfKept = 6u;
OPALINE_BOUNDARY_CONSTANT kindsOfBeams = 2u;
struct ClusterTile {
  uint firstCluster;
  uint endCluster;
  uint object;
  uint group;  // of tiles
};

/// Clusters of so many tiles that follow each other are a group: which points of light act on them
/// is found for all of them together.
OPALINE_BOUNDARY_CONSTANT maxClustersOfGroup = 32u;
OPALINE_BOUNDARY_CONSTANT maxTilesOfGroup = maxClustersOfGroup / maxClustersOfTile;
struct ClusterGroup {
  uint firstCluster;
  uint endCluster;
  uint object;
  uint unused;
};

/// The interaction list of a tile: how many nodes act on it, and then which. Where there are more
/// than it has room for, it has none, and they are found again each time. Lists have room for so
/// many numbers at least, or for all nodes.
OPALINE_BOUNDARY_CONSTANT leastRoomOfList = 1024u;

/// How many clusters are felt in a tile, and their leaves; those that there is no room for, the
/// last in the tree, are not.
OPALINE_BOUNDARY_CONSTANT roomOfAround = 512u;
/// In so many places of a cluster rays ask how thick the body is, straight on and at a slant.
OPALINE_BOUNDARY_CONSTANT placesInwards = 4u;
/// Of a large cluster, so many surfels after the other find out how much of the sky they see.
OPALINE_BOUNDARY_CONSTANT surfelsOfPart = 512u;

/// Light of one kind that enters through a cluster.
struct Entry {
  vec4 irradiance;  // rgb, mean over the cluster
  vec4 place;       // where it enters on the mean, mm
  vec4 normal;      // unit, of where it enters on the mean
  vec4 start;       // a place on the surface near there that it reaches, mm
};

/// Light that entered through a cluster is spread over points in the body: first the places of its
/// first collision, then, of the part that is followed further, of its second.
OPALINE_BOUNDARY_CONSTANT pointsOfFirstSegment = 3u;
OPALINE_BOUNDARY_CONSTANT pointsOfReflection = 2u;
OPALINE_BOUNDARY_CONSTANT maxReflections = 4u;
OPALINE_BOUNDARY_CONSTANT maxFirstPoints =
    pointsOfFirstSegment + pointsOfReflection * maxReflections;
/// In how many directions light is followed on from points of the first segment: from the last of
/// them, which has a sixteenth of the light in a thick body, and from each of the others. What
/// comes from everywhere enters everywhere, so that few are enough; points of reflections have one
/// each.
OPALINE_BOUNDARY_CONSTANT directionsOfPoint = 6u;
OPALINE_BOUNDARY_CONSTANT directionsOfLastPoint = 2u;
OPALINE_BOUNDARY_CONSTANT directionsOfEvenPoint = 4u;
OPALINE_BOUNDARY_CONSTANT directionsOfLastEvenPoint = 1u;
OPALINE_BOUNDARY_CONSTANT maxSecondPoints = (pointsOfFirstSegment - 1u) * directionsOfPoint +
                                            directionsOfLastPoint +
                                            pointsOfReflection * maxReflections;
OPALINE_BOUNDARY_CONSTANT maxPoints = maxFirstPoints + maxSecondPoints;

/// Up to the first of these albedos all light is followed to its second collision, from the other
/// on none is.
OPALINE_BOUNDARY_NUMBER albedoFollowed = 0.96f;
OPALINE_BOUNDARY_NUMBER albedoNotFollowed = 0.99f;

/// One of them: a place and a share of the light for each channel.
struct BeamPoint {
  vec4 red;  // mm; share
  vec4 green;
  vec4 blue;
};

/// Of a point of first collisions, what its second ones need.
struct FirstCollision {
  vec4 arrival;  // unit: where light comes along there
  vec4 onward;   // rgb: by how much the points lie further on than where light collides, mm
};

/// Of each way that is followed to a second collision, in a channel: what leaves where it meets the
/// surface again after it was mirrored inside, and through which cluster most of that.
struct Guided {
  uint cluster;
  float share;  // of the light that entered
};
OPALINE_BOUNDARY_CONSTANT pathsOfBeam = 3u * maxSecondPoints;

/// What a ray from a cluster met outside: another cluster, and which part of the light that comes
/// from there enters here by this ray.
struct Meeting {
  uint cluster;  // or noCluster
  float share;
  float transmitted;  // F_t there: the light is that part of what leaves, and the rest of what
                      // entered
};
OPALINE_BOUNDARY_CONSTANT noCluster = 0xffffffffu;

/// Where the sky is brighter than on the mean (environment/bright_directions.h).
OPALINE_BOUNDARY_CONSTANT brightDirections = 256u;
struct BrightSky {
  vec4 light;  // x: mean of R + G + B; y: integral of what is more, 0 where that is little
  vec4 towards[brightDirections];
};

/// Light of a cluster that is mirrored at the surface on arrival and enters another.
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

/// An inner node of the tree of clusters, and what is below it. Those of few clusters come first.
struct InnerNode {
  uint node;
  uint firstCluster;
  uint endCluster;
  uint object;
};
OPALINE_BOUNDARY_CONSTANT fewClusters = 32u;
/// Leaves, and inner nodes of few clusters, that a work group has.
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
  vec4 extent;  // x: how large the points below are to the eye of sums over them, mm, or -1 where
                // there is no power; y: how far the other centroids lie from that of green at most,
                // mm; z: root of the mean square distance, mm; w: power of green
  vec4 redPower;  // centroid, mm; power
  vec4 bluePower;
  vec4 square;  // mean square distances along xx, yy, zz, mm²; w: of what the power does not have
                // yet
  vec4 across;  // along xy, xz, yz; of light that scatters once, its mean direction of arrival;
                // w: of leaves as the shape alone has them, the power that enters in each channel
};

/// Most steps of the solver before it must do with what it has.
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
  // Of the dispatches of the next step: none where the residual is small enough.
  uvec4 groupsOfDensities;
  uvec4 groupsOfProduct;
  uint steps;      // that were made
  uint tilesDone;  // of the product under way
  uint unused[2];
};

#ifdef __cplusplus
}  // namespace opaline::shared
#endif

#endif
