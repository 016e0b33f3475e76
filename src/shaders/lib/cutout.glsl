// Where opaque surfaces have holes, for fragment shaders. Needs, before it, BINDING_OBJECTS,
// BINDING_MEDIA, BINDING_OPAQUES and BINDING_TEXELS.
#ifndef OPALINE_LIB_CUTOUT
#define OPALINE_LIB_CUTOUT
#include "lib/material.glsl"
#include "lib/opaque_material.glsl"

// Whether the alpha of the base colour is less than its cutoff.
bool isCutOut(uint object, vec4 coordinates, float alpha) {
  OpaqueData material = opaques[mediumAt(objects[object], vec3(0.0)).tables.y];
  vec4 right = dFdx(coordinates);
  vec4 down = dFdy(coordinates);
  MaterialPlace place = MaterialPlace(TexturePlace(coordinates.xy, right.xy, down.xy),
                                      TexturePlace(coordinates.zw, right.zw, down.zw), vec4(1.0, 1.0, 1.0, alpha));
  return baseColorAt(material, place).a < material.emission.w;
}

#endif
