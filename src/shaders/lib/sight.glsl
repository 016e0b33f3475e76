// Where the camera looks. Needs lib/frame.glsl.
#ifndef OPALINE_LIB_SIGHT
#define OPALINE_LIB_SIGHT

// The unit direction through a place of the picture, in clip space over w.
vec3 sightThrough(vec2 clip) {
  mat4 rows = transpose(frame.worldToClip);
  vec3 axis = rows[3].xyz;
  // Pictures whose middle is not on the axis have a part of it in the others.
  vec2 off = vec2(dot(rows[0].xyz, axis), dot(rows[1].xyz, axis)) / dot(axis, axis);
  vec3 right = rows[0].xyz - off.x * axis;
  vec3 down = rows[1].xyz - off.y * axis;
  clip -= off;
  return normalize(axis + clip.x / dot(right, right) * right + clip.y / dot(down, down) * down);
}

// From one pixel to the next in the middle of a picture of so many rows, rad.
float angleOfPixel(int rows) {
  vec4 down = transpose(frame.worldToClip)[1];
  return 2.0 / (length(down.xyz) * float(rows));
}

#endif
