// The list of the surfaces that pixels see. Needs, before it, BINDING_SEEN_LIST, the first of two
// bindings, and what lib/seen.glsl needs.
#ifndef OPALINE_LIB_SEEN_ENTRY
#define OPALINE_LIB_SEEN_ENTRY
#include "lib/seen.glsl"

layout(std430, set = 0, binding = BINDING_SEEN_LIST) readonly buffer SeenList { uint seenList[]; };
layout(std140, set = 0, binding = BINDING_SEEN_LIST + 1) uniform SeenCounts { SeenCount seenCount; };

struct Seen {
  bool there;  // false: no surface, and the rest belongs to another
  uint entry;  // index in the list, and in what is kept for each surface
  ivec2 pixel;
  uint word;
};

ivec2 pixelOf(uint listed) {
  int index = int(bitfieldExtract(listed, 0, int(seenLayerShift)));
  int width = textureSize(seenWords, 0).x;
  return ivec2(index % width, index / width);
}

Seen seenOfEntry(uint entry) {
  uint listed = seenList[entry];
  ivec2 pixel = pixelOf(listed);
  return Seen(true, entry, pixel, seenWord(pixel, listed >> seenLayerShift));
}

// The i-th of the list, if it has that many.
Seen seenAt(uint i) {
  bool there = i < seenCount.groupsEntries.w && seenList[i] != noSurface;
  Seen seen = seenOfEntry(there ? i : 0u);
  seen.there = there;
  return seen;
}

// Whether it is the first surface that its pixel sees.
bool isFirstSurface(Seen seen) {
  return seenList[seen.entry] >> seenLayerShift == 0u;
}

#endif
