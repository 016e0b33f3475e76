// Which surfel lies at every visible pixel, and which cluster and node hold it.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 2
#define BINDING_PIECE_CORNERS 3
#define BINDING_RAYS 4
#include "lib/bodies.glsl"
#include "lib/rays.glsl"
#include "lib/tile.glsl"

layout(set = 0, binding = 0) uniform sampler2D surfacePosition;
layout(set = 0, binding = 1, rgba32f) uniform writeonly image2D seen;  // passes::SeenSurfels
layout(std430, set = 0, binding = 5) readonly buffer ClusterOfSurfel { uint clusterOfSurfel[]; };

layout(push_constant) uniform Push {
  uint treeLevel;
  uint hasClusters;
};

struct Nearest {
  float square;  // of its distance, mm²; at first, of the largest allowed
  uint piece;    // or noPiece
  uint leaf;     // the node that holds it
};

float squareOf(vec3 v) {
  return dot(v, v);
}

float squareToEdge(vec3 fromA, vec3 edge) {
  return squareOf(fromA - clamp(dot(fromA, edge) / dot(edge, edge), 0.0, 1.0) * edge);
}

float squareToPiece(vec3 place, vec3 a, vec3 b, vec3 c) {
  vec3 normal = cross(b - a, c - a);
  vec3 sides = vec3(dot(cross(b - a, place - a), normal), dot(cross(c - b, place - b), normal),
                    dot(cross(a - c, place - c), normal));
  if (all(greaterThanEqual(sides, vec3(0.0)))) {
    float above = dot(normalize(normal), place - a);
    return above * above;
  }
  return min(min(squareToEdge(place - a, b - a), squareToEdge(place - b, c - b)),
             squareToEdge(place - c, a - c));
}

void meetLeaf(vec3 place, uint node, uint link, inout Nearest nearest) {
  uint pieces = piecesOfSurfels();
  uint first = firstSurfelOf(link) * pieces;
  uint end = first + surfelCountOf(link) * pieces;
  for (uint piece = first; piece < end; ++piece) {
    int at = 3 * int(piece);
    vec4 c = texelOf(pieceCorners, at + 2);
    if (c.w < 0.0) continue;  // fills a surfel, or has no area
    float square = squareToPiece(place, texelOf(pieceCorners, at).xyz,
                                 texelOf(pieceCorners, at + 1).xyz, c.xyz);
    if (square < nearest.square) nearest = Nearest(square, piece, node);
  }
}

Nearest nearestPiece(vec3 place, uint firstNode, uint endNode, float within) {
  Nearest nearest = Nearest(within * within, noPiece, firstNode);
  vec4 middleUnit = middleUnitOfBoxes();
  vec3 inUnits = (place - middleUnit.xyz) / middleUnit.w;
  uint node = firstNode;
  while (node < endNode) {
    RayBox box = boxOf(node);
    uint link = box.sidesLink.w;
    mat2x3 sides = sidesOf(box);
    bool near = squareOf(middleUnit.w * (inUnits - clamp(inUnits, sides[0], sides[1]))) < nearest.square;
    if (near && isLeaf(link)) meetLeaf(place, node, link, nearest);
    node = near ? node + 1u : afterNode(node, link);
  }
  return nearest;
}

uint afterNode(uint node) {
  return afterNode(node, boxOf(node).sidesLink.w);
}

// The node that many levels below the root, on the way from it to a leaf.
uint nodeAtLevel(uint root, uint leaf, uint level) {
  uint node = root;
  for (uint i = 0u; i < level && node != leaf; ++i) {
    node += 1u;
    for (uint after = afterNode(node); after <= leaf; after = afterNode(node)) node = after;
  }
  return node;
}

void main() {
  ivec2 pixel = pixelOfInvocation();
  if (any(greaterThanEqual(pixel, imageSize(seen)))) return;
  vec4 surface = texelFetch(surfacePosition, pixel, 0);
  vec4 found = vec4(-1.0);
  if (surface.w > 0.0) {
    uvec4 tree = objects[uint(surface.w) - 1u].tree;
    mat2x3 sides = sidesOf(boxOf(tree.x));
    float across = middleUnitOfBoxes().w * length(sides[1] - sides[0]);
    // The place lies on its piece except for rounding, so the search starts there and then goes further off.
    Nearest nearest;
    nearest.piece = noPiece;
    for (float part = 1.0 / 65536.0; part < 16.0 && nearest.piece == noPiece; part *= 64.0)
      nearest = nearestPiece(surface.xyz, tree.x, tree.y, part * across);
    if (nearest.piece != noPiece) {
      uint surfel = nearest.piece / piecesOfSurfels();
      float cluster = hasClusters != 0u ? float(clusterOfSurfel[surfel]) : -1.0;
      uint node = nodeAtLevel(tree.x, nearest.leaf, treeLevel);
      found = vec4(float(surfel), cluster, float(node), 1.0);
    }
  }
  imageStore(seen, pixel, found);
}
