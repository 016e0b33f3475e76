// Where rays leave a surface that pixels see. Needs, before it, lib/frame.glsl and lib/rays.glsl.
#ifndef OPALINE_LIB_RAY_START
#define OPALINE_LIB_RAY_START
#include "lib/mesh.glsl"

struct RayStart {
  vec3 origin;
  float least;  // mm; what is nearer is the surface itself
};

RayStart rayStartOn(MeshPlace place) {
  float least = startAbove(place.inside);
  return RayStart(place.inside + least * place.facet, least);
}

#endif
