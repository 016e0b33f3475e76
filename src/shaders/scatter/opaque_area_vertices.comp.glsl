// Irradiance of area lights at the vertices of opaque bodies, with soft shadows.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 3
#define BINDING_MEDIA 4
#define BINDING_PIECE_CORNERS 5
#define BINDING_RAYS 6
#define BINDING_CLUSTER_PAINTS 9
#define THROUGH_BINDING 10
#include "lib/frame.glsl"
#include "lib/area_shadow.glsl"
#include "lib/linear.glsl"
#include "lib/material.glsl"
#include "lib/vertex_side.glsl"

layout(std430, set = 0, binding = 1) readonly buffer Positions { vec4 positions[]; };
layout(std430, set = 0, binding = 2) readonly buffer Normals { vec4 normals[]; };
layout(std430, set = 0, binding = 7) readonly buffer ObjectOf { uint objectOf[]; };
layout(std430, set = 0, binding = 8) buffer Irradiances { vec4 irradiances[]; };

layout(push_constant) uniform Push {
  uint vertexCount;
  uint sides;  // of bodies with a back
  uint site;
  uint nodeCount;  // of all surfels' trees
  uint piecesPerSurfel;
};

const uint raysOfVertex = 16u;

#include "lib/area_light_through.glsl"

void main() {
  uint at = linearIndex();
  if (at >= sides * vertexCount) return;
  VertexSide side = vertexSideOf(at, vertexCount);
  ObjectData body = objects[objectOf[side.vertex]];
  if (!isOpaque(body) || isSummedAtFragments(body, site) || !hasSide(body, side)) return;
  vec3 normal = outwardsOf(side, normals[side.vertex].xyz);
  Receiver receiver = Receiver(positions[side.vertex].xyz, normal, normal, 1.0);
  MediumData medium = mediumAt(body, receiver.position);
  vec3 sum = vec3(0.0);
  for (uint i = firstAreaLight(); i < allLightsAt(receiver.position); ++i) {
    AreaView view = areaViewFrom(receiver.position, i);
    if (!view.shines) continue;
    Share share = Share(0.0, 0.0);
    for (uint k = 0u; k < raysOfVertex; ++k) sendRay(view, receiver, netPlace(k), nodeCount, share);
    if (share.all > 0.0)
      sum += arrivingPartOfArea(share.visible / share.all, view, receiver) * enteringOfView(view, normal, medium) *
             frame.lights[i].power.rgb;
  }
  irradiances[at].rgb += sum;
}
