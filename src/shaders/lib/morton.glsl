// Places of a square by their Morton numbers: those of each square of half the width follow each other.
#ifndef OPALINE_LIB_MORTON
#define OPALINE_LIB_MORTON

// For a square of up to 16×16 places.
uvec2 placeOfMorton(uint i) {
  uvec2 place = uvec2(0u);
  for (int bit = 0; bit < 4; ++bit)
    place |= uvec2(bitfieldExtract(i, 2 * bit, 1), bitfieldExtract(i, 2 * bit + 1, 1)) << bit;
  return place;
}

#endif
