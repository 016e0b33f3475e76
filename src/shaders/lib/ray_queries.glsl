// Rays by the device's own acceleration structure, whose bodies are the objects; a part of
// lib/rays.glsl.
#ifndef OPALINE_LIB_RAY_QUERIES
#define OPALINE_LIB_RAY_QUERIES
#extension GL_EXT_ray_query : require

layout(set = 0, binding = BINDING_RAYS) uniform accelerationStructureEXT rayHierarchy;

uint firstPieceOf(uint object);

// Which bodies a ray may meet.
const uint everyBody = 0u;
const uint oneBody = 1u;
const uint otherBodies = 2u;

// Rays for one object meet bodies of its class. Where a class has several, triangles are not opaque
// (see gpu::AccelerationStructure), and each is asked whose it is.
RayHit meetBodies(vec3 origin, vec3 direction, float minDistance, float maxDistance, uint which, uint object,
                  bool anyWillDo) {
  if (!(minDistance < maxDistance)) return RayHit(maxDistance, noPiece);  // a query needs this order
  uint flags = (which == everyBody ? gl_RayFlagsOpaqueEXT
              : which == oneBody   ? gl_RayFlagsNoneEXT
                                   : gl_RayFlagsNoOpaqueEXT) |
               (anyWillDo ? gl_RayFlagsTerminateOnFirstHitEXT : gl_RayFlagsNoneEXT);
  uint mask = which == oneBody ? 1u << object % 8u : 0xffu;
  rayQueryEXT query;
  rayQueryInitializeEXT(query, rayHierarchy, flags, mask, origin, minDistance, direction,
                        maxDistance);
  while (rayQueryProceedEXT(query)) {
    bool isIts = rayQueryGetIntersectionInstanceCustomIndexEXT(query, false) == int(object);
    if (isIts == (which == oneBody)) rayQueryConfirmIntersectionEXT(query);
  }
  if (rayQueryGetIntersectionTypeEXT(query, true) == gl_RayQueryCommittedIntersectionNoneEXT)
    return RayHit(maxDistance, noPiece);
  uint met = uint(rayQueryGetIntersectionInstanceCustomIndexEXT(query, true));
  uint piece = firstPieceOf(met) + uint(rayQueryGetIntersectionPrimitiveIndexEXT(query, true));
  return RayHit(rayQueryGetIntersectionTEXT(query, true), piece);
}

RayHit meetPieces(vec3 origin, vec3 direction, float minDistance, float maxDistance,
                  RayTarget target, bool anyWillDo) {
  uint which = target.object == everyObject ? everyBody : oneBody;
  return meetBodies(origin, direction, minDistance, maxDistance, which, target.object, anyWillDo);
}

RayHit nearestHitOfOthers(vec3 origin, vec3 direction, float minDistance, float maxDistance, RayTarget body,
                          uint nodeCount) {
  return meetBodies(origin, direction, minDistance, maxDistance, otherBodies, body.object, false);
}

#endif
