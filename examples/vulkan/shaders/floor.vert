// A square floor, which exists only in this shader.
#version 460

layout(push_constant) uniform Push {
  mat4 worldToClip;
  float heightMm;
};

layout(location = 0) out vec2 place;  // mm

void main() {
  place = 120.0 * (vec2(gl_VertexIndex & 1, gl_VertexIndex >> 1) * 2.0 - 1.0);
  gl_Position = worldToClip * vec4(place.x, heightMm, place.y, 1.0);
}
