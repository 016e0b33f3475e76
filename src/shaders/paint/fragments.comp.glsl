// What leaves through the paint of surfaces that pixels see, M = λ·B - τ·E. B is the exitance as if
// there were no layer to leave through, E what has entered the diffusion at the surface. Also what of
// it goes towards the camera, over what does without paint.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_SEEN 1
#define BINDING_OBJECTS 3
#define BINDING_MEDIA 4
#define MESH_BINDING 5
#define BINDING_SEEN_LIST 9
#define BINDING_OPAQUES 11
#define BINDING_TEXELS 14
#define BINDING_PAINT_TABLES 15
#include "lib/frame.glsl"
#include "lib/material.glsl"
#include "lib/paint.glsl"
#include "lib/paint_table.glsl"
#include "lib/seen_material.glsl"

layout(std430, set = 0, binding = 2) buffer Exitances { vec4 exitances[]; };
layout(std430, set = 0, binding = 16) buffer Paint { vec4 paint[]; };

layout(push_constant) uniform Push {
  uint first;
  uint carried;  // 1: light has entered the diffusion at the surface, and `paint` holds it
};

void main() {
  Seen seen = seenOfInvocation(first);
  if (!seen.there) return;
  MeshPlace place = seenPlace(seen.pixel, seen.word);
  MediumData medium = mediumAt(objects[place.object], place.position);
  vec3 entered = carried != 0u ? paint[seen.entry].rgb : vec3(0.0);
  paint[seen.entry] = vec4(1.0);
  if (!isPainted(medium)) return;
  OpaqueData material = opaques[medium.tables.y];
  PaintEntry found = paintOf(medium, baseColorAt(material, materialPlaceSeen(seen, place, material)).rgb);
  vec3 left = leavesLayer(exitances[seen.entry].rgb, entered, found.leaving.rgb, found.deep.rgb, found.takenOff.rgb,
                          found.source.rgb / max(found.layer.rgb, vec3(1e-6)));
  exitances[seen.entry].rgb = max(left, vec3(0.0));
  float eta = medium.boundary.x;
  float outside = dot(place.normal, normalize(toCameraFrom(place.position)));
  float cosine = sqrt(1.0 - (1.0 - outside * outside) / (eta * eta));
  paint[seen.entry].rgb = exp(-found.thickness.rgb / cosine) / max(found.entering.rgb, vec3(1e-6));
}
