// Place of a unit direction in a latitude-longitude map: top row +y, centre column -z, u grows
// towards +x.
#ifndef OPALINE_LIB_LAT_LONG
#define OPALINE_LIB_LAT_LONG

vec2 latLongCoordinates(vec3 direction) {
  return vec2(0.5 + atan(direction.x, -direction.z) / 6.28318530717959,
              acos(clamp(direction.y, -1.0, 1.0)) / 3.14159265358979);
}

#endif
