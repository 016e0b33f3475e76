// Where the light that leaves a body with an inside comes from. x to z: how much of it has entered there, at most 1;
// the rest comes through the body. w: 1 over the thickness of the body, 1/mm, below 0 where there is no inside.
#ifndef OPALINE_LIB_ORIGIN
#define OPALINE_LIB_ORIGIN

const vec4 unknownOrigin = vec4(0.0, 0.0, 0.0, -1.0);

bool isKnown(vec4 origin) {
  return origin.w >= 0.0;
}

#endif
