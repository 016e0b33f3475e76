#include "scene/gltf/extensions.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "scene/gltf/file.h"
#include "scene/text.h"

namespace opaline::scene {

namespace {

constexpr std::array<std::string_view, 17> read{"EXT_mesh_gpu_instancing",
                                                "EXT_meshopt_compression",
                                                "EXT_texture_webp",
                                                "KHR_animation_pointer",
                                                "KHR_draco_mesh_compression",
                                                "KHR_lights_punctual",
                                                "KHR_materials_diffuse_transmission",
                                                "KHR_materials_emissive_strength",
                                                "KHR_materials_ior",
                                                "KHR_materials_scatter",
                                                "KHR_materials_specular",
                                                "KHR_materials_unlit",
                                                "KHR_materials_volume",
                                                "KHR_materials_volume_scatter",
                                                "KHR_mesh_quantization",
                                                "KHR_meshopt_compression",
                                                "KHR_texture_transform"};

constexpr std::array<std::string_view, 16> appearance{"EXT_texture_avif",
                                                      "KHR_materials_anisotropy",
                                                      "KHR_materials_clearcoat",
                                                      "KHR_materials_dispersion",
                                                      "KHR_materials_iridescence",
                                                      "KHR_materials_pbrSpecularGlossiness",
                                                      "KHR_materials_sheen",
                                                      "KHR_materials_subsurface",
                                                      "KHR_materials_transmission",
                                                      "KHR_materials_variants",
                                                      "KHR_texture_basisu",
                                                      "KHR_texture_procedurals",
                                                      "KHR_xmp",
                                                      "KHR_xmp_json_ld",
                                                      "MSFT_texture_dds",
                                                      "MSFT_packing_normalRoughnessMetallic"};

template <std::size_t Count>
bool contains(const std::array<std::string_view, Count>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

GltfExtension kindOf(std::string_view extension) {
  if (contains(read, extension)) return GltfExtension::Read;
  return contains(appearance, extension) ? GltfExtension::Appearance : GltfExtension::Unknown;
}

void requireKnownExtensions(const Input& input, const std::vector<std::string>& required) {
  constexpr std::size_t mostNamed = 8;
  std::set<std::string> notRead;
  for (const std::string& name : required) {
    if (kindOf(name) != GltfExtension::Read) notRead.insert(cleanText(name, 60));
  }
  if (notRead.empty()) return;
  const std::vector<std::string_view> named(notRead.begin(), notRead.end());
  failGltf(input, fmt::format("it requires {}, which {} not supported: export it without; "
                              "docs/gltf.md lists those that are",
                              listed(named, mostNamed), notRead.size() == 1 ? "is" : "are"));
}

}  // namespace opaline::scene
