// How pixels lie on the surfaces that they see. Needs lib/seen_list.glsl.
#ifndef OPALINE_LIB_FOOTPRINT
#define OPALINE_LIB_FOOTPRINT

// How far weights may change over a pixel where a triangle is seen edge on.
const float furthestOverPixel = 64.0;

// Weights of the triangle's corners over the pixel's width and over its height.
mat2x3 weightsOver(Seen seen, MeshPlace place) {
  vec2 middle = middleOf(samplesOf(seen.word));
  mat2x3 over;
  for (int i = 0; i < 2; ++i) {
    vec2 aside = i == 0 ? vec2(0.5, 0.0) : vec2(0.0, 0.5);
    over[i] = clamp(weightsOn(place.vertices, seenClip(seen.pixel, middle + aside)) -
                        weightsOn(place.vertices, seenClip(seen.pixel, middle - aside)),
                    -furthestOverPixel, furthestOverPixel);
  }
  return over;
}

// The same as lengths on the surface, mm.
mat2x3 lengthsOver(Seen seen, MeshPlace place) {
  return mat3(positionOf(place.vertices.x), positionOf(place.vertices.y), positionOf(place.vertices.z)) *
         weightsOver(seen, place);
}

#endif
