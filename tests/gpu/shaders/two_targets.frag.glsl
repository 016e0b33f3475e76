#version 460
layout(constant_id = 0) const float scale = 1.0;
layout(location = 0) in vec4 color;
layout(location = 0) out vec4 first;
layout(location = 1) out vec2 second;

void main() {
  first = color;
  second = scale * color.xy;
}
