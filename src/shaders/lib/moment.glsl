// First moments of vector areas, Σ A ⊗ δ about a place. Six numbers are enough, because A ⊗ δ and δ
// ⊗ A give the same wherever they are used.
#ifndef OPALINE_LIB_MOMENT
#define OPALINE_LIB_MOMENT

struct Moment {
  vec4 first;  // xx yy zz xy
  vec2 rest;   // xz yz
};

Moment momentOfArea(vec3 vectorArea, vec3 offset) {
  return Moment(vec4(vectorArea * offset, 0.5 * (vectorArea.x * offset.y + vectorArea.y * offset.x)),
                0.5 * vec2(vectorArea.x * offset.z + vectorArea.z * offset.x,
                           vectorArea.y * offset.z + vectorArea.z * offset.y));
}

float traceOf(Moment moment) {
  return moment.first.x + moment.first.y + moment.first.z;
}

// oᵀ M o.
float alongTwice(Moment moment, vec3 offset) {
  vec3 o2 = offset * offset;
  return dot(moment.first.xyz, o2) +
         2.0 * (moment.first.w * offset.x * offset.y +
                offset.z * (moment.rest.x * offset.x + moment.rest.y * offset.y));
}

#endif
