// Where the camera looks. Needs lib/frame.glsl.
#ifndef OPALINE_LIB_SIGHT
#define OPALINE_LIB_SIGHT

// The unit direction through a place of the picture, in clip space over w.
vec3 sightThrough(vec2 clip) {
  mat4 rows = transpose(frame.worldToClip);
  vec3 right = rows[0].xyz;
  vec3 down = rows[1].xyz;
  return normalize(rows[3].xyz + clip.x / dot(right, right) * right + clip.y / dot(down, down) * down);
}

// From one pixel to the next in the middle of a picture of so many rows, rad.
float angleOfPixel(int rows) {
  vec4 down = transpose(frame.worldToClip)[1];
  return 2.0 / (length(down.xyz) * float(rows));
}

#endif
