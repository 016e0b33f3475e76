// Where the camera looks. Needs lib/frame.glsl.
#ifndef OPALINE_LIB_SIGHT
#define OPALINE_LIB_SIGHT

struct Sight {
  vec3 origin;
  vec3 direction;  // unit
};

// Through a place of the picture, in clip space over w.
Sight sightThrough(vec2 clip) {
  mat4 rows = transpose(frame.worldToClip);
  bool isParallel = frame.cameraPosition.w == 0.0 && !isinf(clip.x);  // not by uniforms alone: see lightsAt()
  vec3 axis = isParallel ? frame.cameraAxis.xyz : rows[3].xyz;
  // Pictures whose middle is not on the axis have a part of it in the other rows.
  vec2 off = vec2(dot(rows[0].xyz, axis), dot(rows[1].xyz, axis)) / dot(axis, axis);
  vec3 right = rows[0].xyz - off.x * axis;
  vec3 down = rows[1].xyz - off.y * axis;
  clip -= isParallel ? vec2(rows[0].w, rows[1].w) : off;
  vec3 aside = clip.x / dot(right, right) * right + clip.y / dot(down, down) * down;
  if (isParallel) return Sight((rows[2].w - 1.0) / length(rows[2].xyz) * axis + aside, axis);
  return Sight(frame.cameraPosition.xyz, normalize(axis + aside));
}

// The angle from one pixel to the next in the middle of a picture of so many rows, rad; 0 for parallel sight.
float angleOfPixel(int rows) {
  vec4 down = transpose(frame.worldToClip)[1];
  return frame.cameraPosition.w * 2.0 / (length(down.xyz) * float(rows));
}

#endif
