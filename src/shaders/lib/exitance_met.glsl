// Light that leaves bodies where rays meet them, by their clusters. Needs, before it, lib/bodies.glsl, lib/rays.glsl,
// lib/clusters_around.glsl and clusterOfSurfel, exitances, opaqueExitances and piecesPerSurfel.
#ifndef OPALINE_LIB_EXITANCE_MET
#define OPALINE_LIB_EXITANCE_MET

vec3 exitanceOf(uint cluster, bool opaque) {
  return opaque ? opaqueExitances[cluster].rgb : exitances[cluster].rgb;
}

// At a place of a body, by the clusters around, or else by its own.
vec3 exitanceAt(vec3 place, vec3 normal, ObjectData body, uint own) {
  bool opaque = isOpaque(body);
  vec3 sum = vec3(0.0);
  float all = 0.0;
  uint node = body.clusters.x;
  while (node < body.clusters.y) {
    uint i;
    float weight = weightOfNext(node, place, normal, i);
    if (weight <= 0.0) continue;
    sum += weight * exitanceOf(i, opaque);
    all += weight;
  }
  return all > 0.0 ? sum / all : exitanceOf(own, opaque);
}

// Where a ray in that direction meets a piece; `smoothly`: interpolated between clusters.
vec3 exitanceMet(vec3 place, uint piece, vec3 direction, bool smoothly) {
  uint cluster = clusterOfSurfel[piece / piecesPerSurfel];
  ObjectData body = objects[objectOfPiece(piece)];
  vec3 facet = facetNormal(piece);
  if (hasBack(body) && clusters[cluster].along.w * dot(facet, direction) > 0.0) cluster = backOf(cluster, body);
  if (!smoothly || body.clusters.z == 0u) return exitanceOf(cluster, isOpaque(body));
  vec3 normal = dot(facet, direction) > 0.0 ? -facet : facet;
  return exitanceAt(place, normal, body, cluster);
}

#endif
