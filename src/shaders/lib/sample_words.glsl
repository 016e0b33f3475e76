// What scatter/nearest_triangles.comp.glsl leaves for every sample: the first triangle has the largest number, and 0 is
// none.
#ifndef OPALINE_LIB_SAMPLE_WORDS
#define OPALINE_LIB_SAMPLE_WORDS

uint placeOfSample(uvec2 pixel, uint which, uint width, uint samples) {
  return (pixel.y * width + pixel.x) * samples + which;
}

uint wordOfTriangle(uint triangle) {
  return ~triangle;
}

// Plus one, or 0 for none.
uint triangleOfWord(uint word) {
  return word == 0u ? 0u : ~word + 1u;
}

#endif
