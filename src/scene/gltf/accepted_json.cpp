#include "scene/gltf/accepted_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "scene/gltf/draco.h"
#include "scene/gltf/meshopt.h"
#include "scene/gltf/pointers.h"

namespace opaline::scene {

namespace {

using nlohmann::json;

bool uses(const GltfPrescan& prescan, const char* extension) {
  const auto names = [&](const std::vector<std::string>& list) {
    return std::find(list.begin(), list.end(), extension) != list.end();
  };
  return names(prescan.extensionsUsed) || names(prescan.extensionsRequired);
}

/// The member of an object; null where there is none.
json* member(json& of, const char* key) {
  const auto found = of.is_object() ? of.find(key) : of.end();
  return found == of.end() ? nullptr : &*found;
}

json* extensionOf(json& of, const char* name) {
  json* const extensions = member(of, "extensions");
  return extensions == nullptr ? nullptr : member(*extensions, name);
}

template <typename Change>
void forEach(json* array, Change&& change) {
  if (array == nullptr || !array->is_array()) return;
  for (std::size_t i = 0; i < array->size(); ++i) change((*array)[i], i);
}

/// Turns a pointer such as "/nodes/3/translation" into the target of an ordinary channel.
bool asNodeChannel(const std::string& pointer, json& target) {
  constexpr std::string_view start = "/nodes/";
  const std::size_t slash = pointer.rfind('/');
  if (!pointer.starts_with(start) || slash < start.size()) return false;
  const std::string path = pointer.substr(slash + 1);
  const std::string index = pointer.substr(start.size(), slash - start.size());
  const bool isNumber = !index.empty() && index.size() < 9 &&
                        index.find_first_not_of("0123456789") == std::string::npos;
  const bool moves =
      path == "translation" || path == "rotation" || path == "scale" || path == "weights";
  if (!isNumber || !moves) return false;
  target = {{"node", std::stoi(index)}, {"path", path}};
  return true;
}

/// tinygltf requires a node in every channel.
bool acceptPointer(json& channel) {
  json* const target = member(channel, "target");
  if (target == nullptr) return false;
  json* const extension = extensionOf(*target, pointerExtension);
  if (extension == nullptr) return false;
  json* const pointer = member(*extension, "pointer");
  if (pointer != nullptr && pointer->is_string() &&
      asNodeChannel(pointer->get<std::string>(), *target))
    return true;
  (*target)["node"] = 0;
  return true;
}

bool isPlaceholder(json& buffer, std::size_t index) {
  for (const char* name : meshoptExtensions) {
    json* const extension = extensionOf(buffer, name);
    json* const fallback = extension == nullptr ? nullptr : member(*extension, "fallback");
    if (fallback != nullptr && *fallback == true) return true;
  }
  // The first buffer may be the binary chunk.
  return index > 0 && buffer.is_object() && member(buffer, "uri") == nullptr;
}

}  // namespace

bool mayHavePlaceholders(const GltfPrescan& prescan) {
  return std::any_of(meshoptExtensions.begin(), meshoptExtensions.end(),
                     [&](const char* name) { return uses(prescan, name); });
}

std::optional<std::string> acceptedJson(const GltfPrescan& prescan, std::string_view text) {
  const bool placeholders = mayHavePlaceholders(prescan);
  const bool pointers = uses(prescan, pointerExtension);
  if (!placeholders && !pointers && !uses(prescan, dracoExtension)) return std::nullopt;
  json root = json::parse(text);
  bool changed = false;
  forEach(placeholders ? member(root, "buffers") : nullptr, [&](json& buffer, std::size_t index) {
    if (!isPlaceholder(buffer, index)) return;
    buffer["byteLength"] = 1;
    buffer["uri"] = "data:application/octet-stream;base64,AA==";
    changed = true;
  });
  forEach(member(root, "meshes"), [&](json& mesh, std::size_t) {
    forEach(member(mesh, "primitives"), [&](json& primitive, std::size_t) {
      if (extensionOf(primitive, dracoExtension) == nullptr) return;
      changed = primitive.erase("indices") > 0 || changed;
    });
  });
  forEach(pointers ? member(root, "animations") : nullptr, [&](json& animation, std::size_t) {
    forEach(member(animation, "channels"),
            [&](json& channel, std::size_t) { changed = acceptPointer(channel) || changed; });
  });
  if (!changed) return std::nullopt;
  return root.dump();
}

}  // namespace opaline::scene
