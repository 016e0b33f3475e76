#pragma once

#include <array>
#include <string_view>

namespace opaline::scene::keys {

// All keys that a .toml scene may have, table by table. The loader refuses every other key. The
// writer can write whatever the loader reads.

template <std::size_t count>
using Keys = std::array<std::string_view, count>;

inline constexpr Keys<15> root{"model",       "diagonal_mm", "medium",   "media",  "objects",
                               "color_model", "materials",   "lights",   "models", "camera",
                               "environment", "render",      "morph_to", "deform", "ground"};
inline constexpr Keys<2> ground{"color", "height_mm"};
inline constexpr Keys<8> model{"file",      "diagonal_mm",    "morph_to",         "medium",
                               "transform", "translation_mm", "rotation_degrees", "scale"};
inline constexpr Keys<5> medium{"measured", "sigma_s_per_mm", "sigma_a_per_mm", "eta", "g"};
inline constexpr Keys<26> material{"kind",
                                   "medium",
                                   "color",
                                   "color_texture",
                                   "color_model",
                                   "ball_mm",
                                   "mean_free_path_mm",
                                   "g",
                                   "eta",
                                   "base_color",
                                   "base_color_texture",
                                   "metallic",
                                   "roughness",
                                   "metallic_roughness_texture",
                                   "specular",
                                   "specular_texture",
                                   "specular_color_texture",
                                   "normal_texture",
                                   "normal_scale",
                                   "occlusion_texture",
                                   "emission",
                                   "emission_texture",
                                   "diffuse_transmission",
                                   "diffuse_transmission_texture",
                                   "diffuse_transmission_color",
                                   "diffuse_transmission_color_texture"};
inline constexpr Keys<15> object{"medium",
                                 "material",
                                 "transform",
                                 "translation_mm",
                                 "rotation_degrees",
                                 "scale",
                                 "base_color",
                                 "metallic",
                                 "roughness",
                                 "specular",
                                 "emission",
                                 "normal_scale",
                                 "paint",
                                 "diffuse_transmission",
                                 "diffuse_transmission_color"};
inline constexpr Keys<3> deform{"kind", "amount", "period_seconds"};
inline constexpr Keys<4> directional{"type", "direction_to_light", "irradiance",
                                     "angular_radius_degrees"};
inline constexpr Keys<3> point{"type", "position_mm", "intensity"};
inline constexpr Keys<6> spot{"type",      "position_mm",   "direction",
                              "intensity", "inner_degrees", "outer_degrees"};
inline constexpr Keys<7> rectangle{"type",     "center_mm", "u_mm",   "v_mm",
                                   "radiance", "two_sided", "visible"};
inline constexpr Keys<7> disc{"type",     "center_mm", "normal", "radius_mm",
                              "radiance", "two_sided", "visible"};
inline constexpr Keys<5> sphere{"type", "center_mm", "radius_mm", "radiance", "visible"};
inline constexpr Keys<6> tube{"type", "from_mm", "to_mm", "radius_mm", "radiance", "visible"};
inline constexpr Keys<2> ambient{"type", "radiance"};
inline constexpr Keys<3> environment{"file", "intensity", "rotation_degrees"};
inline constexpr Keys<8> camera{"direction", "position_mm",           "target_mm",
                                "up",        "fov_degrees",           "shift_x",
                                "shift_y",   "orthographic_height_mm"};

}  // namespace opaline::scene::keys
