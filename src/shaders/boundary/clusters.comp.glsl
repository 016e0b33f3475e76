// The clusters as they are in this frame: place, area, and what follows from these in the tree.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_PIECES 3
#define BINDING_VERTICES 1
#include "lib/linear.glsl"
#include "lib/moment.glsl"
#include "lib/pi.glsl"
#include "lib/piece_at.glsl"
#include "lib/unit.glsl"
#include "lib/vertex_at.glsl"
#include "shared/boundary.h"
#include "shared/surfels.h"

layout(std430, set = 0, binding = 8) readonly buffer Ranges { ClusterRange ranges[]; };
layout(std430, set = 0, binding = 9) writeonly buffer Clusters { Cluster clusters[]; };
layout(std430, set = 0, binding = 10) writeonly buffer Nodes { ClusterNode nodes[]; };

#include "lib/piece_shape.glsl"

layout(push_constant) uniform Push {
  uint clusterCount;
  uint piecesPerSurfel;
};

// How far the interpolation between clusters feels a cluster, in edges of it as a square.
const float reachInEdges = 1.7;

void main() {
  uint i = linearIndex();
  if (i >= clusterCount) return;
  ClusterRange range = ranges[i];
  // A mirrored body's triangles go round the other way.
  float side = range.side * normalOf(pieceAt(range.firstSurfel * piecesPerSurfel).a).w;
  facing = range.side;
  uint first = range.firstSurfel * piecesPerSurfel;
  uint end = range.endSurfel * piecesPerSurfel;

  float area = 0.0;
  vec3 byArea = vec3(0.0);
  vec3 vectorArea = vec3(0.0);
  for (uint k = first; k < end; ++k) {
    PieceShape shape = shapeOf(pieceAt(k));
    area += shape.area;
    byArea += shape.area * middleOf(shape);
    vectorArea += shape.vectorArea;
  }
  vec3 middle = area > 0.0 ? byArea / area : positionOf(pieceAt(first).a);
  vec3 normal = unitOr(vectorArea, vec3(0.0, 1.0, 0.0));

  // Where the cluster has to be on the surface, the piece whose middle is nearest stands for it.
  float square = 0.0;
  float radius = 0.0;
  float least = 3e38;
  float turned = 0.0;
  float spread = 0.0;
  uint nearest = first;
  Moment moment = Moment(vec4(0.0), vec2(0.0));
  for (uint k = first; k < end; ++k) {
    PieceShape shape = shapeOf(pieceAt(k));
    for (int c = 0; c < 3; ++c) {
      vec3 offset = shape.corners[c] - middle;
      radius = max(radius, length(offset));
      vec3 between = 0.5 * (shape.corners[c] + shape.corners[(c + 1) % 3]) - middle;
      square += shape.area / 3.0 * dot(between, between);
    }
    vec3 offset = middleOf(shape) - middle;
    turned += dot(offset, shape.vectorArea);
    spread += shape.area * dot(offset, offset);
    Moment shifted = momentOfArea(shape.vectorArea, offset);
    moment.first += shifted.first;
    moment.rest += shifted.rest;
    float squared = dot(offset, offset) + (dot(shape.vectorArea, normal) > 0.0 ? 0.0 : 1e30);
    if (shape.area > 0.0 && squared < least) {
      least = squared;
      nearest = k;
    }
  }
  if (area > 0.0) square /= area;
  PieceShape there = shapeOf(pieceAt(nearest));
  vec3 facet = unitOr(there.vectorArea, normal);
  vec3 along = unitOr(there.corners[1] - there.corners[0], vec3(1.0, 0.0, 0.0));

  // On a sphere of radius R about the origin, the normal at x is x/R.
  float mostCurved = 1.0 / max(radius, 1e-30);
  float curvature = clamp(turned / max(spread, 1e-30), -mostCurved, mostCurved);
  float reach = range.kind == lining ? 0.0 : max(1.2 * radius, reachInEdges * sqrt(area));
  Cluster cluster = Cluster(vec4(middle, area), vec4(normal, sqrt(area / pi)), vec4(vectorArea, 0.5),
                        vec4(middleOf(there), 0.0), vec4(along, side), vec4(facet, 0.0), vec4(0.0), vec4(vec3(1.0), curvature));
  if (!boundsDiffusion(range.kind)) {
    cluster.centroidArea.w = 0.0;
    cluster.vectorArea = vec4(0.0);
    area = 0.0;
    vectorArea = vec3(0.0);
    moment = Moment(vec4(0.0), vec2(0.0));
  }
  clusters[i] = cluster;
  nodes[range.node] = ClusterNode(vec4(middle, uintBitsToFloat(leafBit | setBit | i)),
                                  vec4(radius, square, reach, area), vec4(vectorArea, float(range.object)),
                                  moment.first, vec4(moment.rest, 0.0, 0.0));
}
