// Which object's surface each texel of the diffusion source map carries, plus one.
#version 460

layout(location = 2) flat in uint object;

layout(location = 0) out uint coverage;

void main() { coverage = object + 1u; }
