// The paper's FTF: the near block of the pattern summed for every surface that pixels see, on top of what
// the far samples gave the vertices. One medium at a time.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_SEEN 1
#define BINDING_MESH_EXITANCES 2
#define BINDING_OBJECTS 4
#define BINDING_MEDIA 5
#define BINDING_PATTERN 6
#define BINDING_POSITION 7
#define BINDING_FLUX 8
#define MESH_BINDING 9
#define BINDING_CORNERS 13
#define BINDING_SEEN_LIST 16
#include "lib/frame.glsl"
#include "lib/seen_list.glsl"
#include "paper/shaders/lib/pattern_sum.glsl"
#include "paper/shaders/lib/place.glsl"

layout(push_constant) uniform Push {
  uint first;
  uint medium;
};

layout(std430, set = 0, binding = 3) writeonly buffer Exitances { vec4 exitances[]; };

void main() {
  Seen seen = seenOfInvocation(first);
  MeshPlace place = seenPlace(seen.pixel, seen.word);
  // Software devices go on after `return`, but not through a branch that none of a group takes.
  if (seen.there && objects[place.object].table.x == medium) {
    vec3 near = nearSum(place.position, media[medium], nearPlaceOn(triangleOf(seen.word), place.weights));
    exitances[seen.entry] = vec4(near, float(nearEvaluations())) + meshExitanceAt(place);
  }
}
