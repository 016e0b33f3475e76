#version 460
// Vertices and colours are pulled from a buffer: clip position, then colour.
struct Vertex {
  vec4 position;
  vec4 color;
};
layout(binding = 0) readonly buffer Vertices { Vertex vertices[]; };
layout(location = 0) out vec4 color;

void main() {
  gl_Position = vertices[gl_VertexIndex].position;
  color = vertices[gl_VertexIndex].color;
}
