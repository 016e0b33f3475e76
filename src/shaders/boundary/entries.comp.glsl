// The light that enters through the clusters in this frame: of each light by itself and, last, all from everywhere.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_SKY_IRRADIANCE 7
#define BINDING_OBJECTS 4
#define BINDING_MEDIA 5
#define BINDING_PIECES 3
#define BINDING_VERTICES 1
#include "lib/boundary.glsl"
#include "lib/frame.glsl"
#include "lib/area_light.glsl"
#include "lib/light.glsl"
#include "lib/linear.glsl"
#include "lib/piece.glsl"
#include "lib/piece_at.glsl"
#include "lib/sky.glsl"
#include "lib/unit.glsl"
#include "lib/vertex_at.glsl"

// 0: the shader has no code for area lights. Devices that execute both sides of a branch would run it for every light.
layout(constant_id = 0) const uint withAreaLights = 1u;

// Some bodies have normal textures.
layout(constant_id = 1) const uint withNormals = 0u;
#define BINDING_TILTS 12
#include "lib/tilted_normal.glsl"

layout(std430, set = 0, binding = 6) readonly buffer Visibilities { uint visibilities[]; };
layout(std430, set = 0, binding = 8) readonly buffer Ranges { ClusterRange ranges[]; };
layout(std430, set = 0, binding = 9) readonly buffer Clusters { Cluster clusters[]; };
layout(std430, set = 0, binding = 11) writeonly buffer Entries { Entry entries[]; };

#include "lib/piece_shape.glsl"

layout(push_constant) uniform Push {
  uint clusterCount;
  uint piecesPerSurfel;
  uint pieceCount;
  uint skyIsDark;
};

// What enters of a light, by the cosine to the facet, so that no light is lost or gained. Its
// visible part was looked up where the surfels gathered.
vec3 enteringAt(vec3 place, vec3 facet, MediumData medium, uint index, uint piece, uint point) {
  float visible = unpackVisibility(visibilities[visibilityIndex(index, piece, pieceCount)], point);
  IncidentLight light = incidentLight(index, place);
  return light.irradiance * (enteringPart(light, facet, facet, medium) * visible);
}

// What enters of an area light, which a piece sees from its middle.
vec3 enteringOfArea(PieceShape shape, vec3 facet, ObjectData body, uint index, uint piece) {
  uint word = visibilities[visibilityIndex(index, piece, pieceCount)];
  if (word == 0u) return vec3(0.0);
  vec3 middle = middleOf(shape);
  return meanVisibility(word) * areaEntering(index, middle, facet, mediumAt(body, middle));
}

// Light that enters through a piece, from a light or from everywhere, as a mean over its points.
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
  if (withAreaLights != 0u && light != everywhere && light >= firstAreaLight())
    return even * enteringOfArea(shape, facet, body, light, piece);
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

Entry entryOf(uint first, uint end, Cluster cluster, ObjectData body, uint light) {
  float area = 0.0;
  vec3 sum = vec3(0.0);
  vec3 weighted = vec3(0.0);
  vec3 normal = vec3(0.0);
  float all = 0.0;
  for (uint k = first; k < end; ++k) {
    PieceShape shape = shapeOf(pieceAt(k));
    vec3 entering = enteringThrough(k, shape, body, light);
    area += shape.area;
    float amount = entering.r + entering.g + entering.b;
    sum += shape.area * entering;
    weighted += shape.area * amount * middleOf(shape);
    normal += amount * shape.vectorArea;
    all += shape.area * amount;
  }
  if (all <= 0.0 || area <= 0.0)
    return Entry(vec4(0.0), cluster.centroidArea, cluster.normal, cluster.start);
  vec3 place = weighted / all;
  vec3 start = cluster.start.xyz;
  float least = 3e38;
  for (uint k = first; k < end; ++k) {
    PieceShape shape = shapeOf(pieceAt(k));
    vec3 offset = middleOf(shape) - place;
    if (dot(offset, offset) >= least || shape.area <= 0.0 || !isLit(k, light)) continue;
    least = dot(offset, offset);
    start = middleOf(shape);
  }
  return Entry(vec4(sum / area, 0.0), vec4(place, 0.0),
               vec4(unitOr(normal, cluster.normal.xyz), 0.0), vec4(start, 0.0));
}

void main() {
  uint i = linearIndex() % clusterCount;
  uint beam = linearIndex() / clusterCount;
  if (beam > frame.counts.w) return;
  bool isOfLight = beam < frame.counts.w;
  ClusterRange range = ranges[i];
  Cluster cluster = clusters[i];
  facing = range.side;
  ObjectData body = objects[range.object];
  uint first = range.firstSurfel * piecesPerSurfel;
  bool takesLight = range.kind != openBody && range.kind != lining && (isOfLight || skyIsDark == 0u);
  uint end = takesLight ? range.endSurfel * piecesPerSurfel : first;
  entries[beam * clusterCount + i] = entryOf(first, end, cluster, body, isOfLight ? beam : everywhere);
}
