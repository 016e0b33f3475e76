// One invocation for each surface on a list of some of those that pixels see. Needs, before it, BINDING_ASKED, the first of
// two bindings, and what lib/seen_list.glsl needs.
#ifndef OPALINE_LIB_ASKED_LIST
#define OPALINE_LIB_ASKED_LIST
#include "lib/seen_list.glsl"

layout(std430, set = 0, binding = BINDING_ASKED) readonly buffer Asked { uint asked[]; };  // indices into the list of
                                                                                           // all
layout(std140, set = 0, binding = BINDING_ASKED + 1) uniform AskedCounts { SeenCount askedCount; };

Seen askedOfInvocation(uint first) {
  uint i = first + linearIndex();
  bool there = i < askedCount.groupsEntries.w && asked[i] != noSurface;
  Seen seen = seenOfEntry(there ? asked[i] : 0u);
  seen.there = there;
  return seen;
}

#endif
