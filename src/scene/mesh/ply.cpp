#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "opaline/error.h"
#include "opaline/tone.h"
#include "scene/formats.h"
#include "scene/hash.h"
#include "scene/mesh/ply_header.h"
#include "scene/mesh/triangulate.h"
#include "scene/not_shown.h"
#include "scene/rig.h"
#include "scene/text.h"

// The format: G. Turk, "The PLY Polygon File Format", 1994.

namespace opaline::scene {

namespace {

/// Reads value after value from the body.
class Body {
 public:
  Body(const Input& input, const PlyHeader& header)
      : input_(input), rest_(input.bytes.subspan(header.bytes)), encoding_(header.encoding) {}

  /// Throws Error unless the file has room for `element`: every item takes some bytes.
  void requireRoom(const PlyElement& element) const {
    std::uint64_t least = 0;
    for (const PlyProperty& property : element.properties) {
      least +=
          encoding_ == PlyEncoding::Ascii ? 2 : sizeOf(property.listCount.value_or(property.type));
    }
    // The last number of a text needs no separator after it.
    const std::uint64_t room = rest_.size() + (encoding_ == PlyEncoding::Ascii ? 1 : 0);
    if (least > 0 && element.count > room / least) truncated(element);
  }

  /// A number as it stands in the file; counts and indices come out exact.
  double next(PlyScalar type, const PlyElement& element) {
    return encoding_ == PlyEncoding::Ascii ? nextText(element) : nextBinary(type, element);
  }

  std::uint64_t nextCount(const PlyProperty& property, const PlyElement& element) {
    const double count = next(*property.listCount, element);
    if (!(count >= 0) || count != std::floor(count)) {
      failPly(input_,
              fmt::format("a list of '{}' has {} entries", cleanText(element.name, 40), count));
    }
    const std::size_t least = encoding_ == PlyEncoding::Ascii ? 2 : sizeOf(property.type);
    const std::size_t room = rest_.size() + (encoding_ == PlyEncoding::Ascii ? 1 : 0);
    const std::size_t most = room / least;
    if (count > static_cast<double>(most)) truncated(element);
    return static_cast<std::uint64_t>(count);
  }

 private:
  [[noreturn]] void truncated(const PlyElement& element) const {
    const std::string many = element.name == "vertex" ? "vertices"
                             : element.name == "face"
                                 ? "faces"
                                 : fmt::format("'{}' elements", cleanText(element.name, 40));
    failPly(input_,
            fmt::format("the file ends before all of its {} {}; it is damaged or incomplete",
                        element.count, many));
  }

  double nextText(const PlyElement& element) {
    const auto isSpace = [](std::byte b) {
      const char c = static_cast<char>(b);
      return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\v' || c == '\f';
    };
    const auto begin = std::find_if_not(rest_.begin(), rest_.end(), isSpace);
    const auto end = std::find_if(begin, rest_.end(), isSpace);
    if (begin == end) truncated(element);
    std::string_view word(reinterpret_cast<const char*>(&*begin),
                          static_cast<std::size_t>(end - begin));
    rest_ = rest_.subspan(static_cast<std::size_t>(end - rest_.begin()));
    if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
    double value = 0;
    const auto [stop, problem] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (problem == std::errc::result_out_of_range) {
      // Too small to be told from zero, or too large: from_chars does not say which.
      return word.find("e-") != std::string_view::npos || word.find("E-") != std::string_view::npos
                 ? 0.0
                 : INFINITY;
    }
    if (problem != std::errc{} || stop != word.data() + word.size()) {
      failPly(input_, fmt::format("'{}' in element '{}' is not a number", cleanText(word, 40),
                                  cleanText(element.name, 40)));
    }
    return value;
  }

  template <typename T>
  double take() {
    std::array<std::byte, sizeof(T)> bytes;
    std::memcpy(bytes.data(), rest_.data(), sizeof(T));
    rest_ = rest_.subspan(sizeof(T));
    constexpr bool hostIsBig = std::endian::native == std::endian::big;
    if ((encoding_ == PlyEncoding::Big) != hostIsBig) std::reverse(bytes.begin(), bytes.end());
    return static_cast<double>(std::bit_cast<T>(bytes));
  }

  double nextBinary(PlyScalar type, const PlyElement& element) {
    if (rest_.size() < sizeOf(type)) truncated(element);
    switch (type) {
      case PlyScalar::Int8:
        return take<std::int8_t>();
      case PlyScalar::Uint8:
        return take<std::uint8_t>();
      case PlyScalar::Int16:
        return take<std::int16_t>();
      case PlyScalar::Uint16:
        return take<std::uint16_t>();
      case PlyScalar::Int32:
        return take<std::int32_t>();
      case PlyScalar::Uint32:
        return take<std::uint32_t>();
      case PlyScalar::Float32:
        return take<float>();
      case PlyScalar::Float64:
        return take<double>();
    }
    return 0;
  }

  const Input& input_;
  std::span<const std::byte> rest_;
  PlyEncoding encoding_;
};

/// Whole numbers are sRGB, others linear.
float linearColor(double value, PlyScalar type) {
  const std::size_t bytes = sizeOf(type);
  if (bytes > 2) return static_cast<float>(value > 0 ? std::min(value, 1.0) : 0.0);
  const double most = bytes == 1 ? 255 : 65535;
  return decodeSrgb(static_cast<float>(std::clamp(value / most, 0.0, 1.0)));
}

void readVertices(const Input& input, const PlyElement& element, Body& body, RawObject& object) {
  RawMesh& mesh = object.mesh;
  constexpr std::array<std::string_view, 9> names{"x",  "y",   "z",     "nx",  "ny",
                                                  "nz", "red", "green", "blue"};
  constexpr std::size_t red = 6;
  std::vector<std::size_t> slot(element.properties.size(), names.size());
  std::array<bool, names.size()> have{};
  for (std::size_t i = 0; i < element.properties.size(); ++i) {
    const auto name = std::find(names.begin(), names.end(), element.properties[i].name);
    if (name == names.end() || element.properties[i].listCount) continue;
    slot[i] = static_cast<std::size_t>(name - names.begin());
    have[slot[i]] = true;
  }
  if (!have[0] || !have[1] || !have[2]) failPly(input, "its vertices have no x, y and z");
  if (element.count > 0xFFFFFFFEU)
    failPly(input, "it has more vertices than 32-bit indices can name");
  const bool hasNormals = have[3] && have[4] && have[5];
  const bool hasColors = have[red] && have[red + 1] && have[red + 2];
  mesh.positions.reserve(element.count);
  if (hasNormals) mesh.normals.reserve(element.count);
  for (std::uint64_t v = 0; v < element.count; ++v) {
    std::array<float, names.size() + 1> value{};
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      const std::uint64_t count = property.listCount ? body.nextCount(property, element) : 1;
      for (std::uint64_t n = 0; n < count; ++n) {
        const double found = body.next(property.type, element);
        value[slot[i]] = slot[i] >= red && slot[i] < names.size()
                             ? linearColor(found, property.type)
                             : static_cast<float>(found);
      }
    }
    mesh.positions.push_back({value[0], value[1], value[2]});
    if (hasNormals) mesh.normals.push_back({value[3], value[4], value[5]});
    if (!hasColors) continue;
    object.attributes.colors.push_back({value[red], value[red + 1], value[red + 2], 1});
    // Vertices of different colours are no duplicates.
    std::uint64_t tag = 0;
    for (std::size_t c = red; c < red + 3; ++c)
      mix(tag, std::uint64_t{std::bit_cast<std::uint32_t>(value[c])});
    mesh.tags.push_back(tag);
  }
  object.attributes.vertices = mesh.positions.size();
  if (!hasColors) return;
  object.opaque = mattMaterial({1, 1, 1});
  object.opaque->name = "vertex colours";
}

void skip(const PlyElement& element, Body& body) {
  if (element.properties.empty()) return;
  for (std::uint64_t item = 0; item < element.count; ++item) {
    for (const PlyProperty& property : element.properties) {
      const std::uint64_t count = property.listCount ? body.nextCount(property, element) : 1;
      for (std::uint64_t n = 0; n < count; ++n) body.next(property.type, element);
    }
  }
}

/// Corners of all faces, kept until the vertices are known: elements may stand in any order.
struct Faces {
  std::vector<std::uint32_t> corners;
  std::vector<std::uint32_t> sizes;
};

/// Calls onItem(number, indices) for each item of an element whose lists name vertices.
template <typename OnItem>
void readIndices(const Input& input, const PlyElement& element, Body& body, OnItem&& onItem) {
  const auto isIndices = [](const PlyProperty& p) {
    return p.listCount && (p.name == "vertex_indices" || p.name == "vertex_index");
  };
  const auto indices =
      std::find_if(element.properties.begin(), element.properties.end(), isIndices);
  if (indices == element.properties.end())
    failPly(input, fmt::format("its {} have no vertex_indices",
                               element.name == "face" ? "faces" : "triangle strips"));
  std::vector<double> values;
  for (std::uint64_t item = 0; item < element.count; ++item) {
    values.clear();
    for (const PlyProperty& property : element.properties) {
      const std::uint64_t count = property.listCount ? body.nextCount(property, element) : 1;
      for (std::uint64_t n = 0; n < count; ++n) {
        const double value = body.next(property.type, element);
        if (&property == &*indices) values.push_back(value);
      }
    }
    onItem(item, values);
  }
}

std::uint32_t vertexNamed(const Input& input, std::string_view what, std::uint64_t item,
                          double value) {
  if (!(value >= 0 && value < 4294967295.0) || value != std::floor(value))
    failPly(input, fmt::format("{} {} names vertex {}, which does not exist", what, item, value));
  return static_cast<std::uint32_t>(value);
}

void readFaces(const Input& input, const PlyElement& element, Body& body, Faces& faces) {
  readIndices(input, element, body, [&](std::uint64_t face, const std::vector<double>& values) {
    for (const double value : values)
      faces.corners.push_back(vertexNamed(input, "face", face, value));
    faces.sizes.push_back(static_cast<std::uint32_t>(values.size()));
  });
}

/// Strips as in the files of Stanford's scans: -1 ends one, and every other triangle is turned.
/// Triangles that name a vertex twice only lead to the next.
void readStrips(const Input& input, const PlyElement& element, Body& body, Faces& faces) {
  readIndices(input, element, body, [&](std::uint64_t item, const std::vector<double>& values) {
    std::array<std::uint32_t, 3> last{};
    std::size_t length = 0;
    for (const double value : values) {
      if (value == -1) {
        length = 0;
        continue;
      }
      last = {last[1], last[2], vertexNamed(input, "triangle strip", item, value)};
      const auto [a, b, c] = last;
      if (++length < 3 || a == b || b == c || c == a) continue;
      const bool isTurned = length % 2 == 0;
      faces.corners.insert(faces.corners.end(), {isTurned ? b : a, isTurned ? a : b, c});
      faces.sizes.push_back(3);
    }
  });
}

void buildTriangles(const Input& input, const Faces& faces, RawMesh& mesh) {
  Triangulator triangulator;
  std::span<const std::uint32_t> rest(faces.corners);
  for (std::size_t face = 0; face < faces.sizes.size(); ++face) {
    const auto corners = rest.first(faces.sizes[face]);
    rest = rest.subspan(corners.size());
    for (const std::uint32_t v : corners) {
      if (v >= mesh.positions.size()) {
        failPly(input, fmt::format("face {} names vertex {}, but there are {} vertices", face, v,
                                   mesh.positions.size()));
      }
    }
    triangulator.add(mesh, corners);
  }
}

void addNotShown(const PlyElement& element, bool colorsAreShown, std::vector<NotShown>& to) {
  const auto hasOneOf = [&](std::initializer_list<std::string_view> names) {
    return std::any_of(element.properties.begin(), element.properties.end(),
                       [&](const PlyProperty& p) {
                         return std::find(names.begin(), names.end(), p.name) != names.end();
                       });
  };
  if (!colorsAreShown && hasOneOf({"red", "r", "diffuse_red"}))
    scene::addNotShown(to, element.name + " colours", {});
  if (hasOneOf({"s", "u", "texture_u", "texcoord"})) {
    scene::addNotShown(to, "texture coordinates", {});
  }
}

}  // namespace

RawScene loadPly(const Input& input) {
  const PlyHeader header = parsePlyHeader(input);
  Body body(input, header);
  RawScene scene;
  RawObject object;
  object.name = cleanText(input.file.stem().string());
  object.medium = defaultMedium();
  Faces faces;
  bool sawVertices = false;
  bool sawFaces = false;
  bool sawStrips = false;
  for (const PlyElement& element : header.elements) {
    body.requireRoom(element);
    if (element.name == "vertex" && !sawVertices) {
      sawVertices = true;
      readVertices(input, element, body, object);
      addNotShown(element, object.opaque.has_value(), scene.notShown);
    } else if (element.name == "face" && !sawFaces) {
      sawFaces = true;
      readFaces(input, element, body, faces);
      addNotShown(element, false, scene.notShown);
    } else if (element.name == "tristrips" && !sawStrips) {
      sawStrips = true;
      readStrips(input, element, body, faces);
      addNotShown(element, false, scene.notShown);
    } else {
      skip(element, body);
      if (element.count > 0) scene::addNotShown(scene.notShown, "other elements", element.name);
    }
  }
  if (!sawVertices) failPly(input, "it has no vertices");
  if (!sawFaces && !sawStrips)
    failPly(input, "it has no faces; point clouds have no surface that can be rendered");
  buildTriangles(input, faces, object.mesh);
  startProvenance(object.mesh);
  scene.objects.push_back(std::move(object));
  return scene;
}

}  // namespace opaline::scene
