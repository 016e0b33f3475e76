// The clusters as they are in this frame: place, area, and the light that enters through them, of
// each light by itself and of all that comes from everywhere.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_SKY_IRRADIANCE 7
#define BINDING_OBJECTS 4
#define BINDING_MEDIA 5
#include "lib/boundary.glsl"
#include "lib/frame.glsl"
#include "lib/area_light.glsl"
#include "lib/light.glsl"
#include "lib/linear.glsl"
#include "lib/moment.glsl"
#include "lib/piece.glsl"
#include "lib/sky.glsl"
#include "lib/unit.glsl"

// Else the shader has no code for them: on devices that execute both sides of a branch it would be run for
// every light.
layout(constant_id = 0) const uint withAreaLights = 1u;

// Some bodies have normal textures.
layout(constant_id = 1) const uint withNormals = 0u;
#define BINDING_TILTS 12
#include "lib/tilted_normal.glsl"

layout(std430, set = 0, binding = 1) readonly buffer Positions { vec4 positions[]; };
layout(std430, set = 0, binding = 2) readonly buffer Normals { vec4 normals[]; };
layout(std430, set = 0, binding = 3) readonly buffer Pieces { SurfelPiece pieces[]; };
layout(std430, set = 0, binding = 6) readonly buffer Visibilities { uint visibilities[]; };
layout(std430, set = 0, binding = 8) readonly buffer Ranges { ClusterRange ranges[]; };
layout(std430, set = 0, binding = 9) writeonly buffer Clusters { Cluster clusters[]; };
layout(std430, set = 0, binding = 10) writeonly buffer Nodes { ClusterNode nodes[]; };
layout(std430, set = 0, binding = 11) writeonly buffer Entries { Entry entries[]; };

layout(push_constant) uniform Push {
  uint clusterCount;
  uint piecesPerSurfel;
  uint pieceCount;
};

// How far a cluster is felt by the interpolation between clusters, in edges of it as a square.
const float reachInEdges = 1.7;

struct PieceShape {
  vec3 corners[3];
  vec3 vectorArea;  // outwards
  float area;
  mat3 itsNormals;  // at the triangle's corners
  mat3x2 places;    // of the piece's corners, see lib/piece.glsl
  vec3 along;       // edges of the triangle
  vec3 across;
};

// Of the cluster, ClusterRange::side.
float facing = 1.0;

PieceShape shapeOf(SurfelPiece piece) {
  PieceShape shape;
  vec3 origin = positions[piece.a].xyz;
  vec3 along = positions[piece.b].xyz - origin;
  vec3 across = positions[piece.c].xyz - origin;
  shape.places = cornersOf(piece);
  for (int i = 0; i < 3; ++i)
    shape.corners[i] = origin + shape.places[i].x * along + shape.places[i].y * across;
  vec4 a = normals[piece.a];
  shape.vectorArea = facing * a.w * 0.5 * max(piece.fraction, 0.0) * cross(along, across);
  shape.area = length(shape.vectorArea);
  shape.along = along;
  shape.across = across;
  shape.itsNormals = facing * mat3(a.xyz, normals[piece.b].xyz, normals[piece.c].xyz);
  return shape;
}

vec3 middleOf(PieceShape shape) {
  return (shape.corners[0] + shape.corners[1] + shape.corners[2]) / 3.0;
}

// Of a light, by the cosine to the facet, so that no light is lost or gained. What of it is visible
// has been looked up where the surfels gathered.
vec3 enteringAt(vec3 place, vec3 facet, MediumData medium, uint index, uint piece, uint point) {
  float visible = unpackVisibility(visibilities[visibilityIndex(index, piece, pieceCount)], point);
  if (withAreaLights != 0u && index >= firstAreaLight()) return visible * areaEntering(index, place, facet, medium);
  IncidentLight light = incidentLight(index, place);
  return light.irradiance * (enteringPart(light, facet, facet, medium) * visible);
}

// Light that enters through a piece, mean over its points: of a light, or from everywhere.
const uint everywhere = 0xffffffffu;
vec3 enteringThrough(uint piece, PieceShape shape, ObjectData body, uint light) {
  vec3 sum = vec3(0.0);
  vec3 facet = unitOr(shape.vectorArea, vec3(0.0, 1.0, 0.0));
  vec3 middle = middleOf(shape);
  float even = 1.0;
  if (withNormals != 0u) {
    if (light != everywhere) even = evenness(piece);
    facet = tiltedNormal(piece, shape.along, shape.across, facet);
  }
  for (uint i = 0u; i < pointsPerPiece; ++i) {
    vec2 at = pointOf(shape.places, i);
    vec3 normal = unitOr(shape.itsNormals * vec3(1.0 - at.x - at.y, at), facet);
    if (withNormals != 0u) normal = tiltedNormal(piece, shape.along, shape.across, normal);
    vec3 place = 0.5 * (middle + shape.corners[i]);
    MediumData medium = mediumAt(body, place);
    sum += light == everywhere ? skyIrradianceAt(normal, medium)
                               : enteringAt(place, facet, medium, light, piece, i);
  }
  return withNormals != 0u ? even * sum / float(pointsPerPiece) : sum / float(pointsPerPiece);
}

// Whether any of its points sees the light, if the shape has an area.
bool isLit(uint piece, uint light) {
  return light == everywhere || visibilities[visibilityIndex(light, piece, pieceCount)] != 0u;
}

Entry entryOf(uint first, uint end, Cluster cluster, float area, ObjectData body, uint light) {
  vec3 sum = vec3(0.0);
  vec3 weighted = vec3(0.0);
  vec3 normal = vec3(0.0);
  float all = 0.0;
  for (uint k = first; k < end; ++k) {
    PieceShape shape = shapeOf(pieces[k]);
    vec3 entering = enteringThrough(k, shape, body, light);
    float amount = entering.r + entering.g + entering.b;
    sum += shape.area * entering;
    weighted += shape.area * amount * middleOf(shape);
    normal += amount * shape.vectorArea;
    all += shape.area * amount;
  }
  if (all <= 0.0 || area <= 0.0) return Entry(vec4(0.0), cluster.centroidArea, cluster.normal, cluster.start);
  vec3 place = weighted / all;
  vec3 start = cluster.start.xyz;
  float least = 3e38;
  for (uint k = first; k < end; ++k) {
    PieceShape shape = shapeOf(pieces[k]);
    vec3 offset = middleOf(shape) - place;
    if (dot(offset, offset) >= least || shape.area <= 0.0 || !isLit(k, light)) continue;
    least = dot(offset, offset);
    start = middleOf(shape);
  }
  return Entry(vec4(sum / area, 0.0), vec4(place, 0.0),
               vec4(unitOr(normal, cluster.normal.xyz), 0.0), vec4(start, 0.0));
}

void main() {
  uint i = linearIndex();
  if (i >= clusterCount) return;
  ClusterRange range = ranges[i];
  // A mirrored body's triangles go round the other way.
  float side = range.side * normals[pieces[range.firstSurfel * piecesPerSurfel].a].w;
  facing = range.side;
  ObjectData body = objects[range.object];
  uint first = range.firstSurfel * piecesPerSurfel;
  uint end = range.endSurfel * piecesPerSurfel;

  float area = 0.0;
  vec3 byArea = vec3(0.0);
  vec3 vectorArea = vec3(0.0);
  for (uint k = first; k < end; ++k) {
    PieceShape shape = shapeOf(pieces[k]);
    area += shape.area;
    byArea += shape.area * middleOf(shape);
    vectorArea += shape.vectorArea;
  }
  vec3 middle = area > 0.0 ? byArea / area : positions[pieces[first].a].xyz;
  vec3 normal = unitOr(vectorArea, vec3(0.0, 1.0, 0.0));

  // The piece whose middle is nearest stands for the cluster where it has to be on the surface.
  float square = 0.0;
  float radius = 0.0;
  float least = 3e38;
  uint nearest = first;
  Moment moment = Moment(vec4(0.0), vec2(0.0));
  for (uint k = first; k < end; ++k) {
    PieceShape shape = shapeOf(pieces[k]);
    for (int c = 0; c < 3; ++c) {
      vec3 offset = shape.corners[c] - middle;
      radius = max(radius, length(offset));
      vec3 between = 0.5 * (shape.corners[c] + shape.corners[(c + 1) % 3]) - middle;
      square += shape.area / 3.0 * dot(between, between);
    }
    vec3 offset = middleOf(shape) - middle;
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
  PieceShape there = shapeOf(pieces[nearest]);
  vec3 facet = unitOr(there.vectorArea, normal);
  vec3 along = unitOr(there.corners[1] - there.corners[0], vec3(1.0, 0.0, 0.0));

  float reach = range.kind == lining ? 0.0 : max(1.2 * radius, reachInEdges * sqrt(area));
  Cluster cluster = Cluster(vec4(middle, area), vec4(normal, sqrt(area / pi)), vec4(vectorArea, 0.5),
                        vec4(middleOf(there), 0.0), vec4(along, side), vec4(facet, 0.0), vec4(0.0));
  float areaOfEntries = range.kind == openBody || range.kind == lining ? 0.0 : area;
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

  for (uint beam = 0u; beam <= allLightsAt(middle); ++beam)
    entries[beam * clusterCount + i] =
        entryOf(first, end, cluster, areaOfEntries, body, beam < frame.counts.w ? beam : everywhere);
}
