// Antialiasing samples of pixels. Needs lib/frame.glsl.
#ifndef OPALINE_LIB_SAMPLES
#define OPALINE_LIB_SAMPLES
#include "shared/seen.h"

uint triangleOf(uint word) {
  return bitfieldExtract(word, 0, int(seenSamplesShift)) - 1u;
}

uint samplesOf(uint word) {
  return word >> seenSamplesShift;
}

// Clip space over w at a place of a picture, in pixels from the pixel's centre.
vec2 clipAt(ivec2 pixel, ivec2 size, vec2 place) {
  return 2.0 * (vec2(pixel) + 0.5 + place) / vec2(size) - 1.0;
}

// The middle of these samples. That of all is the pixel's centre.
vec2 middleOf(uint samples) {
  if (samples == everySample) return vec2(0.0);
  vec2 sum = vec2(0.0);
  for (uint rest = samples; rest != 0u; rest &= rest - 1u) sum += frame.samples[findLSB(rest)].xy;
  return sum / float(bitCount(samples));
}

float coverageOf(uint samples) {
  return samples == everySample ? 1.0 : float(bitCount(samples)) / float(frame.counts.z);
}

#endif
