// What the camera sees, exitance interpolated between vertices.
#version 460

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 exitance;
layout(location = 3) flat in uint object;

layout(location = 0) out vec4 positionObject;
layout(location = 1) out vec4 unitNormal;
layout(location = 2) out vec4 surfaceExitance;

void main() {
  vec3 n = normalize(normal);
  positionObject = vec4(position, float(object + 1u));
  unitNormal = vec4(gl_FrontFacing ? n : -n, 0.0);
  surfaceExitance = vec4(exitance, 1.0);
}
