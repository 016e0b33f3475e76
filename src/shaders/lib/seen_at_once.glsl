// What scatter/seen.comp.glsl does, for samples that were drawn at once. The first word without a surface ends those of
// a pixel. Needs, before it, `words`, `samples`, `firstRow`, lib/mixed.glsl, lib/tile.glsl, and the triangles that a
// pixel's samples see, plus one:
//   uint drawnAt(ivec2 pixel, uint which)
#ifndef OPALINE_LIB_SEEN_AT_ONCE
#define OPALINE_LIB_SEEN_AT_ONCE

void putSeen(ivec2 size) {
  ivec2 pixel = pixelOfInvocation() + ivec2(0, firstRow);
  bool inside = all(lessThan(pixel, size));
  ivec2 within = min(pixel, size - 1);
  uint triangle = drawnAt(within, 0u);
  bool several = false;
  for (uint i = 1u; i < samples; ++i) several = several || drawnAt(within, i) != triangle;
  several = several && inside;
  uint word = !several && triangle != 0u ? triangle | everySample << seenSamplesShift : triangle;
  if (inside) imageStore(words, ivec3(pixel, 0), uvec4(word));
  if (inside && samples > 1u) imageStore(words, ivec3(pixel, 1), uvec4(several ? drawnAt(within, 1u) : 0u));
  for (uint i = 2u; several && i < samples; ++i) imageStore(words, ivec3(pixel, i), uvec4(drawnAt(within, i)));
  listMixed(several, uint(pixel.y * size.x + pixel.x));
}

#endif
