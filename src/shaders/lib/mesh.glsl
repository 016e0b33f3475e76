// The triangles of this frame, and places on them as the camera sees them. Needs, before it,
// lib/frame.glsl and MESH_BINDING, the first of four bindings; BINDING_MESH_EXITANCES for light.
#ifndef OPALINE_LIB_MESH
#define OPALINE_LIB_MESH
#define BINDING_VERTICES MESH_BINDING + 1
#include "lib/texels.glsl"
#include "lib/unit.glsl"
#include "lib/vertex_at.glsl"

layout(std430, set = 0, binding = MESH_BINDING) readonly buffer MeshIndices { uint meshIndices[]; };
layout(std430, set = 0, binding = MESH_BINDING + 3) readonly buffer MeshObjects { uint meshObjects[]; };

struct MeshPlace {
  uvec3 vertices;  // of the triangle
  vec3 weights;    // of them; their sum is 1
  uint object;
  vec3 position;  // mm
  vec3 inside;    // mm; inside the triangle. Where its plane goes on beyond it, the body may be in front
  vec3 normal;    // unit, interpolated, towards the side that is seen
  float side;     // -1 where that side is the inside, else 1
  vec3 facet;     // unit, at right angles to the triangle, towards the camera
};

uvec3 verticesOf(uint triangle) {
  return uvec3(meshIndices[3u * triangle], meshIndices[3u * triangle + 1u], meshIndices[3u * triangle + 2u]);
}

uint objectOfTriangle(uint triangle) {
  return meshObjects[meshIndices[3u * triangle]];
}

float cross2(vec2 a, vec2 b) {
  return a.x * b.y - a.y * b.x;
}

// Weights of the triangle's corners where a line of sight meets its plane (Olano and Greer 1997). `clip`
// is the line's place in clip space, over w. Relative to it, nothing that is subtracted is large.
vec3 weightsOn(uvec3 vertices, vec2 clip) {
  vec2 off[3];
  for (int i = 0; i < 3; ++i) {
    vec4 corner = frame.worldToClip * vec4(positionOf(vertices[i]), 1.0);
    off[i] = corner.xy - clip * corner.w;
  }
  vec3 areas = vec3(cross2(off[1], off[2]), cross2(off[2], off[0]), cross2(off[0], off[1]));
  float sum = areas.x + areas.y + areas.z;
  return sum != 0.0 ? areas / sum : vec3(1.0 / 3.0);
}

// How far beyond the triangle its plane may go on. A line may miss the triangle by part of a pixel,
// which is far for one that is seen edge on.
const float furthestOutside = 0.5;

vec3 weightsNear(uvec3 vertices, vec2 clip) {
  vec3 weights = clamp(weightsOn(vertices, clip), -furthestOutside, 1.0 + furthestOutside);
  return weights / (weights.x + weights.y + weights.z);
}

// The interpolated normal, on the side of those of the vertices.
vec3 normalOn(uvec3 vertices, vec3 weights) {
  return unitOr(mat3(normalOf(vertices.x).xyz, normalOf(vertices.y).xyz, normalOf(vertices.z).xyz) *
                    weights, vec3(0.0, 1.0, 0.0));
}

MeshPlace placeOn(uint triangle, vec2 clip) {
  MeshPlace place;
  place.vertices = verticesOf(triangle);
  place.weights = weightsNear(place.vertices, clip);
  vec3 a = positionOf(place.vertices.x);
  vec3 b = positionOf(place.vertices.y);
  vec3 c = positionOf(place.vertices.z);
  place.position = mat3(a, b, c) * place.weights;
  vec3 inside = max(place.weights, 0.0);
  place.inside = mat3(a, b, c) * (inside / (inside.x + inside.y + inside.z));
  place.object = meshObjects[place.vertices.x];
  vec3 normal = normalOn(place.vertices, place.weights);
  vec3 facet = unitOr(cross(unitOr(b - a, vec3(0.0)), unitOr(c - a, vec3(0.0))), normal);
  bool front = dot(facet, toCameraFrom(a)) > 0.0;
  place.facet = front ? facet : -facet;
  bool mirrored = normalOf(place.vertices.x).w < 0.0;
  place.side = front != mirrored ? 1.0 : -1.0;
  place.normal = place.side * normal;
  return place;
}

// The place on the smooth surface to which the normals of the corners belong. It is lifted out of the
// triangle, so that what these normals turn to a light is not in the triangle's own shadow (Hanika 2021).
vec3 liftedPlace(MeshPlace place) {
  vec3 lifted = place.position;
  for (int i = 0; i < 3; ++i) {
    vec3 normal = place.side * normalOf(place.vertices[i]).xyz;
    float below = min(dot(place.position - positionOf(place.vertices[i]), normal), 0.0);
    lifted -= clamp(place.weights[i], 0.0, 1.0) * below * normal;
  }
  return lifted;
}

// The same place, seen from behind.
MeshPlace otherSideOf(MeshPlace place) {
  place.side = -place.side;
  place.normal = -place.normal;
  place.facet = -place.facet;
  return place;
}

#ifdef BINDING_MESH_EXITANCES
TEXELS(BINDING_MESH_EXITANCES, meshExitances);

// The light of vertices, which begins at `first`. The mean place of samples may lie a little outside its triangle.
vec4 meshExitanceAt(MeshPlace place, uint first) {
  vec4 between = place.weights.x * texelOf(meshExitances, int(first + place.vertices.x)) +
                 place.weights.y * texelOf(meshExitances, int(first + place.vertices.y)) +
                 place.weights.z * texelOf(meshExitances, int(first + place.vertices.z));
  return max(between, vec4(0.0));
}

vec4 meshExitanceAt(MeshPlace place) {
  return meshExitanceAt(place, 0u);
}
#endif

#ifdef BINDING_MESH_ORIGINS
#include "lib/origin.glsl"

TEXELS(BINDING_MESH_ORIGINS, meshOrigins);

// Origins of the light that leaves there.
vec4 meshOriginAt(MeshPlace place) {
  return place.weights.x * texelOf(meshOrigins, int(place.vertices.x)) +
         place.weights.y * texelOf(meshOrigins, int(place.vertices.y)) +
         place.weights.z * texelOf(meshOrigins, int(place.vertices.z));
}
#endif

#endif
