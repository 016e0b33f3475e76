// One invocation for each surface that pixels see. Needs what lib/seen_entry.glsl needs.
#ifndef OPALINE_LIB_SEEN_LIST
#define OPALINE_LIB_SEEN_LIST
#include "lib/linear.glsl"
#include "lib/seen_entry.glsl"

Seen seenOfInvocation(uint first) {
  return seenAt(first + linearIndex());
}

#endif
