// The body that a beam is in, and where its rays meet the surface from inside. Needs, before it, withLinings,
// piecesPerSurfel, the buffers ranges, clusterOfSurfel and opaqueShares, and lib/rays.glsl.
#ifndef OPALINE_LIB_BEAM_BODY
#define OPALINE_LIB_BEAM_BODY
#include "lib/boundary.glsl"
#include "lib/fresnel.glsl"

struct Body {
  BoundaryMedium medium;
  float eta;
  RayTarget target;
  float side;   // -1 where it is mirrored
  float least;  // distance from the surface at which rays start, mm
};

// The body below a cluster where light enters.
Body bodyAt(Cluster cluster, ObjectData object, vec3 place) {
  return Body(insideOf(object), mediumAt(object, place).boundary.x,
              RayTarget(object.tree.x, object.tree.w, object.body.x), cluster.along.w, rayStartOf(cluster));
}

uint firstPieceOf(uint object) {
  return objects[object].table.y * piecesPerSurfel;
}

float reflectedInside(Body body, float cosine) {
  return fresnelReflectance(1.0 / body.eta, min(cosine, 1.0));
}

bool isLining(uint piece) {
  return withLinings != 0u && ranges[clusterOfSurfel[piece / piecesPerSurfel]].kind == lining;
}

vec3 givenBackBy(uint piece) {
  return min(opaqueShares[clusterOfSurfel[piece / piecesPerSurfel]].share.rgb, vec3(1.0));
}

RayHit nextHit(Body body, vec3 origin, vec3 direction, float furthest) {
  return nearestExit(origin, direction, body.side, body.least, furthest, body.target);
}

// For diffusion, light that scatters forwards is a source this much further on, mm. It is less in front
// of a surface `leftMm` away, since fewer free paths end before it.
vec3 forwards(Body body, vec3 leftMm) {
  if (body.medium.collision.w == 0.0) return vec3(0.0);
  vec3 whole = body.medium.collision.w / body.medium.extinction.rgb;
  return whole * (1.0 - exp(-leftMm / abs(whole)));
}

#endif
