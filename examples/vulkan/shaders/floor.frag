#version 460

layout(location = 0) in vec2 place;
layout(location = 0) out vec4 radiance;

void main() {
  ivec2 square = ivec2(floor(place / 15.0));
  float light = 0.25 * exp(-dot(place, place) / 6400.0);
  radiance = vec4(light * ((square.x + square.y & 1) == 0 ? vec3(0.5, 0.45, 0.4) : vec3(0.12)), 1.0);
}
