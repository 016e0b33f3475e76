// The pieces of surfels where they lie in this frame, and boxes around those of each leaf.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_PIECES 3
#define BINDING_VERTICES 2
#include "lib/bounds.glsl"
#include "lib/linear.glsl"
#include "lib/piece_at.glsl"
#include "lib/position_at.glsl"
#include "lib/ray_box.glsl"
#include "lib/tree_node.glsl"

layout(constant_id = 0) const uint forQueries = 0u;

layout(std430, set = 0, binding = 0) readonly buffer Links { uint links[]; };
layout(std430, set = 0, binding = 1) readonly buffer LeafNodes { uint leafNodes[]; };
layout(std430, set = 0, binding = 4) writeonly buffer RayPieces { RayPiece rayPieces[]; };
layout(std430, set = 0, binding = 5) writeonly buffer RayBoxes {
  RayUnits units;
  RayBox ofNodes[];
} boxes;
layout(std430, set = 0, binding = 6) readonly buffer Bounds { uint bounds[6]; };

layout(push_constant) uniform Push {
  uint leafCount;
  uint piecesPerSurfel;
};

// Parts of coordinates: some roundings of them, and those that the device's hardware or driver
// makes for rays, as measured on a software one.
const float roundedInQueries = 1.0 / float(1u << 19u);
const float roundedPart = 1.0 / float(1u << 21u);

const float neverHit = -1e30;

float largestOf(vec3 v) {
  return max(max(v.x, v.y), v.z);
}

vec3 cornerAt(mat3 triangle, float v, float w) {
  return (1.0 - v - w) * triangle[0] + v * triangle[1] + w * triangle[2];
}

// Moves edges outwards by that much, mm, by enlarging the piece about the middle of its inscribed
// circle. It grows by a thousandth at most, so that needles stay where they are.
mat3 widened(mat3 corners, float byMm) {
  vec3 edges = vec3(distance(corners[1], corners[2]), distance(corners[2], corners[0]),
                    distance(corners[0], corners[1]));
  float around = edges.x + edges.y + edges.z;
  vec3 middle = corners * edges / around;
  float twiceArea = length(cross(corners[1] - corners[0], corners[2] - corners[0]));
  float part = min(byMm * around / max(twiceArea, 1e-30), 1e-3);
  for (int k = 0; k < 3; ++k) corners[k] += part * (corners[k] - middle);
  return corners;
}

// How far the furthest corner is from the middle, without a ground. A ground may be a thousand times as far before it
// exceeds half floats, which would let rays meet all of its boxes there.
const float furthestUnits = 64.0;

vec4 middleUnit() {
  vec3 low = vec3(unordered(bounds[0]), unordered(bounds[1]), unordered(bounds[2]));
  vec3 high = vec3(unordered(~bounds[3]), unordered(~bounds[4]), unordered(~bounds[5]));
  return vec4(0.5 * (low + high), max(largestOf(high - low), 1e-30) / (2.0 * furthestUnits));
}

void main() {
  uint i = linearIndex();
  if (i >= leafCount) return;
  vec4 its = middleUnit();
  if (i == 0u) boxes.units = RayUnits(its, vec4(float(piecesPerSurfel)));
  uint node = leafNodes[i];
  uint link = links[node];
  uint from = firstSurfelOf(link) * piecesPerSurfel;
  uint to = from + surfelCountOf(link) * piecesPerSurfel;

  vec3 low = vec3(0.0);
  vec3 high = vec3(0.0);
  for (uint p = from; p < to; ++p) {
    SurfelPiece piece = pieceAt(p);
    mat3 triangle = mat3(positionOf(piece.a), positionOf(piece.b), positionOf(piece.c));
    mat3 corners =
        mat3(cornerAt(triangle, piece.v0, piece.w0), cornerAt(triangle, piece.v1, piece.w1),
             cornerAt(triangle, piece.v2, piece.w2));
    vec3 along = corners[1] - corners[0];
    vec3 across = corners[2] - corners[0];
    vec3 opposite = corners[2] - corners[1];
    float longest = sqrt(max(max(dot(along, along), dot(across, across)), dot(opposite, opposite)));
    vec3 furthest = max(max(abs(corners[0]), abs(corners[1])), abs(corners[2]));
    float reachSlack = roundedPart * longest;
    float slack = reachSlack * largestOf(furthest);
    bool never = piece.fraction <= 0.0 ||
                 !(length(cross(along, across)) > 0.5 * roundedPart * longest * longest);
    // Whole triangles share their corners with others bit by bit.
    bool whole = piece.fraction == 1.0;
    // Ray queries know no slack: pieces overlap for them, and what is never hit has no area.
    if (forQueries != 0u)
      corners = never ? mat3(corners[0], corners[0], corners[0])
                      : widened(corners, roundedInQueries * largestOf(furthest));
    rayPieces[p] = RayPiece(vec4(corners[0], float(piece.object)),
                            vec4(corners[1], never || whole ? 0.0 : reachSlack),
                            vec4(corners[2], never ? neverHit : whole ? 0.0 : slack));
    if (p == from) low = high = corners[0];
    if (never) continue;
    low = min(low, min(min(corners[0], corners[1]), corners[2]));
    high = max(high, max(max(corners[0], corners[1]), corners[2]));
  }
  vec3 off = max(abs(low - its.xyz), abs(high - its.xyz));
  float margin = roundedPart * max(largestOf(max(abs(low), abs(high))), largestOf(off));
  boxes.ofNodes[node] = packedBox((low - margin - its.xyz) / its.w, (high + margin - its.xyz) / its.w, link);
}
