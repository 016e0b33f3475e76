// As scatter/surface.frag.glsl, for surfaces with holes.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 5
#define BINDING_MEDIA 6
#define BINDING_OPAQUES 7
#define BINDING_TEXELS 10
#include "lib/cutout.glsl"

layout(location = 0) flat in uint object;
layout(location = 1) in vec4 coordinates;
layout(location = 2) in float alpha;
layout(location = 3) flat in uint triangle;

layout(location = 0) out uint seen;

void main() {
  if (isCutOut(object, coordinates, alpha)) discard;
  seen = triangle + 1u;
}
