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
#include "scene/mesh/triangulate.h"
#include "scene/not_shown.h"
#include "scene/rig.h"
#include "scene/text.h"

// The format: G. Turk, "The PLY Polygon File Format", 1994.

namespace opaline::scene {

namespace {

enum class Encoding { Ascii, Little, Big };
enum class Scalar { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };

std::size_t sizeOf(Scalar type) {
  constexpr std::array<std::size_t, 8> sizes{1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

struct Property {
  std::string name;
  Scalar type = Scalar::Float32;
  std::optional<Scalar> listCount;
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
};

[[noreturn]] void fail(const Input& input, const std::string& reason) {
  throw Error(fmt::format("{}: {}", cleanText(input.file.string(), 1000), reason));
}

std::vector<std::string_view> words(std::string_view line) {
  std::vector<std::string_view> result;
  while (true) {
    const std::size_t begin = line.find_first_not_of(" \t\r");
    if (begin == std::string_view::npos) return result;
    line.remove_prefix(begin);
    const std::size_t end = std::min(line.find_first_of(" \t\r"), line.size());
    result.push_back(line.substr(0, end));
    line.remove_prefix(end);
  }
}

std::optional<Scalar> scalarNamed(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, Scalar>, 16> names{{
      {"char", Scalar::Int8},
      {"int8", Scalar::Int8},
      {"uchar", Scalar::Uint8},
      {"uint8", Scalar::Uint8},
      {"short", Scalar::Int16},
      {"int16", Scalar::Int16},
      {"ushort", Scalar::Uint16},
      {"uint16", Scalar::Uint16},
      {"int", Scalar::Int32},
      {"int32", Scalar::Int32},
      {"uint", Scalar::Uint32},
      {"uint32", Scalar::Uint32},
      {"float", Scalar::Float32},
      {"float32", Scalar::Float32},
      {"double", Scalar::Float64},
      {"float64", Scalar::Float64},
  }};
  for (const auto& [known, type] : names) {
    if (known == name) return type;
  }
  return std::nullopt;
}

struct Header {
  Encoding encoding = Encoding::Ascii;
  std::vector<Element> elements;
  std::size_t bytes = 0;
};

Property parseProperty(const Input& input, const std::vector<std::string_view>& line) {
  Property property;
  if (line.size() == 5 && line[1] == "list") {
    const auto count = scalarNamed(line[2]);
    const auto type = scalarNamed(line[3]);
    if (count && type && *count < Scalar::Float32) {
      return {std::string(line[4]), *type, *count};
    }
  } else if (line.size() == 3) {
    if (const auto type = scalarNamed(line[1])) return {std::string(line[2]), *type, std::nullopt};
  }
  fail(input, "the PLY header declares a property of a kind that does not exist");
}

Element parseElement(const Input& input, const std::vector<std::string_view>& line) {
  Element element;
  if (line.size() != 3) fail(input, "the PLY header has an incomplete element line");
  element.name = line[1];
  const char* end = line[2].data() + line[2].size();
  const auto [stop, problem] = std::from_chars(line[2].data(), end, element.count);
  if (problem != std::errc{} || stop != end) {
    fail(input, fmt::format("the PLY header gives '{}' as the number of '{}'",
                            cleanText(line[2], 40), cleanText(element.name, 40)));
  }
  return element;
}

Header parseHeader(const Input& input) {
  constexpr std::size_t longestHeader = 1U << 20U;
  const std::string_view text(reinterpret_cast<const char*>(input.bytes.data()),
                              std::min(input.bytes.size(), longestHeader));
  Header header;
  std::size_t at = 0;
  bool sawFormat = false;
  bool pairs = false;
  for (std::size_t lineNumber = 0;; ++lineNumber) {
    // Line ends are \n, \r\n or, in files from old Macintoshes, \r.
    const std::size_t end = text.find_first_of("\r\n", at);
    if (end == std::string_view::npos) {
      fail(input, lineNumber == 0 ? "this is not a PLY file" : "the PLY header has no end");
    }
    const std::vector<std::string_view> line = words(text.substr(at, end - at));
    at = end + 1;
    // Decided once, at the first line: after a lone \r the first byte of the body may be a
    // .
    if (lineNumber == 0) pairs = text.substr(end).starts_with("\r\n");
    if (pairs && text.substr(end).starts_with("\r\n")) ++at;
    if (lineNumber == 0) {
      if (line.size() != 1 || line[0] != "ply") fail(input, "this is not a PLY file");
      continue;
    }
    if (line.empty() || line[0] == "comment" || line[0] == "obj_info") continue;
    if (line[0] == "end_header") break;
    if (line[0] == "format" && line.size() == 3) {
      sawFormat = true;
      if (line[1] == "ascii") {
        header.encoding = Encoding::Ascii;
      } else if (line[1] == "binary_little_endian") {
        header.encoding = Encoding::Little;
      } else if (line[1] == "binary_big_endian") {
        header.encoding = Encoding::Big;
      } else {
        fail(input, fmt::format("the PLY format '{}' does not exist", cleanText(line[1], 40)));
      }
    } else if (line[0] == "element") {
      header.elements.push_back(parseElement(input, line));
    } else if (line[0] == "property" && !header.elements.empty()) {
      header.elements.back().properties.push_back(parseProperty(input, line));
    } else {
      fail(input, fmt::format("line {} of the PLY header is '{}', but a format, an element, or a "
                              "property of an element must stand there",
                              lineNumber + 1, cleanText(std::string(line[0]), 40)));
    }
  }
  if (!sawFormat) fail(input, "the PLY header names no format");
  header.bytes = at;
  return header;
}

/// Reads value after value from the body.
class Body {
 public:
  Body(const Input& input, const Header& header)
      : input_(input), rest_(input.bytes.subspan(header.bytes)), encoding_(header.encoding) {}

  /// Throws Error unless the file has room for `element`: every item takes some bytes.
  void requireRoom(const Element& element) const {
    std::uint64_t least = 0;
    for (const Property& property : element.properties) {
      least +=
          encoding_ == Encoding::Ascii ? 2 : sizeOf(property.listCount.value_or(property.type));
    }
    // The last number of a text needs no separator after it.
    const std::uint64_t room = rest_.size() + (encoding_ == Encoding::Ascii ? 1 : 0);
    if (least > 0 && element.count > room / least) truncated(element);
  }

  /// A number as it stands in the file; counts and indices come out exact.
  double next(Scalar type, const Element& element) {
    return encoding_ == Encoding::Ascii ? nextText(element) : nextBinary(type, element);
  }

  std::uint64_t nextCount(const Property& property, const Element& element) {
    const double count = next(*property.listCount, element);
    if (!(count >= 0) || count != std::floor(count)) {
      fail(input_,
           fmt::format("a list of '{}' has {} entries", cleanText(element.name, 40), count));
    }
    const std::size_t least = encoding_ == Encoding::Ascii ? 2 : sizeOf(property.type);
    const std::size_t room = rest_.size() + (encoding_ == Encoding::Ascii ? 1 : 0);
    const std::size_t most = room / least;
    if (count > static_cast<double>(most)) truncated(element);
    return static_cast<std::uint64_t>(count);
  }

 private:
  [[noreturn]] void truncated(const Element& element) const {
    const std::string many = element.name == "vertex" ? "vertices"
                             : element.name == "face"
                                 ? "faces"
                                 : fmt::format("'{}' elements", cleanText(element.name, 40));
    fail(input_, fmt::format("the file ends before all of its {} {}; it is damaged or incomplete",
                             element.count, many));
  }

  double nextText(const Element& element) {
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
      fail(input_, fmt::format("'{}' in element '{}' is not a number", cleanText(word, 40),
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
    if ((encoding_ == Encoding::Big) != hostIsBig) std::reverse(bytes.begin(), bytes.end());
    return static_cast<double>(std::bit_cast<T>(bytes));
  }

  double nextBinary(Scalar type, const Element& element) {
    if (rest_.size() < sizeOf(type)) truncated(element);
    switch (type) {
      case Scalar::Int8:
        return take<std::int8_t>();
      case Scalar::Uint8:
        return take<std::uint8_t>();
      case Scalar::Int16:
        return take<std::int16_t>();
      case Scalar::Uint16:
        return take<std::uint16_t>();
      case Scalar::Int32:
        return take<std::int32_t>();
      case Scalar::Uint32:
        return take<std::uint32_t>();
      case Scalar::Float32:
        return take<float>();
      case Scalar::Float64:
        return take<double>();
    }
    return 0;
  }

  const Input& input_;
  std::span<const std::byte> rest_;
  Encoding encoding_;
};

/// Whole numbers are sRGB, others linear.
float linearColor(double value, Scalar type) {
  const std::size_t bytes = sizeOf(type);
  if (bytes > 2) return static_cast<float>(value > 0 ? std::min(value, 1.0) : 0.0);
  const double most = bytes == 1 ? 255 : 65535;
  return decodeSrgb(static_cast<float>(std::clamp(value / most, 0.0, 1.0)));
}

void readVertices(const Input& input, const Element& element, Body& body, RawObject& object) {
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
  if (!have[0] || !have[1] || !have[2]) fail(input, "its vertices have no x, y and z");
  if (element.count > 0xFFFFFFFEU) fail(input, "it has more vertices than 32-bit indices can name");
  const bool hasNormals = have[3] && have[4] && have[5];
  const bool hasColors = have[red] && have[red + 1] && have[red + 2];
  mesh.positions.reserve(element.count);
  if (hasNormals) mesh.normals.reserve(element.count);
  for (std::uint64_t v = 0; v < element.count; ++v) {
    std::array<float, names.size() + 1> value{};
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const Property& property = element.properties[i];
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

void skip(const Element& element, Body& body) {
  if (element.properties.empty()) return;
  for (std::uint64_t item = 0; item < element.count; ++item) {
    for (const Property& property : element.properties) {
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
void readIndices(const Input& input, const Element& element, Body& body, OnItem&& onItem) {
  const auto isIndices = [](const Property& p) {
    return p.listCount && (p.name == "vertex_indices" || p.name == "vertex_index");
  };
  const auto indices =
      std::find_if(element.properties.begin(), element.properties.end(), isIndices);
  if (indices == element.properties.end())
    fail(input, fmt::format("its {} have no vertex_indices",
                            element.name == "face" ? "faces" : "triangle strips"));
  std::vector<double> values;
  for (std::uint64_t item = 0; item < element.count; ++item) {
    values.clear();
    for (const Property& property : element.properties) {
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
    fail(input, fmt::format("{} {} names vertex {}, which does not exist", what, item, value));
  return static_cast<std::uint32_t>(value);
}

void readFaces(const Input& input, const Element& element, Body& body, Faces& faces) {
  readIndices(input, element, body, [&](std::uint64_t face, const std::vector<double>& values) {
    for (const double value : values)
      faces.corners.push_back(vertexNamed(input, "face", face, value));
    faces.sizes.push_back(static_cast<std::uint32_t>(values.size()));
  });
}

/// Strips as in the files of Stanford's scans: -1 ends one, and every other triangle is turned.
/// Triangles that name a vertex twice only lead to the next.
void readStrips(const Input& input, const Element& element, Body& body, Faces& faces) {
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
        fail(input, fmt::format("face {} names vertex {}, but there are {} vertices", face, v,
                                mesh.positions.size()));
      }
    }
    triangulator.add(mesh, corners);
  }
}

void addNotShown(const Element& element, bool colorsAreShown, std::vector<NotShown>& to) {
  const auto hasOneOf = [&](std::initializer_list<std::string_view> names) {
    return std::any_of(element.properties.begin(), element.properties.end(),
                       [&](const Property& p) {
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
  const Header header = parseHeader(input);
  Body body(input, header);
  RawScene scene;
  RawObject object;
  object.name = cleanText(input.file.stem().string());
  object.medium = defaultMedium();
  Faces faces;
  bool sawVertices = false;
  bool sawFaces = false;
  bool sawStrips = false;
  for (const Element& element : header.elements) {
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
  if (!sawVertices) fail(input, "it has no vertices");
  if (!sawFaces && !sawStrips)
    fail(input, "it has no faces; point clouds have no surface that can be rendered");
  buildTriangles(input, faces, object.mesh);
  startProvenance(object.mesh);
  scene.objects.push_back(std::move(object));
  return scene;
}

}  // namespace opaline::scene
