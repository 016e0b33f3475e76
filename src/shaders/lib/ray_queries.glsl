// Rays by the device's own acceleration structure, whose bodies are the objects; a part of
// lib/rays.glsl.
#ifndef OPALINE_LIB_RAY_QUERIES
#define OPALINE_LIB_RAY_QUERIES
#extension GL_EXT_ray_query : require

layout(set = 0, binding = BINDING_RAYS) uniform accelerationStructureEXT rayHierarchy;

uint firstPieceOf(uint object);

// What a query has found.
#define FOUND_BY(query, maxDistance)                                                                          \
  (rayQueryGetIntersectionTypeEXT(query, true) == gl_RayQueryCommittedIntersectionNoneEXT                     \
       ? RayHit(maxDistance, noPiece)                                                                         \
       : RayHit(rayQueryGetIntersectionTEXT(query, true),                                                     \
                firstPieceOf(uint(rayQueryGetIntersectionInstanceCustomIndexEXT(query, true))) +              \
                    uint(rayQueryGetIntersectionPrimitiveIndexEXT(query, true))))

// Rays for one object meet bodies of its class. Where a class has several, triangles are not opaque
// (see gpu::AccelerationStructure), and each is asked whose it is.
RayHit meetPieces(vec3 origin, vec3 direction, float minDistance, float maxDistance,
                  RayTarget target, bool anyWillDo) {
  if (!(minDistance < maxDistance)) return RayHit(maxDistance, noPiece);  // a query needs this order
  bool one = target.object != everyObject;
  uint flags = (one ? gl_RayFlagsNoneEXT : gl_RayFlagsOpaqueEXT) |
               (anyWillDo ? gl_RayFlagsTerminateOnFirstHitEXT : gl_RayFlagsNoneEXT);
  uint mask = one ? 1u << target.object % 8u : 0xffu;
  rayQueryEXT query;
  rayQueryInitializeEXT(query, rayHierarchy, flags, mask, origin, minDistance, direction,
                        maxDistance);
  while (rayQueryProceedEXT(query)) {
    if (rayQueryGetIntersectionInstanceCustomIndexEXT(query, false) == int(target.object))
      rayQueryConfirmIntersectionEXT(query);
  }
  return FOUND_BY(query, maxDistance);
}

RayHit nearestHitOfOthers(vec3 origin, vec3 direction, float minDistance, float maxDistance, RayTarget body,
                          uint nodeCount) {
  if (!(minDistance < maxDistance)) return RayHit(maxDistance, noPiece);
  rayQueryEXT query;
  rayQueryInitializeEXT(query, rayHierarchy, gl_RayFlagsNoOpaqueEXT, 0xffu, origin, minDistance, direction,
                        maxDistance);
  while (rayQueryProceedEXT(query)) {
    if (rayQueryGetIntersectionInstanceCustomIndexEXT(query, false) != int(body.object))
      rayQueryConfirmIntersectionEXT(query);
  }
  return FOUND_BY(query, maxDistance);
}

#endif
