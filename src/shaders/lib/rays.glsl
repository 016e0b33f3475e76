// Where rays meet the surface of this frame, from either side. Needs, before it,
// BINDING_PIECE_CORNERS and BINDING_RAY_BOXES, the two buffers of a RayHierarchy.
//
// A ray is seen along its direction: pieces and it are turned so that it is the z axis. A corner
// that pieces share then lies at one place for all of them, and an edge between two pieces has the
// ray on one side or the other (as in Woop, Benthin and Wald 2013); where pieces do not share
// corners, or those only nearly, slack sees to it.
#ifndef OPALINE_LIB_RAYS
#define OPALINE_LIB_RAYS
#include "lib/tree_node.glsl"
#include "shared/rays.h"

layout(set = 0, binding = BINDING_PIECE_CORNERS) uniform samplerBuffer pieceCorners;  // RayPiece
layout(set = 0, binding = BINDING_RAY_BOXES) uniform samplerBuffer rayBoxes;          // RayBox

const uint noPiece = 0xffffffffu;

struct RayHit {
  float distance;  // in lengths of the direction; maxDistance where nothing is hit
  uint piece;      // or noPiece
};

struct Ray {
  vec3 origin;
  vec3 inverse;  // of the direction
  mat3 turn;     // its rows: two directions across, and that of which `distance` is in lengths
  float reach;   // largest coordinate of the origin, mm
};

// Smaller components of a direction, 0 too, are this, so that none has no inverse. Boxes are wide
// enough for it.
const float leastComponent = 1e-18;

Ray makeRay(vec3 origin, vec3 direction) {
  vec3 size = abs(direction);
  bvec3 small = lessThan(size, vec3(leastComponent));
  vec3 inverse = 1.0 / mix(direction, vec3(leastComponent), small);
  vec3 unit = normalize(direction);
  // Duff et al. 2017.
  float s = unit.z >= 0.0 ? 1.0 : -1.0;
  float a = -1.0 / (s + unit.z);
  float b = unit.x * unit.y * a;
  vec3 across = vec3(1.0 + s * unit.x * unit.x * a, s * b, -s * unit.x);
  vec3 up = vec3(b, s + unit.y * unit.y * a, -unit.y);
  vec3 places = abs(origin);
  return Ray(origin, inverse, transpose(mat3(across, up, direction / dot(direction, direction))),
             max(max(places.x, places.y), places.z));
}

// Whether some of the box may lie between the ray's origin and `furthest`.
bool meetsBox(Ray ray, vec3 low, vec3 high, float furthest) {
  vec3 toLow = (low - ray.origin) * ray.inverse;
  vec3 toHigh = (high - ray.origin) * ray.inverse;
  vec3 enters = min(toLow, toHigh);
  vec3 leaves = max(toLow, toHigh);
  const float rounded = 1.0 + 1.0 / float(1u << 21u);
  float enter = max(max(enters.x, enters.y), max(enters.z, 0.0));
  float leave = min(min(leaves.x, leaves.y), leaves.z) * rounded;
  return enter <= min(leave, furthest);
}

// Makes the piece the hit if the ray meets it further than `minDistance` and nearer than that.
void meetPiece(Ray ray, uint piece, float minDistance, inout RayHit hit) {
  int at = 3 * int(piece);
  vec4 a4 = texelFetch(pieceCorners, at);
  vec4 b4 = texelFetch(pieceCorners, at + 1);
  vec4 c4 = texelFetch(pieceCorners, at + 2);
  vec3 a = ray.turn * (a4.xyz - ray.origin);
  vec3 b = ray.turn * (b4.xyz - ray.origin);
  vec3 c = ray.turn * (c4.xyz - ray.origin);
  // Twice the areas of the ray with each edge, all of one sign where it passes between them. No
  // rounding gives one of the wrong sign, as long as none is left out.
  precise vec3 areas = vec3(c.x * b.y - c.y * b.x, a.x * c.y - a.y * c.x, b.x * a.y - b.y * a.x);
  float slack = b4.w * ray.reach + c4.w;
  float least = min(min(areas.x, areas.y), areas.z);
  float most = max(max(areas.x, areas.y), areas.z);
  if (least < -slack && most > slack) return;
  // A mean of the corners' distances, whatever the piece is like.
  vec3 parts = least >= -slack ? max(areas, 0.0) : max(-areas, 0.0);
  float all = parts.x + parts.y + parts.z;
  float distance = (parts.x * a.z + parts.y * b.z + parts.z * c.z) / all;
  if (all > 0.0 && distance > minDistance && distance < hit.distance) hit = RayHit(distance, piece);
}

// Goes to the next leaf that the ray meets, then through its pieces: neighbours, each on its own way,
// so have more often the same to do.
RayHit meetPieces(Ray ray, float minDistance, float maxDistance, uint firstNode, uint endNode,
                  bool anyWillDo) {
  RayHit hit = RayHit(maxDistance, noPiece);
  uint node = firstNode;
  while (node < endNode && !(anyWillDo && hit.piece != noPiece)) {
    uint piece = 0u;
    uint end = 0u;
    do {
      vec4 low = texelFetch(rayBoxes, 2 * int(node));
      vec4 high = texelFetch(rayBoxes, 2 * int(node) + 1);
      uint link = floatBitsToUint(low.w);
      bool met = meetsBox(ray, low.xyz, high.xyz, hit.distance);
      bool leaf = isLeaf(link);
      if (met && leaf) {
        uint pieces = uint(high.w);
        piece = firstSurfelOf(link) * pieces;
        end = piece + surfelCountOf(link) * pieces;
      }
      node = met || leaf ? node + 1u : afterNode(node, link);
    } while (node < endNode && piece == end);
    for (; piece < end; ++piece) meetPiece(ray, piece, minDistance, hit);
  }
  return hit;
}

// The nearest of the pieces below nodes firstNode .. endNode - 1 (a whole object's, or several
// objects') that a ray meets further than `minDistance` and nearer than `maxDistance`; distances in
// lengths of `direction`, which need not be 1. A ray that starts on a piece meets it at about 0, to
// either side: a millionth of the coordinates, and more the flatter it leaves.
RayHit nearestHit(vec3 origin, vec3 direction, float minDistance, float maxDistance, uint firstNode,
                  uint endNode) {
  return meetPieces(makeRay(origin, direction), minDistance, maxDistance, firstNode, endNode, false);
}

RayHit nearestHit(vec3 origin, vec3 direction, float maxDistance, uint firstNode, uint endNode) {
  return nearestHit(origin, direction, 0.0, maxDistance, firstNode, endNode);
}

// Whether there is any such piece.
bool occluded(vec3 origin, vec3 direction, float minDistance, float maxDistance, uint firstNode,
              uint endNode) {
  Ray ray = makeRay(origin, direction);
  return meetPieces(ray, minDistance, maxDistance, firstNode, endNode, true).piece != noPiece;
}

// Of a piece that was hit: unit, to the side from which its triangle's corners are seen
// counter-clockwise.
vec3 facetNormal(uint piece) {
  int at = 3 * int(piece);
  vec3 a = texelFetch(pieceCorners, at).xyz;
  return normalize(cross(texelFetch(pieceCorners, at + 1).xyz - a,
                         texelFetch(pieceCorners, at + 2).xyz - a));
}

uint objectOfPiece(uint piece) {
  return uint(texelFetch(pieceCorners, 3 * int(piece)).w);
}

// The nearest place where a ray through the inside of a body comes out: folds of the surface that it
// would have to enter by do not count. `side` is -1 where the body is mirrored.
RayHit nearestExit(vec3 origin, vec3 direction, float side, float minDistance, float maxDistance,
                   uint firstNode, uint endNode) {
  const uint mostFolds = 4u;
  RayHit hit;
  float from = minDistance;
  for (uint k = 0u; k < mostFolds; ++k) {
    hit = nearestHit(origin, direction, from, maxDistance, firstNode, endNode);
    if (hit.piece == noPiece || side * dot(facetNormal(hit.piece), direction) > 0.0) break;
    from = hit.distance + minDistance;
  }
  return hit;
}

#endif
