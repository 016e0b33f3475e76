// Adds what surfaces mirror of area lights to their radiance where pixels see them: GGX as a
// linearly transformed cosine lobe over the light's polygon (Heitz et al. 2016).
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_SEEN 1
#define BINDING_SEEN_LIST 2
#define BINDING_OBJECTS 4
#define BINDING_MEDIA 5
#define BINDING_PIECE_CORNERS 6
#define BINDING_RAYS 7
#define MESH_BINDING 11
#define BINDING_GLOSS 15
#include "lib/frame.glsl"
#include "lib/area_light.glsl"
#include "lib/axes.glsl"
#include "lib/gloss.glsl"
#include "lib/lattice.glsl"
#include "lib/material.glsl"
#include "lib/mesh.glsl"
#include "lib/piece.glsl"
#include "lib/rays.glsl"
#include "lib/ray_start.glsl"
#include "lib/seen_list.glsl"
#include "lib/specular_albedo.glsl"

layout(std430, set = 0, binding = 9) buffer Light { vec4 light[]; };  // radiance, by coverage
layout(std430, set = 0, binding = 10) readonly buffer Lobes { vec4 lobes[]; };

layout(std430, set = 0, binding = 16) readonly buffer GlossLobes { vec4 glossLobes[]; };
layout(std430, set = 0, binding = 17) readonly buffer Materials { SeenMaterial materials[]; };
// Where the pieces of each triangle, and the end, begin in the list of pieces that follows.
layout(std430, set = 0, binding = 18) readonly buffer PiecesOfTriangles { uint piecesOfTriangles[]; };
layout(std430, set = 0, binding = 19) readonly buffer Visibilities { uint visibilities[]; };

layout(push_constant) uniform Push {
  uint first;      // of the list
  uint nodeCount;  // of all surfels' trees
  uint piecesPerSurfel;
  uint pieceCount;
  uint triangleCount;
};

const uint lobeEntries = 16u;
// Parts of the radiance so far: what is worth being added, and what is worth sending rays for.
const float leastMirrored = 1e-3;
const float leastForRays = 1e-2;

uint firstPieceOf(uint object) {
  return objects[object].table.y * piecesPerSurfel;
}

// By the cosine of the view: tilt, along, across and skew (lights/reflection_lobe.h).
vec4 lobeAt(float cosine) {
  float place = clamp(cosine * float(lobeEntries) - 0.5, 0.0, float(lobeEntries) - 1.001);
  uint lower = uint(place);
  return mix(lobes[lower], lobes[lower + 1u], fract(place));
}

vec4 glossLobeAt(uint row, float cosine) {
  float place = clamp(cosine * float(lobeEntries) - 0.5, 0.0, float(lobeEntries) - 1.001);
  uint lower = row * lobeEntries + uint(place);
  return mix(glossLobes[lower], glossLobes[lower + 1u], fract(place));
}

// For opaque surfaces, each of which has its own roughness.
vec4 glossLobeOf(float alpha, float cosine) {
  float place = clamp(sqrt(alpha) * float(glossLobeRows) - 0.5, 0.0, float(glossLobeRows) - 1.001);
  return mix(glossLobeAt(uint(place), cosine), glossLobeAt(uint(place) + 1u, cosine), fract(place));
}

// A lobe in the scene: its own axes, and what widens it along them.
struct Lobe {
  vec3 along;
  vec3 across;
  vec3 axis;
  vec4 shape;
};

Lobe lobeOf(vec3 normal, vec3 mirrored, vec4 shape) {
  vec3 away = unitOr(dot(mirrored, normal) * mirrored - normal, axesAcross(normal)[0]);
  return Lobe(cos(shape.x) * away - sin(shape.x) * mirrored, cross(mirrored, away),
              cos(shape.x) * mirrored + sin(shape.x) * away, shape);
}

// Maps the scene to where the lobe is that of a cosine.
mat3 toCosineLobe(Lobe lobe) {
  return transpose(mat3((lobe.along - lobe.shape.w * lobe.axis) / lobe.shape.y,
                        lobe.across / lobe.shape.z, lobe.axis));
}

// The i-th direction of the lobe.
vec3 directionIn(Lobe lobe, uint i) {
  vec2 at = fract(0.5 + latticePlace(i));
  float radius = sqrt(at.x);
  vec2 place = radius * vec2(cos(2.0 * pi * at.y), sin(2.0 * pi * at.y));
  float height = sqrt(1.0 - at.x);
  return normalize((lobe.shape.y * place.x + lobe.shape.w * height) * lobe.along +
                   lobe.shape.z * place.y * lobe.across + height * lobe.axis);
}

// The place of the light that is mirrored in the middle of the lobe, or the nearest to it, relative to the surface.
vec3 mirroredPlace(AreaView view, vec3 mirrored) {
  if (view.shape == tubeShape) {
    vec3 across = cross(view.u, cross(mirrored, view.u));
    float along = dot(mirrored, across);
    float to = abs(along) > 1e-20 ? dot(view.middle, across) / along : 0.0;
    float part = dot(to * mirrored - view.middle, view.u) / max(dot(view.u, view.u), 1e-30);
    return onTube(view, clamp(part, -1.0, 1.0), vec2(1.0, 0.0));
  }
  vec3 normal = cross(view.u, view.v);
  float towards = dot(mirrored, normal);
  float to = dot(view.middle, normal) / (abs(towards) > 1e-20 ? towards : 1e-20);
  if (to <= 0.0) return view.middle;
  vec3 offset = to * mirrored - view.middle;
  float size = max(dot(normal, normal), 1e-30);
  vec2 at = vec2(dot(cross(offset, view.v), normal), dot(cross(view.u, offset), normal)) / size;
  at = view.shape == rectangleShape ? clamp(at, -0.999, 0.999) : at / max(length(at) / 0.999, 1.0);
  return view.middle + at.x * view.u + at.y * view.v;
}

const uint fewRays = 4u;
const uint mostRays = 16u;

// What the pieces of a triangle see of a light, if they are few and small enough to stand for it.
struct Sight {
  float part;
  bool isKnown;  // there are such pieces
  bool isOne;    // they all see all of it, or none of it
};
const uint mostPieces = 4u;

Sight sightOf(uint triangle, uint index) {
  uint begin = piecesOfTriangles[triangle];
  uint end = piecesOfTriangles[triangle + 1u];
  if (end == begin || end - begin > mostPieces) return Sight(0.0, false, false);
  bool all = true;
  bool none = true;
  float sum = 0.0;
  for (uint k = begin; k < end; ++k) {
    uint word = visibilities[visibilityIndex(index, piecesOfTriangles[triangleCount + 1u + k], pieceCount)];
    all = all && word == wholeVisibility;
    none = none && word == 0u;
    sum += meanVisibility(word);
  }
  return Sight(sum / float(end - begin), true, all || none);
}

bool isVisible(MeshPlace place, vec3 offset, Sight sight) {
  if (dot(offset, place.facet) <= 0.0) return false;
  if (sight.isOne) return sight.part > 0.5;
  RayStart start = rayStartOn(place);
  float least = start.least * inversesqrt(max(dot(offset, offset), 1e-30));
  return !occluded(start.origin, offset, least, 1.0, RayTarget(0u, nodeCount, everyObject));
}

// The visible part of what the lobe mirrors of a light. Where the first rays agree, these are enough.
float visiblePart(MeshPlace place, AreaView view, Lobe lobe, Sight sight) {
  float free = 0.0;
  for (uint i = 0u; i < mostRays; ++i) {
    if (i == fewRays && (free == 0.0 || free == float(fewRays))) return free / float(fewRays);
    if (isVisible(place, mirroredPlace(view, directionIn(lobe, i)), sight)) free += 1.0;
  }
  return free / float(mostRays);
}

// How a surface mirrors: which way it faces, the shape of the lobe, and how much it mirrors in all.
struct Mirror {
  vec3 normal;
  vec4 shape;
  vec3 albedo;
};

// Some translucent surfaces have a roughness or normals of their own.
layout(constant_id = 0) const uint withOwnSurfaces = 0u;
// There are such surfaces, or opaque ones. Without them no device reads `materials`.
layout(constant_id = 1) const uint withMaterials = 1u;

Mirror mirrorOf(Seen seen, MeshPlace place, vec3 toCamera) {
  ObjectData body = objects[place.object];
  if (withMaterials == 0u) {
    float cosine = clamp(dot(place.normal, toCamera), 1e-3, 1.0);
    return Mirror(place.normal, lobeAt(cosine), vec3(reflectedAlbedo(mediumAt(body, place.position), cosine)));
  }
  bool known = withOwnSurfaces != 0u || isOpaque(body);
  SeenMaterial material = materials[known ? seen.entry : 0u];
  vec3 normal = known ? material.normal.xyz : place.normal;
  float cosine = clamp(dot(normal, toCamera), 1e-3, 1.0);
  if (withOwnSurfaces != 0u && !isOpaque(body)) {
    MediumData medium = mediumAt(body, place.position);
    if (hasOwnSurface(medium))
      return Mirror(normal, glossLobeOf(material.diffuse.w, cosine),
                    vec3(reflectedAlbedo(medium, material.diffuse.w, cosine)));
  }
  if (!isOpaque(body))
    return Mirror(normal, lobeAt(cosine), vec3(reflectedAlbedo(mediumAt(body, place.position), cosine)));
  vec2 parts = glossOf(material, cosine);
  return Mirror(normal, glossLobeOf(material.diffuse.w, cosine),
                mirroredOf(material, parts));
}

// On top of what is `known` of the radiance there.
vec3 mirroredLights(Seen seen, MeshPlace place, vec3 known) {
  vec3 toCamera = normalize(toCameraFrom(place.position));
  Mirror mirror = mirrorOf(seen, place, toCamera);
  Lobe lobe = lobeOf(mirror.normal, reflect(-toCamera, mirror.normal), mirror.shape);
  mat3 toLobe = toCosineLobe(lobe);
  vec3 sum = vec3(0.0);
  for (uint i = firstAreaLight(); i < allLightsAt(place.position); ++i) {
    AreaView view = areaViewFrom(place.position, i);
    if (!view.shines) continue;
    float part = vectorIrradianceOf(view, toLobe, vec3(0.0, 0.0, 1.0)).z / pi;
    vec3 found = part * mirror.albedo * frame.lights[i].power.rgb;
    if (!any(greaterThan(found, leastMirrored * known))) continue;
    Sight sight = sightOf(triangleOf(seen.word), i);
    bool sendsRays = !sight.isKnown || sight.isOne || any(greaterThan(found, leastForRays * known));
    sum += (sendsRays ? visiblePart(place, view, lobe, sight) : sight.part) * found;
  }
  return sum;
}

void main() {
  Seen seen = seenOfInvocation(first);
  if (!seen.there) return;
  MeshPlace place = seenPlace(seen.pixel, seen.word);
  float coverage = coverageOf(samplesOf(seen.word));
  light[seen.entry].rgb += coverage * mirroredLights(seen, place, light[seen.entry].rgb / coverage);
}
