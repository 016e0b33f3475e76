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

// Light on its way through bodies.
struct Crossing {
  vec3 through;  // what is left
  uint inside;   // the object that it is in, or everyObject
  float from;    // where it entered that
  float longer;  // the refracted way there over the straight one
  float reach;   // where nothing is left of it
  vec3 side;     // outwards, where it entered that
  float parallel;  // 1 where it has gone through parallel sides alone
};

// Goes into a cluster's object, or out of it, where the surface has that unit normal outwards.
void goThrough(uint cluster, float distance, vec3 side, vec3 direction, vec3 place, float furthest, inout Crossing its) {
  uint object = ranges[cluster].object;
  BoundaryMedium medium = insideOf(objects[object]);
  float eta = mediumAt(objects[object], place).boundary.x;
  float cosine = min(abs(dot(side, direction)), 1.0);
  float inside = cosineInside(eta, cosine);
  float longer = cosine / inside;
  bool enters = its.inside == everyObject;
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

// Light that refracts into a wall and out of its other side goes on in the direction from which it came, if the sides
// are parallel. So it is followed straight on, and its way within is as much longer than the wall is thick as that of
// a refracted ray. `origin` is outside of all bodies, and `hit` what the light meets first. w is Crossing::parallel.
vec4 throughBodies(vec3 origin, vec3 direction, RayHit hit, float least, float furthest, RayTarget scene) {
  const vec4 nothing = vec4(vec3(0.0), 1.0);
  Crossing its = Crossing(vec3(1.0), everyObject, 0.0, 0.0, furthest, vec3(0.0), 1.0);
  for (uint k = 0u; k < mostSurfacesOfWay && hit.piece != noPiece; ++k) {
    uint object = objectOfPiece(hit.piece);
    uint cluster = clusterOfSurfel[hit.piece / piecesPerSurfel];
    vec3 side = windingOf(cluster) * facetNormal(hit.piece);
    float outwards = dot(side, direction);
    bool isOutside = its.inside == everyObject;
    bool blocks = ranges[cluster].kind != bodyWithInside || (isOutside ? k == 0u && outwards >= 0.0 : object != its.inside);
    if (blocks || largestOf(its.through) < leastThrough) return nothing;
    // Else it is the neighbour of a piece whose edge the ray has passed.
    if (isOutside == outwards < 0.0)
      goThrough(cluster, hit.distance, side, direction, origin + hit.distance * direction, furthest, its);
    hit = nearestHit(origin, direction, hit.distance + least, its.reach, scene);
  }
  return hit.piece == noPiece && its.inside == everyObject ? vec4(its.through, its.parallel) : nothing;
}

#endif
