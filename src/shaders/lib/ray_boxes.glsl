// Rays through the boxes around pieces on the surfels' tree; a part of lib/rays.glsl.
//
// Pieces and ray are turned so that the ray is the z axis. A corner that pieces share then lies at
// one place for all of them, and an edge between two pieces has the ray on one side or the other
// (as in Woop, Benthin and Wald 2013). Where pieces do not share corners, or share them only
// nearly, the slack makes up for it.
#ifndef OPALINE_LIB_RAY_BOXES
#define OPALINE_LIB_RAY_BOXES
#include "lib/axes.glsl"
#include "lib/lesser.glsl"
#include "lib/ray_hierarchy.glsl"

struct Ray {
  vec3 origin;
  vec3 boxOrigin;   // in the units of boxes
  vec3 inverse;     // of the direction, times that unit
  bvec3 backwards;  // where that is below 0
  mat3 turn;        // its rows: two directions across, and the one in whose lengths `distance` is
  float reach;      // largest coordinate of the origin, mm
};

// Smaller components of a direction, 0 included, become this, so that each has an inverse. Boxes
// are wide enough for it.
const float leastComponent = 1e-18;

Ray makeRay(vec3 origin, vec3 direction) {
  vec3 size = abs(direction);
  bvec3 small = lessThan(size, vec3(leastComponent));
  vec4 middleUnit = middleUnitOfBoxes();
  vec3 inverse = middleUnit.w / mix(direction, vec3(leastComponent), small);
  mat2x3 across = axesAcross(normalize(direction));
  vec3 places = abs(origin);
  return Ray(origin, (origin - middleUnit.xyz) / middleUnit.w, inverse, lessThan(inverse, vec3(0.0)),
             transpose(mat3(across[0], across[1], direction / dot(direction, direction))), largestOf(places));
}

// Whether part of the box may lie between the ray's origin and `furthest`.
bool meetsBox(Ray ray, mat2x3 sides, float furthest) {
  vec3 enters = (mix(sides[0], sides[1], ray.backwards) - ray.boxOrigin) * ray.inverse;
  vec3 leaves = (mix(sides[1], sides[0], ray.backwards) - ray.boxOrigin) * ray.inverse;
  const float rounded = 1.0 + 1.0 / float(1u << 21u);
  float enter = max(largestOf(enters), 0.0);
  float leave = leastOf(leaves) * rounded;
  return enter <= leave && enter <= furthest;
}

// Makes the piece the hit if the ray meets it beyond `minDistance` and nearer than the last one.
void meetPiece(Ray ray, uint piece, float minDistance, inout RayHit hit) {
  int at = 3 * int(piece);
  vec4 a4 = texelOf(pieceCorners, at);
  vec4 b4 = texelOf(pieceCorners, at + 1);
  vec4 c4 = texelOf(pieceCorners, at + 2);
  // A place must come out the same, bit by bit, whichever corner of a piece it is. Devices may
  // multiply a matrix in any order, even if the product is precise.
  precise vec3 a = a4.xyz - ray.origin;
  precise vec3 b = b4.xyz - ray.origin;
  precise vec3 c = c4.xyz - ray.origin;
  a = ray.turn[0] * a.x + ray.turn[1] * a.y + ray.turn[2] * a.z;
  b = ray.turn[0] * b.x + ray.turn[1] * b.y + ray.turn[2] * b.z;
  c = ray.turn[0] * c.x + ray.turn[1] * c.y + ray.turn[2] * c.z;
  // Twice the areas of the ray with each edge, all of one sign where it passes between them.
  // Rounding gives none the wrong sign, as long as none is left out.
  precise vec3 areas = vec3(c.x * b.y - c.y * b.x, a.x * c.y - a.y * c.x, b.x * a.y - b.y * a.x);
  float slack = b4.w * ray.reach + c4.w;
  float least = leastOf(areas);
  float most = largestOf(areas);
  if (least < -slack && most > slack) return;
  // A mean of the corners' distances, whatever the piece's shape.
  vec3 parts = least >= -slack ? max(areas, 0.0) : max(-areas, 0.0);
  float all = parts.x + parts.y + parts.z;
  float distance = (parts.x * a.z + parts.y * b.z + parts.z * c.z) / all;
  if (all > 0.0 && distance > minDistance && distance < hit.distance) hit = RayHit(distance, piece);
}

// A ray looks for its next leaf in this many boxes, then waits until its neighbours have gone through the leaves that
// they have found. Rays for which any piece will do are mostly side by side and alike.
const uint boxesAtOnce = 8u;
const uint boxesAtOnceIfAlike = 12u;

// Goes to the next leaf that the ray meets, then through its pieces. Neighbours, each on its own way,
// have the same to do more often that way.
RayHit meetPieces(vec3 origin, vec3 direction, float minDistance, float maxDistance,
                  RayTarget target, bool anyWillDo) {
  Ray ray = makeRay(origin, direction);
  RayHit hit = RayHit(maxDistance, noPiece);
  uint pieces = piecesOfSurfels();
  uint node = target.firstNode;
  while (node < target.endNode && !(anyWillDo && hit.piece != noPiece)) {
    uint met = 0u;  // link of a leaf, which is not 0
    uint boxes = 0u;
    do {
      RayBox box = boxOf(node);
      uint link = box.sidesLink.w;
      bool meets = meetsBox(ray, sidesOf(box), hit.distance);
      bool leaf = isLeaf(link);
      if (meets && leaf) met = link;
      node = meets || leaf ? node + 1u : afterNode(node, link);
    } while (node < target.endNode && met == 0u && ++boxes < (anyWillDo ? boxesAtOnceIfAlike : boxesAtOnce));
    uint piece = firstSurfelOf(met) * pieces;
    uint end = piece + surfelCountOf(met) * pieces;
    for (; piece < end; ++piece) meetPiece(ray, piece, minDistance, hit);
  }
  return hit;
}

RayHit nearestHitOfOthers(vec3 origin, vec3 direction, float minDistance, float maxDistance, RayTarget body,
                          uint nodeCount) {
  RayTarget before = RayTarget(0u, body.firstNode, everyObject);
  RayTarget after = RayTarget(body.endNode, nodeCount, everyObject);
  RayHit first = meetPieces(origin, direction, minDistance, maxDistance, before, false);
  RayHit second = meetPieces(origin, direction, minDistance, first.distance, after, false);
  return second.piece != noPiece ? second : first;
}

#endif
