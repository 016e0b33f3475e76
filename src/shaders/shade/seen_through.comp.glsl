// What is seen through translucent surfaces by light that the body does not scatter: lines of sight are refracted into
// it and out of it, and go on until they meet an opaque surface, a light or the sky. On the way they meet other bodies,
// whose light is added. Every second pixel of every second row is looked from first. Other pixels are interpolated
// between these where they agree.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_SEEN 1
#define BINDING_SEEN_LIST 2
#define MESH_BINDING 9
#define BINDING_OBJECTS 4
#define BINDING_MEDIA 5
#define BINDING_PIECE_CORNERS 6
#define BINDING_RAYS 7
#define BINDING_CLUSTER_PAINTS 8
#define BINDING_CLUSTER_NODES 20
#define BINDING_CLUSTERS 13
#define BINDING_PIECES 21
#include "lib/frame.glsl"
#include "lib/boundary.glsl"
#include "lib/clusters_around.glsl"
#include "lib/fresnel.glsl"
#include "lib/piece_at.glsl"
#include "lib/places_in_pixel.glsl"
#include "lib/rays.glsl"
#include "lib/seen_list.glsl"
#include "lib/footprint.glsl"
#include "lib/sight.glsl"
#include "lib/tile.glsl"
#include "lib/visible_light.glsl"
#include "shared/opaque.h"

layout(std430, set = 0, binding = 14) readonly buffer Ranges { ClusterRange ranges[]; };
layout(std430, set = 0, binding = 15) readonly buffer ClusterOfSurfel { uint clusterOfSurfel[]; };
layout(std430, set = 0, binding = 16) readonly buffer Exitances { vec4 exitances[]; };
layout(std430, set = 0, binding = 17) readonly buffer OpaqueExitances { vec4 opaqueExitances[]; };
layout(std430, set = 0, binding = 18) buffer Materials { SeenMaterial materials[]; };
layout(set = 0, binding = 19) uniform sampler2D environment;
// By pixels of the grid in a band; w: see markOf(), or 0.
layout(std430, set = 0, binding = 22) buffer Found { vec4 found[]; };
layout(std430, set = 0, binding = 23) readonly buffer Entries { uint entryOfPixel[]; };
layout(std430, set = 0, binding = 24) readonly buffer Means { vec4 means[]; };  // exitance of half-spaces

layout(constant_id = 0) const uint withPaint = 0u;
layout(constant_id = 1) const uint onGrid = 0u;

layout(push_constant) uniform Push {
  vec4 ambient;  // rgb: radiance of the sky on top of the environment's
  uint first;
  uint nodeCount;  // of all surfels' trees
  uint piecesPerSurfel;
  uint ownSurfaces;  // 1: `materials` has normals of translucent surfaces
  uint firstRow;     // of the band
  uint rows;
};

#include "lib/environment_seen.glsl"
#include "lib/exitance_met.glsl"
#include "lib/neighbours.glsl"
#include "lib/through_bodies.glsl"

uint firstPieceOf(uint object) {
  return objects[object].table.y * piecesPerSurfel;
}

// Of the light behind, less than this is not seen. It fades in over as much again.
const float leastSeen = 0.002;

// A line of sight on its way.
struct Sightline {
  vec3 origin;
  vec3 direction;  // unit
  float least;     // what is nearer than this is behind it, mm
  uint inside;     // the object that it is in, or everyObject
  uint depth;      // how many parts of that body it is in, one within the other
  vec3 share;      // of the light there that is seen
};

// What a line of sight meets.
struct Surface {
  uint object;
  uint cluster;
  vec3 side;    // unit, at right angles to the facet, outwards
  vec3 normal;  // unit, interpolated
};

vec3 weightsIn(mat3 corners, vec3 place) {
  vec3 across = cross(corners[1] - corners[0], corners[2] - corners[0]);
  vec3 weights;
  for (int i = 0; i < 3; ++i)
    weights[i] = max(dot(cross(corners[(i + 1) % 3] - place, corners[(i + 2) % 3] - place), across), 0.0);
  return weights / max(weights.x + weights.y + weights.z, 1e-30);
}

// Facets would break up what is seen into as many pictures.
Surface surfaceMet(uint met, vec3 place) {
  uint cluster = clusterOfSurfel[met / piecesPerSurfel];
  vec3 side = windingOf(cluster) * facetNormal(met);
  SurfelPiece piece = pieceAt(met);
  uvec3 vertices = uvec3(piece.a, piece.b, piece.c);
  mat3 corners = mat3(positionOf(vertices.x), positionOf(vertices.y), positionOf(vertices.z));
  vec3 normal = normalOn(vertices, weightsIn(corners, place));
  return Surface(objectOfPiece(met), cluster, side, dot(normal, side) < 0.0 ? -normal : normal);
}

RayTarget everything() {
  return RayTarget(0u, nodeCount, everyObject);
}

float extinctionOf(uint object) {
  return leastOf(insideOf(objects[object]).collision.rgb);
}

// What the paint of a cluster of that object lets through.
vec3 throughPaintOf(uint cluster, uint object, float cosine) {
  return throughPaint(cluster, insideOf(objects[object]), cosine);
}

vec3 skyAlong(vec3 direction) {
  return environmentFrom(direction, levelOfEnvironment(angleOfPixel(textureSize(seenWords, 0).y)));
}

// Refracts it at a surface with that unit normal on the side that it comes from. False where all is mirrored.
bool refractAt(vec3 normal, float overEta, inout Sightline its) {
  vec3 refracted = refract(its.direction, normal, overEta);
  bool refracts = dot(refracted, refracted) > 0.25;
  its.direction = normalize(refracts ? refracted : reflect(its.direction, normal));
  return refracts;
}

// Goes on behind a place at that distance.
void moveTo(float distance, inout Sightline its) {
  its.origin += distance * its.direction;
  its.least = startAbove(its.origin);
}

void passBy(float distance, inout Sightline its) {
  its.least = distance + startAbove(its.origin + distance * its.direction);
}

float etaOf(uint object, vec3 place) {
  return mediumAt(objects[object], place).boundary.x;
}

// Where a body stands on an opaque one, either surface may be met first, at this many starts of rays from the other.
const float mostBetweenTouching = 20.0;

// A short piece of a line of sight around a place.
struct Probe {
  vec3 origin;
  vec3 direction;
  float reach;
};

Probe probeAround(vec3 place, vec3 direction) {
  float aside = mostBetweenTouching * startAbove(place);
  return Probe(place - aside * direction, direction, 2.0 * aside);
}

// An opaque piece in it, or noPiece.
uint opaquePieceIn(Probe probe, ObjectData body) {
  RayTarget own = RayTarget(body.tree.x, body.tree.w, body.body.x);
  uint piece = nearestHitOfOthers(probe.origin, probe.direction, 0.0, probe.reach, own, nodeCount).piece;
  return piece != noPiece && isOpaque(objects[objectOfPiece(piece)]) ? piece : noPiece;
}

// A piece of the body itself, without linings.
uint pieceOfBodyIn(Probe probe, ObjectData body) {
  RayTarget own = RayTarget(body.tree.x, body.tree.y, body.body.x);
  return nearestHit(probe.origin, probe.direction, 0.0, probe.reach, own).piece;
}

bool isOpaqueOrLining(uint piece) {
  return isOpaque(objects[objectOfPiece(piece)]) || ranges[clusterOfSurfel[piece / piecesPerSurfel]].kind == lining;
}

// Inside of a body: leaves it, or is mirrored as a whole. Adds the light of an opaque surface that lies within or touches
// the body where it leaves. False if it ends there.
bool goThroughBody(RayHit hit, inout Sightline its, inout vec3 seen) {
  vec3 direction = its.direction;
  vec3 place = its.origin + hit.distance * direction;
  Probe probe = probeAround(place, direction);
  uint opaque = isOpaqueOrLining(hit.piece) ? hit.piece : noPiece;
  uint piece = opaque != noPiece ? pieceOfBodyIn(probe, objects[its.inside]) : hit.piece;
  bool isWithin = piece == noPiece;
  Surface met = surfaceMet(isWithin ? hit.piece : piece, place);
  bool ofBody = objects[met.object].body.x == objects[its.inside].body.x;
  float cosine = dot(met.side, direction);
  bool leaves = cosine > 0.0;
  if (opaque == noPiece && (!ofBody || !leaves || its.depth > 1u)) {  // no boundary of the body
    if (ofBody) its.depth = leaves ? its.depth - 1u : its.depth + 1u;
    passBy(hit.distance, its);
    return true;
  }
  // Of a body of several media it goes through the two at its ends, half of the way each.
  uint atEnd = isWithin ? its.inside : met.object;
  vec3 ofBoth = insideOf(objects[its.inside]).collision.rgb + insideOf(objects[atEnd]).collision.rgb;
  its.share *= exp(-0.5 * hit.distance * ofBoth);
  moveTo(hit.distance, its);
  if (!isWithin) {
    if (withPaint != 0u) its.share *= throughPaintOf(met.cluster, met.object, cosine);
    float eta = etaOf(met.object, place);
    if (!refractAt(-met.normal, eta, its)) {
      if (withPaint != 0u) its.share *= throughPaintOf(met.cluster, met.object, cosine);
      return true;
    }
    its.share *= 1.0 - fresnelReflectance(eta, clamp(dot(met.normal, its.direction), 0.0, 1.0));
    if (opaque == noPiece) opaque = opaquePieceIn(probe, objects[its.inside]);
    its.inside = everyObject;
  }
  if (opaque == noPiece) return true;
  seen += its.share * exitanceMet(place, opaque, direction, true) / pi;
  return false;
}

// What a surface sends along a line of sight. One of a medium is taken to mirror as much as comes from inside. An open
// body sends what a half-space does, as where it is seen itself.
vec3 radianceOfMet(Surface met, uint piece, Sightline its) {
  vec3 exitance = ranges[met.cluster].kind == openBody ? means[met.cluster].rgb
                                                       : exitanceMet(its.origin, piece, its.direction, true);
  ObjectData body = objects[met.object];
  return exitance * (isOpaque(body) ? 1.0 / pi : mediumAt(body, its.origin).boundary.y);
}

// Outside: adds the light of what it meets. False if it ends there.
bool goToBody(RayHit hit, inout Sightline its, inout vec3 seen) {
  Surface met = surfaceMet(hit.piece, its.origin + hit.distance * its.direction);
  bool hasInside = ranges[met.cluster].kind == bodyWithInside;
  if (hasInside && dot(met.side, its.direction) >= 0.0) {  // an edge of the surface that it has left
    passBy(hit.distance, its);
    return true;
  }
  moveTo(hit.distance, its);
  seen += its.share * radianceOfMet(met, hit.piece, its);
  if (!hasInside) return false;
  float eta = etaOf(met.object, its.origin);
  its.share *= 1.0 - fresnelReflectance(eta, clamp(-dot(met.normal, its.direction), 0.0, 1.0));
  refractAt(dot(met.normal, its.direction) < 0.0 ? met.normal : met.side, 1.0 / eta, its);
  its.inside = met.object;
  its.depth = 1u;
  if (withPaint != 0u) its.share *= throughPaintOf(met.cluster, met.object, -dot(met.side, its.direction));
  return true;
}

// The light along a line of sight that has just entered a body.
vec3 seenAlong(Sightline its) {
  vec3 seen = vec3(0.0);
  for (uint surfaces = 0u; surfaces < mostSurfacesOfWay; ++surfaces) {
    bool within = its.inside != everyObject;
    float largest = largestOf(its.share);
    if (largest <= leastSeen) break;
    float reach = within ? log(largest / leastSeen) / extinctionOf(its.inside) : 3e38;
    RayHit hit = nearestHit(its.origin, its.direction, its.least, reach, everything());
    if (within) {
      if (hit.piece == noPiece || !goThroughBody(hit, its, seen)) break;
      if (its.inside == everyObject) its.share *= smoothstep(leastSeen, 2.0 * leastSeen, largestOf(its.share));
      continue;
    }
    vec3 ofLight;
    float distance = distanceToLights(its.origin, its.direction, false, ofLight);
    if (hit.piece == noPiece || distance < hit.distance) {
      seen += its.share * (isinf(distance) ? skyAlong(its.direction) : ofLight);
      break;
    }
    if (!goToBody(hit, its, seen)) break;
  }
  return seen;
}

// What the paint of a surface that is seen itself lets through.
vec3 throughOwnPaint(vec3 position, MeshPlace place, float cosine) {
  float start = startAbove(position);
  RayHit hit = nearestHit(position + 2.0 * start * place.facet, -place.facet, 0.0, 4.0 * start, everything());
  if (hit.piece == noPiece || objectOfPiece(hit.piece) != place.object) return vec3(1.0);
  return throughPaintOf(clusterOfSurfel[hit.piece / piecesPerSurfel], place.object, cosine);
}

// The normal by which a line of sight in that direction enters what a pixel sees: that of the surface, unless it is
// tilted too far.
vec3 enteringNormal(Seen seen, MeshPlace place, vec3 direction, float eta) {
  vec3 normal = ownSurfaces != 0u ? materials[seen.entry].normal.xyz : place.normal;
  bool enters = dot(normal, direction) < 0.0 && dot(refract(direction, normal, 1.0 / eta), place.facet) < 0.0;
  return enters ? normal : place.facet;
}

// From a place in the pixel.
vec3 seenFrom(vec2 placeInPixel, Seen seen, MeshPlace place) {
  vec3 weights = max(place.weights + weightsOver(seen, place) * placeInPixel, 0.0);  // not beyond the triangle
  mat3 corners =
      mat3(positionOf(place.vertices.x), positionOf(place.vertices.y), positionOf(place.vertices.z));
  vec3 position = corners * weights / (weights.x + weights.y + weights.z);
  vec3 towards = -normalize(toCameraFrom(position));
  Sightline its = Sightline(position, towards, startAbove(position), place.object, 1u, vec3(1.0));
  float eta = etaOf(place.object, position);
  refractAt(enteringNormal(seen, place, its.direction, eta), 1.0 / eta, its);
  float cosine = -dot(place.facet, its.direction);
  vec3 light = seenAlong(its);
  if (withPaint != 0u && light != vec3(0.0)) light *= throughOwnPaint(position, place, cosine);
  return light;
}

// Which object a pixel's first surface is of, as what stands beside the light that it has found.
float markOf(MeshPlace place) {
  return float(1u + place.object);
}

bool isEntered(MeshPlace place) {
  return !isOpaque(objects[place.object]) && place.side > 0.0;
}

void lookFromGrid() {
  ivec2 pixel = 2 * pixelOfInvocation() + ivec2(0, firstRow);
  if (!isInBand(pixel)) return;
  Seen seen = Seen(true, entryOfPixel[indexOf(pixel)], pixel, seenWord(pixel, 0u));
  found[indexOf(pixel)] = vec4(0.0);
  if (samplesOf(seen.word) == 0u) return;
  MeshPlace place = seenPlace(pixel, seen.word);
  if (isEntered(place)) found[indexOf(pixel)] = vec4(seenFrom(vec2(0.0), seen, place), markOf(place));
}

// Pixels of the grid around one must not differ by more than this part of the brightest to be interpolated.
const float leastDifference = 0.06;

// Between the pixels of the grid around; w: 0 where they do not tell.
vec4 seenBetween(ivec2 pixel, float mark) {
  ivec2 low = ivec2(0, firstRow) + ((pixel - ivec2(0, firstRow)) & ~1);
  vec2 part = 0.5 * vec2(pixel - low);
  vec3 sum = vec3(0.0);
  vec3 least = vec3(3e38);
  vec3 most = vec3(0.0);
  for (uint i = 0u; i < 4u; ++i) {
    ivec2 corner = 2 * ivec2(i & 1u, i >> 1u);
    if (!isInBand(low + corner)) return vec4(0.0);
    vec4 its = found[indexOf(low + corner)];
    if (its.w != mark) return vec4(0.0);
    vec2 weights = mix(1.0 - part, part, greaterThan(corner, ivec2(0)));
    sum += weights.x * weights.y * its.rgb;
    least = min(least, its.rgb);
    most = max(most, its.rgb);
  }
  return vec4(sum, largestOf(most - least) <= leastDifference * largestOf(most) ? 1.0 : 0.0);
}

void lookFromList() {
  Seen seen = seenOfInvocation(first);
  if (!seen.there) return;
  MeshPlace place = seenPlace(seen.pixel, seen.word);
  if (isOpaque(objects[place.object])) return;
  vec4 between = seenBetween(seen.pixel, markOf(place));
  vec3 light = between.rgb;
  if (between.w == 0.0) {
    light = vec3(0.0);
    for (uint k = 0u; k < 4u && isEntered(place); ++k) light += 0.25 * seenFrom(placesInPixel[k], seen, place);
  }
  materials[seen.entry].behind = vec4(light, 0.0);
}

void main() {
  if (onGrid != 0u)
    lookFromGrid();
  else
    lookFromList();
}
