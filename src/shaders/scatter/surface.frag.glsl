// What the camera sees, one fragment a pixel: the sum that follows is spent on nothing hidden.
#version 460

layout(constant_id = 0) const uint exitanceAtVertices = 0u;

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 value;
layout(location = 3) flat in uint object;
layout(location = 4) flat in uint chart;

layout(location = 0) out vec4 positionObject;  // mm; object + 1
layout(location = 1) out vec4 unitNormal;      // towards the side that is seen
layout(location = 2) out vec4 surfaceValue;    // exitance; or near place, chart, angle of +y

void main() {
  vec3 n = normalize(normal);
  positionObject = vec4(position, float(object + 1u));
  unitNormal = vec4(gl_FrontFacing ? n : -n, 0.0);
  surfaceValue = exitanceAtVertices != 0u ? vec4(value.rgb, 1.0)
                                          : vec4(value.xy, float(chart), atan(value.w, value.z));
}
