// Where rays meet the surface of this frame, from either side. Needs, before it,
// BINDING_PIECE_CORNERS and BINDING_RAYS: the corners of a RayHierarchy, and its boxes or, where
// RAY_QUERIES is defined, its acceleration structure. After it, for queries, a function
//   uint firstPieceOf(uint object)
#ifndef OPALINE_LIB_RAYS
#define OPALINE_LIB_RAYS
#include "lib/texels.glsl"
#include "lib/tree_node.glsl"
#include "shared/rays.h"

TEXELS(BINDING_PIECE_CORNERS, pieceCorners);  // RayPiece

const uint noPiece = 0xffffffffu;

struct RayHit {
  float distance;  // in lengths of the direction; maxDistance where nothing is hit
  uint piece;      // or noPiece
};

// What a ray may meet: the pieces below some nodes of the surfels' tree, those of all objects or of one.
struct RayTarget {
  uint firstNode;
  uint endNode;
  uint object;  // or everyObject
};

const uint everyObject = 0xffffffffu;

#ifdef RAY_QUERIES
#include "lib/ray_queries.glsl"
#else
#include "lib/ray_boxes.glsl"
#endif

// How far above a surface rays start so as not to meet it, since coordinates are rounded.
float startAbove(vec3 position) {
  vec3 places = abs(position);
  return 1e-5 * max(max(places.x, places.y), places.z);
}

// The nearest piece of the target that a ray meets beyond `minDistance` and before `maxDistance`.
// Distances are in lengths of `direction`, which need not be 1. A ray that starts on a piece meets it
// at about 0, on either side: within a millionth of the coordinates, and more the flatter it leaves.
RayHit nearestHit(vec3 origin, vec3 direction, float minDistance, float maxDistance,
                  RayTarget target) {
  return meetPieces(origin, direction, minDistance, maxDistance, target, false);
}

// The nearest piece that is not of that body is found by
//   RayHit nearestHitOfOthers(vec3 origin, vec3 direction, float minDistance, float maxDistance, RayTarget body,
//                             uint nodeCount)

// Whether there is any such piece.
bool occluded(vec3 origin, vec3 direction, float minDistance, float maxDistance,
              RayTarget target) {
  return meetPieces(origin, direction, minDistance, maxDistance, target, true).piece != noPiece;
}

// The unit normal of a piece that was hit, to the side from which its triangle's corners are seen counter-clockwise.
vec3 facetNormal(uint piece) {
  int at = 3 * int(piece);
  vec3 a = texelOf(pieceCorners, at).xyz;
  return normalize(cross(texelOf(pieceCorners, at + 1).xyz - a,
                         texelOf(pieceCorners, at + 2).xyz - a));
}

uint objectOfPiece(uint piece) {
  return uint(texelOf(pieceCorners, 3 * int(piece)).w);
}

// The nearest place where a ray through the inside of a body comes out. Folds of the surface where
// it would have to enter do not count. `side` is -1 where the body is mirrored.
RayHit nearestExit(vec3 origin, vec3 direction, float side, float minDistance, float maxDistance,
                   RayTarget target) {
  const uint mostFolds = 4u;
  RayHit hit;
  float from = minDistance;
  for (uint k = 0u; k < mostFolds; ++k) {
    hit = nearestHit(origin, direction, from, maxDistance, target);
    if (hit.piece == noPiece || side * dot(facetNormal(hit.piece), direction) > 0.0) break;
    from = hit.distance + minDistance;
  }
  return hit;
}

#endif
