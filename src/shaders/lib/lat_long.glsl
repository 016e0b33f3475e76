// Place of a unit direction in a latitude-longitude map: top row +y, centre column -z, u grows
// towards +x.
#ifndef OPALINE_LIB_LAT_LONG
#define OPALINE_LIB_LAT_LONG
#include "lib/pi.glsl"

vec2 latLongCoordinates(vec3 direction) {
  return vec2(0.5 + atan(direction.x, -direction.z) / (2.0 * pi),
              acos(clamp(direction.y, -1.0, 1.0)) / pi);
}

#endif
