// Light that goes through bodies in its way without being scattered. Needs, before it, lib/boundary.glsl,
// lib/fresnel.glsl, lib/rays.glsl, BINDING_CLUSTER_PAINTS, withPaint, piecesPerSurfel, and the buffers ranges, clusters
// and clusterOfSurfel.
#ifndef OPALINE_LIB_THROUGH_BODIES
#define OPALINE_LIB_THROUGH_BODIES
#include "lib/paint.glsl"

// Two for each wall, and some that are met twice.
const uint mostSurfaces = 8u;

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

// Light on its way through bodies.
struct Crossing {
  vec3 through;  // what is left
  uint inside;   // the object that it is in, or everyObject
  float from;    // where it entered that
  float longer;  // the refracted way there over the straight one
  float reach;   // where nothing is left of it
};

// Goes into a cluster's object, or out of it, where the surface has that cosine.
void goThrough(uint cluster, float distance, float cosine, vec3 place, float furthest, inout Crossing its) {
  uint object = ranges[cluster].object;
  BoundaryMedium medium = insideOf(objects[object]);
  float eta = mediumAt(objects[object], place).boundary.x;
  float inside = cosineInside(eta, cosine);
  float longer = cosine / inside;
  bool enters = its.inside == everyObject;
  its.through *= 1.0 - fresnelReflectance(eta, cosine);
  if (withPaint != 0u) its.through *= throughPaint(cluster, medium, inside);
  if (!enters) its.through *= exp(-0.5 * (its.longer + longer) * (distance - its.from) * medium.collision.rgb);
  float left = max(log(largestOf(its.through) / leastThrough), 0.0);
  its.reach = enters ? min(furthest, distance + left / (leastOf(medium.collision.rgb) * max(longer, 0.1))) : furthest;
  its.inside = enters ? object : everyObject;
  its.from = distance;
  its.longer = longer;
}

// Light that refracts into a wall and out of its other side goes on in the direction from which it came, if the sides
// are parallel. So it is followed straight on, and its way within is as much longer than the wall is thick as that of
// a refracted ray. `origin` is outside of all bodies, and `hit` what the light meets first.
vec3 throughBodies(vec3 origin, vec3 direction, RayHit hit, float least, float furthest, RayTarget scene) {
  if (!isThinAt(hit)) return vec3(0.0);
  Crossing its = Crossing(vec3(1.0), everyObject, 0.0, 0.0, furthest);
  for (uint k = 0u; k < mostSurfaces && hit.piece != noPiece; ++k) {
    uint object = objectOfPiece(hit.piece);
    uint cluster = clusterOfSurfel[hit.piece / piecesPerSurfel];
    float outwards = clusters[cluster].along.w * dot(facetNormal(hit.piece), direction);
    bool isOutside = its.inside == everyObject;
    bool blocks = ranges[cluster].kind != bodyWithInside || (isOutside ? k == 0u && outwards >= 0.0 : object != its.inside);
    if (blocks || largestOf(its.through) < leastThrough) return vec3(0.0);
    // Else it is the neighbour of a piece whose edge the ray has passed.
    if (isOutside == outwards < 0.0)
      goThrough(cluster, hit.distance, min(abs(outwards), 1.0), origin + hit.distance * direction, furthest, its);
    hit = nearestHit(origin, direction, hit.distance + least, its.reach, scene);
  }
  return hit.piece == noPiece && its.inside == everyObject ? its.through : vec3(0.0);
}

#endif
