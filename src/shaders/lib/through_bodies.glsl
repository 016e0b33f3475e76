// Light that goes through bodies in its way without being scattered. Needs, before it, lib/boundary.glsl,
// lib/fresnel.glsl, lib/rays.glsl, BINDING_CLUSTER_PAINTS, withPaint, piecesPerSurfel, and the buffers ranges, clusters
// and clusterOfSurfel; CLUSTERS_ARE_TEXELS where clusters are read as such.
#ifndef OPALINE_LIB_THROUGH_BODIES
#define OPALINE_LIB_THROUGH_BODIES
#include "lib/paint.glsl"

// A light of which less is hidden is not looked for behind bodies.
const float leastHidden = 0.02;

// See Cluster::along.
float windingOf(uint cluster) {
#ifdef CLUSTERS_ARE_TEXELS
  return texelOf(clusters, texelOfCluster(cluster, 4u)).w;
#else
  return clusters[cluster].along.w;
#endif
}

// Whether a ray meets a body where it was thin enough at rest that some light gets through.
bool isThinAt(RayHit hit) {
  if (hit.piece == noPiece) return false;
  ClusterRange range = ranges[clusterOfSurfel[hit.piece / piecesPerSurfel]];
  return range.kind == bodyWithInside &&
         letsThrough(range.thickness, leastOf(insideOf(objects[range.object]).collision.rgb));
}

// What a cluster's paint lets through, for a beam with that cosine inside.
vec3 throughPaint(uint cluster, BoundaryMedium medium, float cosine) {
  return throughLayer(clusterPaints[cluster].entering.rgb, medium.sigma.w, cosine);
}

// Light on its way through bodies, from a place outside of them all.
struct Crossing {
  RayHit hit;      // what it meets next
  uint surfaces;   // that it has met before
  vec3 through;    // what is left
  uint inside;     // the object that it is in, or everyObject
  float from;      // where it entered that
  float longer;    // the refracted way there over the straight one
  float reach;     // where nothing is left of it
  vec3 side;       // outwards, where it entered that
  float parallel;  // 1 where it has gone through parallel sides alone
};

Crossing crossingFrom(RayHit hit, float furthest) {
  return Crossing(hit, 0u, vec3(1.0), everyObject, 0.0, 0.0, furthest, vec3(0.0), 1.0);
}

bool isOutside(Crossing its) {
  return its.inside == everyObject;
}

// Whether nothing is left in its way.
bool isThrough(Crossing its) {
  return its.hit.piece == noPiece && isOutside(its);
}

// Goes into a cluster's object, or out of it, where the surface has that unit normal outwards.
void goThrough(uint cluster, float distance, vec3 side, vec3 direction, vec3 place, float furthest, inout Crossing its) {
  uint object = ranges[cluster].object;
  BoundaryMedium medium = insideOf(objects[object]);
  float eta = mediumAt(objects[object], place).boundary.x;
  float cosine = min(abs(dot(side, direction)), 1.0);
  float inside = cosineInside(eta, cosine);
  float longer = cosine / inside;
  bool enters = isOutside(its);
  its.through *= 1.0 - fresnelReflectance(eta, cosine);
  if (withPaint != 0u) its.through *= throughPaint(cluster, medium, inside);
  if (!enters) its.through *= exp(-0.5 * (its.longer + longer) * (distance - its.from) * medium.collision.rgb);
  float left = max(log(largestOf(its.through) / leastThrough), 0.0);
  its.reach = enters ? min(furthest, distance + left / (leastOf(medium.collision.rgb) * max(longer, 0.1))) : furthest;
  its.inside = enters ? object : everyObject;
  if (!enters) its.parallel *= max(-dot(its.side, side), 0.0);
  its.side = side;
  its.from = distance;
  its.longer = longer;
}

// Goes through the surface that is met next. False if that ends the way.
bool passesSurface(vec3 origin, vec3 direction, float least, float furthest, RayTarget scene, inout Crossing its) {
  uint object = objectOfPiece(its.hit.piece);
  uint cluster = clusterOfSurfel[its.hit.piece / piecesPerSurfel];
  vec3 side = windingOf(cluster) * facetNormal(its.hit.piece);
  float outwards = dot(side, direction);
  bool startsInside = its.surfaces == 0u && outwards >= 0.0;
  if (++its.surfaces > mostSurfacesOfWay || largestOf(its.through) < leastThrough) return false;
  if (ranges[cluster].kind != bodyWithInside || (isOutside(its) ? startsInside : object != its.inside)) return false;
  // Else it is the neighbour of a piece whose edge the ray has passed.
  if (isOutside(its) == outwards < 0.0)
    goThrough(cluster, its.hit.distance, side, direction, origin + its.hit.distance * direction, furthest, its);
  its.hit = nearestHit(origin, direction, its.hit.distance + least, its.reach, scene);
  return true;
}

// Light that refracts into a wall and out of its other side goes on in the direction from which it came, if the sides
// are parallel. So it is followed straight on, and its way within is as much longer than the wall is thick as that of
// a refracted ray. `origin` is outside of all bodies, and `hit` what the light meets first. w is Crossing::parallel.
vec4 throughBodies(vec3 origin, vec3 direction, RayHit hit, float least, float furthest, RayTarget scene) {
  Crossing its = crossingFrom(hit, furthest);
  while (its.hit.piece != noPiece && passesSurface(origin, direction, least, furthest, scene, its)) {
  }
  return isThrough(its) ? vec4(its.through, its.parallel) : vec4(vec3(0.0), 1.0);
}

#endif
