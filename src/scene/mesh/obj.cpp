#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <istream>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <streambuf>
#include <string>
#include <string_view>
#include <unordered_map>

#include "opaline/media.h"
#include "scene/formats.h"
#include "scene/hash.h"
#include "scene/mesh/mtl.h"
#include "scene/mesh/obj_lines.h"
#include "scene/mesh/obj_smoothing.h"
#include "scene/mesh/triangulate.h"
#include "scene/not_shown.h"
#include "scene/rig.h"
#include "scene/text.h"

namespace opaline::scene {

namespace {

/// A stream that reads text in place.
class TextStream : private std::streambuf, public std::istream {
 public:
  explicit TextStream(std::string_view text) : std::istream(this) {
    // streambuf takes a mutable pointer but only reads through it here.
    char* begin = const_cast<char*>(text.data());
    setg(begin, begin, begin + text.size());
  }
};

/// All faces of one material name.
struct Group {
  std::string name;                    ///< at first with all that follows it
  std::vector<std::uint32_t> corners;  ///< index into ObjReader::pairs
  std::vector<std::uint32_t> sizes;
};

constexpr std::int64_t noNormal = std::numeric_limits<std::int64_t>::min();
constexpr std::int64_t noPlace = noNormal;

/// A position, a normal and texture coordinates, by index from 0.
struct Corner {
  std::int64_t position = 0;
  std::int64_t normal = noNormal;
  std::int64_t place = noPlace;
};

struct ObjReader {
  const Input& input;
  std::vector<Vec3> positions{};
  std::vector<Vec3> normals{};
  std::vector<Vec2> places{};
  std::vector<Corner> corners{};
  std::vector<Group> groups{};
  std::map<std::string, std::size_t, std::less<>> groupOf{};
  std::size_t current = 0;
  std::string part{};  ///< of `o` or `g`, that faces belong to; may be empty
  std::map<std::string, std::set<std::size_t>> groupsOfPart{};  ///< of parts that have faces
  std::vector<std::size_t> endOfFace{};                         ///< among the corners
  std::string problem{};                                        ///< with an index, the first

  void use(const std::string& material) {
    const auto [entry, isNew] = groupOf.try_emplace(material, groups.size());
    if (isNew) groups.push_back({material, {}, {}});
    current = entry->second;
  }

  /// Turns an index that is 1-based, or negative and relative to the last one so far, into a
  /// 0-based one.
  std::int64_t resolve(int index, std::size_t countSoFar, std::string_view one,
                       std::string_view many) {
    if (index > 0) return std::int64_t{index} - 1;
    const std::int64_t resolved = static_cast<std::int64_t>(countSoFar) + index;
    if (resolved < 0 && problem.empty()) {
      problem = fmt::format("a face names {} {}, but there are {} {} before it", one, index,
                            countSoFar, many);
    }
    return resolved;
  }

  void face(std::span<const tinyobj::index_t> indices) {
    std::uint32_t size = 0;
    for (const tinyobj::index_t& index : indices) {
      if (index.vertex_index == 0) break;  // the words of a comment
      Corner corner{resolve(index.vertex_index, positions.size(), "vertex", "vertices"), noNormal};
      if (index.normal_index != 0)
        corner.normal = resolve(index.normal_index, normals.size(), "normal", "normals");
      if (index.texcoord_index != 0)
        corner.place = resolve(index.texcoord_index, places.size(), "texture coordinates",
                               "texture coordinates");
      groups[current].corners.push_back(static_cast<std::uint32_t>(corners.size()));
      corners.push_back(corner);
      ++size;
    }
    groups[current].sizes.push_back(size);
    endOfFace.push_back(corners.size());
    groupsOfPart[part].insert(current);
  }

  /// To be called at the end, since a face may precede its vertices.
  void checkRange() const {
    if (!problem.empty()) failObj(input, problem);
    for (const Corner& corner : corners) {
      if (corner.position >= static_cast<std::int64_t>(positions.size())) {
        failObj(input, fmt::format("a face names vertex {}, but there are {} vertices",
                                   corner.position + 1, positions.size()));
      }
      if (corner.place != noPlace && corner.place >= static_cast<std::int64_t>(places.size())) {
        failObj(input, fmt::format("a face names texture coordinates {}, but there are {}",
                                   corner.place + 1, places.size()));
      }
      if (corner.normal == noNormal) continue;
      if (corner.normal >= static_cast<std::int64_t>(normals.size())) {
        failObj(input, fmt::format("a face names normal {}, but there are {} normals",
                                   corner.normal + 1, normals.size()));
      }
    }
  }
};

tinyobj::callback_t callbacks() {
  tinyobj::callback_t callback;
  callback.vertex_cb = [](void* reader, float x, float y, float z, float) {
    static_cast<ObjReader*>(reader)->positions.push_back({x, y, z});
  };
  callback.normal_cb = [](void* reader, float x, float y, float z) {
    static_cast<ObjReader*>(reader)->normals.push_back({x, y, z});
  };
  callback.texcoord_cb = [](void* reader, float u, float v, float) {
    const bool finite = std::isfinite(u) && std::isfinite(v);
    static_cast<ObjReader*>(reader)->places.push_back(finite ? Vec2{u, 1 - v} : Vec2{});
  };
  callback.index_cb = [](void* reader, tinyobj::index_t* indices, int count) {
    static_cast<ObjReader*>(reader)->face({indices, static_cast<std::size_t>(count)});
  };
  callback.usemtl_cb = [](void* reader, const char* name, int) {
    static_cast<ObjReader*>(reader)->use(std::string(trimmed(name)));
  };
  callback.object_cb = [](void* reader, const char* name) {
    static_cast<ObjReader*>(reader)->part = name;
  };
  callback.group_cb = [](void* reader, const char** names, int count) {
    static_cast<ObjReader*>(reader)->part = count > 0 ? names[0] : "";
  };
  return callback;
}

/// Gives faces without normals those of their smoothing groups. A single group needs no work:
/// missing normals become smooth anyway.
void smoothen(std::span<const ObjSmoothing> smoothing, ObjReader& reader) {
  const bool isOneGroup =
      std::all_of(smoothing.begin(), smoothing.end(), [&](const ObjSmoothing& from) {
        return from.group != 0 && from.group == smoothing.front().group;
      });
  if (isOneGroup) return;
  std::vector<ObjFace> faces;
  std::vector<std::size_t> corners;
  std::size_t first = 0;
  for (std::size_t number = 0; number < reader.endOfFace.size(); ++number) {
    const std::size_t end = reader.endOfFace[number];
    ObjFace face{number};
    bool hasNormals = false;
    for (std::size_t c = first; c < end; ++c) {
      hasNormals = hasNormals || reader.corners[c].normal != noNormal;
      face.positions.push_back(static_cast<std::uint32_t>(reader.corners[c].position));
    }
    if (!hasNormals) {
      for (std::size_t c = first; c < end; ++c) corners.push_back(c);
      faces.push_back(std::move(face));
    }
    first = end;
  }
  const ObjNormals made = normalsOfSmoothing(reader.positions, faces, smoothing);
  for (std::size_t i = 0; i < corners.size(); ++i)
    reader.corners[corners[i]].normal =
        static_cast<std::int64_t>(reader.normals.size() + made.ofCorner[i]);
  reader.normals.insert(reader.normals.end(), made.normals.begin(), made.normals.end());
}

/// The name that the rest of a line of `usemtl` means. A name may have blanks in it, and a comment
/// may follow.
std::string materialNamed(const std::string& line, const MtlMaterials& materials) {
  const auto isKnown = [&](const std::string& name) {
    return findMedium(name) || materials.contains(name);
  };
  if (isKnown(line)) return line;
  std::string_view rest = line;
  std::string word(nextWord(rest));
  return isKnown(word) || trimmed(rest).starts_with('#') ? word : line;
}

/// The name of the medium or material whose faces make one object with those of the group. All that
/// are neither become marble and have none.
std::string objectOf(const Group& group, const MtlMaterials& materials) {
  if (const auto medium = findMedium(group.name)) return medium->name;
  return materials.contains(group.name) ? group.name : "";
}

/// Parts whose faces are not exactly those of one object.
std::vector<std::string> partsWithoutObject(const ObjReader& reader,
                                            const MtlMaterials& materials) {
  std::map<std::string, std::set<std::string>> objectsOfPart;
  std::map<std::string, std::size_t> partsOfObject;
  for (const auto& [part, groups] : reader.groupsOfPart) {
    std::set<std::string>& objects = objectsOfPart[part];
    for (const std::size_t group : groups)
      objects.insert(objectOf(reader.groups[group], materials));
    for (const std::string& object : objects) ++partsOfObject[object];
  }
  std::vector<std::string> result;
  for (const auto& [part, objects] : objectsOfPart) {
    const bool isObject = objects.size() == 1 && partsOfObject[*objects.begin()] == 1;
    if (!part.empty() && !isObject) result.push_back(part);
  }
  return result;
}

std::vector<NotShown> notShownOf(const ObjReader& reader, const ObjExtras& extras,
                                 std::span<const std::string> materialFiles,
                                 const MtlMaterials& materials) {
  std::vector<NotShown> result;
  for (const Group& group : reader.groups) {
    if (group.sizes.empty() || group.name.empty() || findMedium(group.name)) continue;
    const auto material = materials.find(group.name);
    if (material == materials.end()) {
      addNotShown(result, "materials", group.name);
    } else {
      for (const std::string& what : material->second.notShown)
        addNotShown(result, what, group.name);
    }
  }
  if (materials.empty()) {
    for (const std::string& file : materialFiles) addNotShown(result, "material files", file);
  }
  const std::size_t parts = reader.groupsOfPart.size() - reader.groupsOfPart.count("");
  if (parts > 1) {
    for (const std::string& part : partsWithoutObject(reader, materials)) {
      addNotShown(result, "groups as objects of their own", part);
    }
  }
  addNotShown(result, extras.notShown);
  if (extras.coloredVertices > 0) addNotShown(result, "vertex colours", {});
  return result;
}

/// Numbers the distinct corners that a set of groups uses.
class VertexTable {
 public:
  VertexTable(const ObjReader& reader, bool withNormals, bool withPlaces)
      : reader_(reader), withNormals_(withNormals), withPlaces_(withPlaces) {}

  std::uint32_t indexOf(const Corner& corner, RawObject& object) {
    RawMesh& mesh = object.mesh;
    const std::int64_t normal = withNormals_ ? corner.normal : noNormal;
    const std::int64_t place = withPlaces_ ? corner.place : noPlace;
    const auto [entry, isNew] = known_.try_emplace(
        Key{corner.position, normal, place}, static_cast<std::uint32_t>(mesh.positions.size()));
    if (isNew) {
      if (withPlaces_) {
        object.attributes.textureCoordinates[0].push_back(
            place == noPlace ? Vec2{} : reader_.places[static_cast<std::size_t>(place)]);
        // Vertices along the seam of a texture are no duplicates.
        mesh.tags.push_back(static_cast<std::uint64_t>(place));
      }
      mesh.positions.push_back(reader_.positions[static_cast<std::size_t>(corner.position)]);
      if (withNormals_) {
        // A zero normal is replaced by a smooth one on repair.
        mesh.normals.push_back(
            normal == noNormal ? Vec3{0, 0, 0} : reader_.normals[static_cast<std::size_t>(normal)]);
      }
    }
    return entry->second;
  }

 private:
  const ObjReader& reader_;
  bool withNormals_;
  bool withPlaces_;
  using Key = std::array<std::int64_t, 3>;
  std::unordered_map<Key, std::uint32_t, HashOfNumbers> known_;
};

/// Adds positions that no face names to the first mesh, so that repair sees and counts them.
void addUnused(const ObjReader& reader, RawObject& object) {
  RawMesh& mesh = object.mesh;
  std::vector<bool> used(reader.positions.size());
  for (const Corner& corner : reader.corners)
    used[static_cast<std::size_t>(corner.position)] = true;
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (used[v]) continue;
    mesh.positions.push_back(reader.positions[v]);
    if (!mesh.normals.empty()) mesh.normals.push_back({0, 0, 0});
    if (mesh.tags.empty()) continue;
    mesh.tags.push_back(0);
    object.attributes.textureCoordinates[0].push_back({});
  }
}

void buildMesh(const ObjReader& reader, std::span<const Group* const> groups, RawObject& object) {
  bool withNormals = false;
  for (const Group* group : groups) {
    withNormals = withNormals || std::any_of(group->corners.begin(), group->corners.end(),
                                             [&](std::uint32_t corner) {
                                               return reader.corners[corner].normal != noNormal;
                                             });
  }
  const bool withPlaces = object.opaque || reader.input.options.wantsCoordinates;
  VertexTable table(reader, withNormals, withPlaces && !reader.places.empty());
  Triangulator triangulator;
  std::vector<std::uint32_t> polygon;
  for (const Group* group : groups) {
    std::span<const std::uint32_t> rest(group->corners);
    for (const std::uint32_t size : group->sizes) {
      polygon.clear();
      for (const std::uint32_t corner : rest.first(size)) {
        polygon.push_back(table.indexOf(reader.corners[corner], object));
      }
      rest = rest.subspan(size);
      triangulator.add(object.mesh, polygon);
    }
  }
}

}  // namespace

RawScene loadObj(const Input& input) {
  const std::optional<std::string> joined = joinedLines(textOf(input));
  const std::string_view text = joined ? *joined : textOf(input);
  const ObjExtras extras = requireSoundLines(input, text);
  ObjReader reader{input};
  reader.use("");
  TextStream stream(text);
  std::string warning;
  std::string error;
  tinyobj::LoadObjWithCallback(stream, callbacks(), &reader, nullptr, &warning, &error);
  if (!error.empty()) failObj(input, cleanText(error));
  if (reader.positions.empty()) failObj(input, "it has no vertices, so it is not an OBJ file");
  reader.checkRange();
  smoothen(extras.smoothing, reader);

  std::vector<std::string> files;
  for (const std::string& line : extras.materialFiles)
    for (std::string& file : materialFilesOf(input, line)) files.push_back(std::move(file));
  RawScene scene;
  const MtlMaterials materials = readMtl(input, files, scene.unreadable);
  for (Group& group : reader.groups) group.name = materialNamed(group.name, materials);
  // Those that are neither a medium nor in a material file all become marble: one object.
  std::map<std::string, std::vector<const Group*>> byMedium;
  for (const Group& group : reader.groups) {
    if (!group.sizes.empty()) byMedium[objectOf(group, materials)].push_back(&group);
  }
  if (byMedium.empty()) failObj(input, "it has no faces");
  for (const auto& [medium, groups] : byMedium) {
    RawObject object;
    object.name = medium.empty() ? cleanText(input.file.stem().string()) : cleanText(medium);
    object.medium = findMedium(medium).value_or(defaultMedium());
    const auto material = materials.find(medium);
    if (material != materials.end() && !findMedium(medium)) object.opaque = material->second.shown;
    buildMesh(reader, groups, object);
    scene.objects.push_back(std::move(object));
  }
  addUnused(reader, scene.objects[0]);
  for (RawObject& object : scene.objects) startProvenance(object.mesh);
  addNotShown(scene.notShown, notShownOf(reader, extras, files, materials));
  return scene;
}

}  // namespace opaline::scene
