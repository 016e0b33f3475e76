// What neighbouring pixels of a band have found of their first surfaces. Needs, before it, lib/seen.glsl, and after
// that the band's first row and number of rows, as `firstRow` and `rows`.
#ifndef OPALINE_LIB_NEIGHBOURS
#define OPALINE_LIB_NEIGHBOURS

uint indexOf(ivec2 pixel) {
  return uint(pixel.y - int(firstRow)) * uint(textureSize(seenWords, 0).x) + uint(pixel.x);
}

ivec2 endOfBand() {
  return ivec2(textureSize(seenWords, 0).x, firstRow + rows);
}

bool isInBand(ivec2 pixel) {
  return all(greaterThanEqual(pixel, ivec2(0, firstRow))) && all(lessThan(pixel, endOfBand()));
}

// The first of so many pixels across around one, inside the band.
ivec2 windowAround(ivec2 pixel, int width) {
  return max(min(pixel - width / 2, endOfBand() - width), ivec2(0, firstRow));
}

ivec2 pixelOfWindow(ivec2 window, uint i, int width) {
  return window + ivec2(int(i) % width, int(i) / width);
}

// Pixels see one surface from this cosine of their normals on, and up to this sine of the angle by which the way
// between them leaves it.
const float leastCosine = 0.9;
const float mostOffPlane = 0.3;

bool isOneSurface(MeshPlace a, MeshPlace b) {
  vec3 between = b.position - a.position;
  return a.object == b.object && a.side == b.side && dot(a.normal, b.normal) >= leastCosine &&
         abs(dot(a.facet, between)) <= mostOffPlane * length(between);
}

#endif
