// Changes the JSON of a binary glTF file as JSON, and its buffer as bytes, and puts a file together
// whose lengths agree: a reader sees damage of the meaning, not of the container.

#include <array>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <optional>
#include <random>
#include <string>

#include "scene/gltf/glb.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace {

using Json = nlohmann::json;
using Random = std::minstd_rand;

struct Parts {
  std::string json;
  std::string buffer;
};

std::optional<Parts> partsOf(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t heads = 20;
  const std::string_view file(reinterpret_cast<const char*>(data), size);
  if (size < heads || !file.starts_with("glTF")) return std::nullopt;
  std::uint32_t length = 0;
  std::memcpy(&length, data + 12, 4);
  if (length > size - heads) return std::nullopt;
  const std::size_t buffer = std::min(size, heads + length + 8);
  return Parts{std::string(file.substr(heads, length)), std::string(file.substr(buffer))};
}

std::uint32_t below(Random& random, std::size_t limit) {
  return static_cast<std::uint32_t>(random() >> 4U) % static_cast<std::uint32_t>(limit);
}

std::string bytesOf(std::string text, std::size_t most) {
  const std::size_t size = text.size();
  text.resize(std::max(most, size));
  text.resize(LLVMFuzzerMutate(reinterpret_cast<std::uint8_t*>(text.data()), size, text.size()));
  return text;
}

/// Every value has the same chance.
Json* anyValue(Json& json, Random& random) {
  Json* chosen = nullptr;
  std::size_t seen = 0;
  const auto visit = [&](const auto& self, Json& value) -> void {
    if (below(random, ++seen) == 0) chosen = &value;
    if (!value.is_structured()) return;
    for (Json& child : value) self(self, child);
  };
  visit(visit, json);
  return chosen;
}

Json anyNumber(Random& random) {
  constexpr std::array numbers{0.0,    1.0,    -1.0,   2.0,          3.0,         4.0,
                               5120.0, 5121.0, 5122.0, 5123.0,       5125.0,      5126.0,
                               1e-30,  1e30,   0.5,    4294967295.0, 2147483648.0};
  const double number = numbers.at(below(random, numbers.size()));
  if (number == std::floor(number) && std::abs(number) < 1e10)
    return Json(static_cast<std::int64_t>(number));
  return number;
}

/// Keys and words that readers look for.
std::string anyWord(Random& random) {
  static const std::array words{"POSITION",
                                "NORMAL",
                                "TANGENT",
                                "TEXCOORD_0",
                                "COLOR_0",
                                "JOINTS_0",
                                "WEIGHTS_0",
                                "indices",
                                "mode",
                                "targets",
                                "weights",
                                "material",
                                "materials",
                                "mesh",
                                "meshes",
                                "skin",
                                "skins",
                                "joints",
                                "inverseBindMatrices",
                                "skeleton",
                                "children",
                                "matrix",
                                "rotation",
                                "scale",
                                "translation",
                                "camera",
                                "cameras",
                                "perspective",
                                "yfov",
                                "znear",
                                "extensions",
                                "extensionsUsed",
                                "extensionsRequired",
                                "KHR_lights_punctual",
                                "lights",
                                "light",
                                "type",
                                "spot",
                                "point",
                                "directional",
                                "intensity",
                                "color",
                                "range",
                                "SCALAR",
                                "VEC2",
                                "VEC3",
                                "VEC4",
                                "MAT4",
                                "sparse",
                                "count",
                                "values",
                                "bufferView",
                                "byteOffset",
                                "byteStride",
                                "byteLength",
                                "normalized",
                                "componentType",
                                "STEP",
                                "LINEAR",
                                "CUBICSPLINE",
                                "interpolation",
                                "path",
                                "EXT_mesh_gpu_instancing",
                                "TRANSLATION",
                                "ROTATION",
                                "SCALE",
                                "KHR_mesh_quantization",
                                "KHR_materials_volume",
                                "KHR_materials_transmission",
                                "KHR_materials_scatter",
                                "KHR_materials_emissive_strength",
                                "KHR_texture_transform",
                                "attenuationDistance",
                                "attenuationColor",
                                "thicknessFactor",
                                "multiscatterColor",
                                "scatterAnisotropy",
                                "pbrMetallicRoughness",
                                "baseColorFactor",
                                "baseColorTexture",
                                "metallicFactor",
                                "roughnessFactor",
                                "normalTexture",
                                "alphaMode",
                                "MASK",
                                "BLEND",
                                "alphaCutoff",
                                "texCoord",
                                "images",
                                "textures",
                                "samplers",
                                "source",
                                "uri",
                                "data:;base64,AAAA",
                                "pointer",
                                "KHR_animation_pointer",
                                "/materials/0/pbrMetallicRoughness/roughnessFactor",
                                "/materials/0/extensions/KHR_materials_volume/attenuationDistance",
                                "/extensions/KHR_lights_punctual/lights/0/intensity",
                                "/cameras/0/perspective/yfov",
                                "/nodes/0/translation",
                                "scatterStrengthFactor",
                                "scatterStrengthTexture",
                                "EXT_texture_webp",
                                "name",
                                "scene",
                                "nodes"};
  return words.at(below(random, words.size()));
}

void change(Json& json, Random& random) {
  Json& value = *anyValue(json, random);
  switch (below(random, 8)) {
    case 0:
      value = anyNumber(random);
      return;
    case 1:
      if (value.is_number_integer())
        value = value.get<std::int64_t>() + (below(random, 2) == 0 ? 1 : -1);
      else if (value.is_number())
        value = -2 * value.get<double>();
      return;
    case 2:
      value = anyWord(random);
      return;
    case 3: {
      const Json copy = *anyValue(json, random);
      if (copy.dump().size() < 4096) value = copy;
      return;
    }
    case 4:
      if (value.is_object()) value[anyWord(random)] = *anyValue(json, random);
      return;
    case 5:
      if (value.is_array() && !value.empty())
        value.push_back(value.at(below(random, value.size())));
      return;
    case 6:
      if (value.is_array() && !value.empty()) value.erase(below(random, value.size()));
      if (value.is_object() && !value.empty())
        value.erase(std::next(value.begin(), below(random, value.size())));
      return;
    default:
      if (value.is_object())
        value[anyWord(random)] = Json::object();
      else
        value = Json::array({anyNumber(random), anyNumber(random), anyNumber(random)});
      return;
  }
}

std::string changed(const std::string& text, std::size_t most, Random& random) {
  Json json = Json::parse(text, nullptr, false);
  constexpr std::size_t longest = 100'000;
  if (json.is_discarded() || text.size() > longest || below(random, 20) == 0)
    return bytesOf(text, most);
  for (std::uint32_t changes = 1 + below(random, 3); changes > 0; --changes) change(json, random);
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed) {
  std::optional<Parts> parts = partsOf(data, size);
  if (!parts) return LLVMFuzzerMutate(data, size, most);
  Random random(seed + 1);
  if (!parts->buffer.empty() && below(random, 3) == 0) {
    parts->buffer = bytesOf(parts->buffer, parts->buffer.size() + 64);
  } else {
    parts->json = changed(parts->json, parts->json.size() + 64, random);
  }
  const std::string file = opaline::test::glb(parts->json, parts->buffer);
  if (file.size() > most) return size;
  std::memcpy(data, file.data(), file.size());
  return file.size();
}
