#version 460

layout(binding = 0) uniform sampler2D picture;  // light times coverage, coverage in alpha

layout(push_constant) uniform Constants {
  vec4 background;  // linear; w is 1 for the curve Khronos PBR Neutral
  vec2 origin;      // of the picture, pixels
  vec2 pixels;      // size of the picture
  float exposure;   // factor
};

layout(location = 0) out vec4 shown;

// Khronos Group 2024, "Khronos PBR Neutral Tone Mapper", as in core/tone.cpp.
vec3 neutral(vec3 color) {
  const float startCompression = 0.8 - 0.04;
  const float desaturation = 0.15;
  const float x = min(color.r, min(color.g, color.b));
  color -= x < 0.08 ? x - 6.25 * x * x : 0.04;
  const float peak = max(color.r, max(color.g, color.b));
  if (peak < startCompression) return color;
  const float d = 1 - startCompression;
  const float newPeak = 1 - d * d / (peak + d - startCompression);
  const float g = 1 - 1 / (desaturation * (peak - newPeak) + 1);
  return mix(color * (newPeak / peak), vec3(newPeak), g);
}

// IEC 61966-2-1.
float encode(float linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * pow(linear, 1 / 2.4) - 0.055;
}

void main() {
  const ivec2 size = textureSize(picture, 0);
  const vec2 place = (gl_FragCoord.xy - origin) / pixels;
  const vec4 light = texelFetch(picture, clamp(ivec2(place * size), ivec2(0), size - 1), 0);
  const float coverage = clamp(light.a, 0, 1);
  vec3 color = light.a > 0 ? light.rgb / light.a : light.rgb;
  color = clamp(mix(color, vec3(0), isnan(color)) * exposure, 0, 1e18);
  if (background.w != 0) color = neutral(color);
  color = mix(background.rgb, clamp(color, 0, 1), coverage);
  shown = vec4(encode(color.r), encode(color.g), encode(color.b), 1);
}
