#include "families.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstring>
#include <iterator>
#include <numbers>
#include <random>

namespace opaline::bench {

namespace {

class Obj {
 public:
  void vertex(double x, double y, double z) {
    fmt::format_to(std::back_inserter(text_), "v {:.9g} {:.9g} {:.9g}\n", x, y, z);
    ++vertices_;
  }
  /// Vertices are counted from 1.
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    fmt::format_to(std::back_inserter(text_), "f {} {} {}\n", a, b, c);
  }
  std::uint32_t vertices() const { return vertices_; }
  std::string& text() { return text_; }

 private:
  std::string text_;
  std::uint32_t vertices_ = 0;
};

/// The edge of a square, or of a cube, with so many places.
std::uint32_t edgeOf(std::uint32_t count, double dimensions) {
  return 1 + static_cast<std::uint32_t>(std::pow(static_cast<double>(count), 1 / dimensions));
}

/// An ordinary mesh to compare the others with: an open hilly sheet.
std::string sheet(std::uint32_t count) {
  Obj obj;
  const std::uint32_t edge = edgeOf(count / 2, 2);
  for (std::uint32_t y = 0; y <= edge; ++y)
    for (std::uint32_t x = 0; x <= edge; ++x)
      obj.vertex(x, std::sin(9.0 * x / edge) * std::cos(7.0 * y / edge) * 0.1 * edge, y);
  for (std::uint32_t y = 0; y < edge; ++y)
    for (std::uint32_t x = 0; x < edge; ++x) {
      const std::uint32_t corner = 1 + x + y * (edge + 1);
      obj.triangle(corner, corner + edge + 2, corner + 1);
      obj.triangle(corner, corner + edge + 1, corner + edge + 2);
    }
  return obj.text();
}

/// Triangles around one vertex.
std::string fan(std::uint32_t count) {
  Obj obj;
  obj.vertex(0, 1, 0);
  for (std::uint32_t i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    obj.vertex(std::cos(angle), 0.1 * (i % 2), std::sin(angle));
  }
  for (std::uint32_t i = 0; i < count; ++i) obj.triangle(1, 2 + i, 2 + (i + 1) % count);
  return obj.text();
}

/// Triangles that share one edge.
std::string book(std::uint32_t count) {
  Obj obj;
  obj.vertex(0, 0, 0);
  obj.vertex(0, 1, 0);
  for (std::uint32_t i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    obj.vertex(std::cos(angle), 0.5, std::sin(angle));
    obj.triangle(1, 2, 3 + i);
  }
  return obj.text();
}

/// Parallel triangles, each a thousand times as long as wide.
std::string needles(std::uint32_t count) {
  Obj obj;
  for (std::uint32_t i = 0; i < count; ++i) {
    obj.vertex(0.001 * i, 0, 0);
    obj.vertex(0.001 * (i + 1), 0, 0);
    obj.vertex(0.001 * i, 1, 0.001 * (i % 7));
    obj.triangle(3 * i + 1, 3 * i + 2, 3 * i + 3);
  }
  return obj.text();
}

/// Random triangles between few places, each shared by many vertices.
std::string coincident(std::uint32_t count) {
  Obj obj;
  std::minstd_rand random(1);
  const std::uint32_t edge = edgeOf(count / 8, 3);
  for (std::uint32_t i = 0; i < count; ++i) {
    for (int corner = 0; corner < 3; ++corner)
      obj.vertex(static_cast<double>((random() >> 8U) % edge),
                 static_cast<double>((random() >> 8U) % edge),
                 static_cast<double>((random() >> 8U) % edge));
    obj.triangle(3 * i + 1, 3 * i + 2, 3 * i + 3);
  }
  return obj.text();
}

/// Separate tetrahedra.
std::string components(std::uint32_t count) {
  Obj obj;
  const std::uint32_t edge = edgeOf(count / 4, 3);
  for (std::uint32_t i = 0; i < count / 4; ++i) {
    const double x = 2.0 * (i % edge);
    const double y = 2.0 * (i / edge % edge);
    const std::uint32_t layer = i / edge / edge;
    const double z = 2.0 * layer;
    const std::uint32_t first = obj.vertices() + 1;
    obj.vertex(x, y, z);
    obj.vertex(x + 1, y, z);
    obj.vertex(x, y + 1, z);
    obj.vertex(x, y, z + 1);
    obj.triangle(first, first + 2, first + 1);
    obj.triangle(first, first + 1, first + 3);
    obj.triangle(first, first + 3, first + 2);
    obj.triangle(first + 1, first + 2, first + 3);
  }
  return obj.text();
}

/// One comb-shaped polygon.
std::string polygon(std::uint32_t count) {
  Obj obj;
  for (std::uint32_t i = 0; i < count; ++i) obj.vertex(i, i % 2 == 0 ? 1 : 100, 0);
  obj.vertex(count, 0, 0);
  obj.vertex(0, 0, 0);
  obj.text() += "f";
  for (std::uint32_t i = count + 2; i > 0; --i)
    fmt::format_to(std::back_inserter(obj.text()), " {}", i);
  obj.text() += "\n";
  return obj.text();
}

std::string word(std::size_t value) {
  const auto number = static_cast<std::uint32_t>(value);
  std::string bytes(4, '\0');
  std::memcpy(bytes.data(), &number, 4);
  return bytes;
}

/// A tetrahedron and the given nodes.
std::string glb(const std::string& nodes, const std::string& roots) {
  const std::array<float, 12> corners{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  const std::array<std::uint16_t, 12> faces{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  std::string binary(72, '\0');
  std::memcpy(binary.data(), corners.data(), 48);
  std::memcpy(binary.data() + 48, faces.data(), 24);
  std::string json = fmt::format(
      R"({{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[{}]}}],"nodes":[{}],"meshes":[)"
      R"({{"primitives":[{{"attributes":{{"POSITION":0}},"indices":1}}]}}],"accessors":[)"
      R"({{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"}},)"
      R"({{"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"}}],"bufferViews":[)"
      R"({{"buffer":0,"byteLength":48}},{{"buffer":0,"byteOffset":48,"byteLength":24}}],)"
      R"("buffers":[{{"byteLength":72}}]}})",
      roots, nodes);
  json.resize((json.size() + 3) / 4 * 4, ' ');
  return "glTF" + word(2) + word(28 + json.size() + binary.size()) + word(json.size()) + "JSON" +
         json + word(binary.size()) + std::string("BIN\0", 4) + binary;
}

/// Nodes that each are the only child of the previous one.
std::string chain(std::uint32_t count) {
  std::string nodes;
  for (std::uint32_t i = 0; i + 1 < count; ++i)
    fmt::format_to(std::back_inserter(nodes),
                   R"({{"children":[{}],"translation":[0.1,0,0],"rotation":[0,0,0.6,0.8]}},)",
                   i + 1);
  return glb(nodes + R"({"mesh":0})", "0");
}

/// Nodes that all show the same mesh.
std::string instances(std::uint32_t count) {
  std::string nodes;
  std::string roots;
  for (std::uint32_t i = 0; i < count / 4; ++i) {
    const char* comma = i == 0 ? "" : ",";
    fmt::format_to(std::back_inserter(nodes), R"({}{{"mesh":0,"translation":[{},{},0]}})", comma,
                   2 * (i % 256), 2 * (i / 256));
    fmt::format_to(std::back_inserter(roots), "{}{}", comma, i);
  }
  return glb(nodes, roots);
}

}  // namespace

const std::vector<Family>& families() {
  static const std::vector<Family> all{
      {"sheet", ".obj", sheet},
      {"fan", ".obj", fan},
      {"book", ".obj", book},
      {"needles", ".obj", needles},
      {"coincident", ".obj", coincident},
      {"components", ".obj", components},
      {"polygon", ".obj", polygon},
      {"chain", ".glb", chain},
      {"instances", ".glb", instances},
  };
  return all;
}

}  // namespace opaline::bench
