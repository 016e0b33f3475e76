// KHR_draco_mesh_compression. The streams are made by Draco's encoder.

#include <draco/compression/encode.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "opaline/error.h"
#include "scene/gltf/gltf_fixture.h"

namespace opaline {
namespace {

using test::changed;
using test::Gltf;
using test::Parts;
using testing::HasSubstr;

constexpr int rings = 12;
constexpr int sectors = 16;

/// A torus of radii 3 and 1 m: closed, smooth, every vertex of six triangles.
struct Torus {
  std::vector<std::array<float, 3>> positions;
  std::vector<std::array<float, 3>> normals;
  std::vector<std::array<std::uint16_t, 4>> weights;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

Torus torus() {
  Torus made;
  const auto at = [](int ring, int sector) {
    return static_cast<std::uint32_t>(ring % rings * sectors + sector % sectors);
  };
  for (int r = 0; r < rings; ++r) {
    for (int s = 0; s < sectors; ++s) {
      const double u = 2 * M_PI * r / rings;
      const double v = 2 * M_PI * s / sectors;
      const std::array<double, 3> n{std::cos(u) * std::cos(v), std::sin(v),
                                    -std::sin(u) * std::cos(v)};
      made.normals.push_back(
          {static_cast<float>(n[0]), static_cast<float>(n[1]), static_cast<float>(n[2])});
      made.positions.push_back({static_cast<float>(3 * std::cos(u) + n[0]),
                                static_cast<float>(n[1]),
                                static_cast<float>(-3 * std::sin(u) + n[2])});
      made.weights.push_back({65535, 0, 0, static_cast<std::uint16_t>(r * 100 + s)});
      made.triangles.push_back({at(r, s), at(r + 1, s), at(r, s + 1)});
      made.triangles.push_back({at(r + 1, s), at(r + 1, s + 1), at(r, s + 1)});
    }
  }
  return made;
}

template <typename T, std::size_t Components>
void addAttribute(draco::Mesh& mesh, draco::GeometryAttribute::Type type, draco::DataType dataType,
                  const std::vector<std::array<T, Components>>& values) {
  draco::GeometryAttribute attribute;
  attribute.Init(type, nullptr, Components, dataType, false, sizeof(values[0]), 0);
  const int id = mesh.AddAttribute(attribute, true, static_cast<std::uint32_t>(values.size()));
  for (std::uint32_t i = 0; i < values.size(); ++i) {
    mesh.attribute(id)->SetAttributeValue(draco::AttributeValueIndex(i), values[i].data());
  }
}

struct Encoding {
  draco::MeshEncoderMethod method = draco::MESH_EDGEBREAKER_ENCODING;
  int speed = 5;
  int positionBits = 0;  ///< 0: all bits
  bool attributes = true;
};

std::string encoded(const Torus& torus, const Encoding& how) {
  draco::Mesh mesh;
  mesh.set_num_points(static_cast<std::uint32_t>(torus.positions.size()));
  for (const auto& t : torus.triangles) {
    mesh.AddFace({draco::PointIndex(t[0]), draco::PointIndex(t[1]), draco::PointIndex(t[2])});
  }
  addAttribute(mesh, draco::GeometryAttribute::POSITION, draco::DT_FLOAT32, torus.positions);
  if (how.attributes) {
    addAttribute(mesh, draco::GeometryAttribute::NORMAL, draco::DT_FLOAT32, torus.normals);
    addAttribute(mesh, draco::GeometryAttribute::GENERIC, draco::DT_UINT16, torus.weights);
  }
  draco::Encoder encoder;
  encoder.SetEncodingMethod(how.method);
  encoder.SetSpeedOptions(how.speed, how.speed);
  if (how.positionBits > 0) {
    encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, how.positionBits);
  }
  draco::EncoderBuffer buffer;
  EXPECT_TRUE(encoder.EncodeMeshToBuffer(mesh, &buffer).ok());
  return {buffer.data(), buffer.size()};
}

constexpr const char* compression =
    R"("extensions":{"KHR_draco_mesh_compression":{"bufferView":0,"attributes":{"POSITION":0,)"
    R"("NORMAL":1,"_WEIGHTS":2}}})";

Parts partsOf(const std::string& stream) {
  constexpr int vertices = rings * sectors;
  Parts parts;
  parts.meshes = fmt::format(
      R"({{"primitives":[{{"attributes":{{"POSITION":0,"NORMAL":1,"_WEIGHTS":2}},"indices":3,)"
      R"("mode":4,{}}}]}})",
      compression);
  parts.accessors =
      fmt::format(R"({{"componentType":5126,"count":{0},"type":"VEC3"}},)"
                  R"({{"componentType":5126,"count":{0},"type":"VEC3"}},)"
                  R"({{"componentType":5123,"count":{0},"type":"VEC4","normalized":true}},)"
                  R"({{"componentType":5123,"count":{1},"type":"SCALAR"}})",
                  vertices, 6 * vertices);
  parts.views = fmt::format(R"({{"buffer":0,"byteLength":{}}})", stream.size());
  parts.buffers = fmt::format(R"({{"byteLength":{}}})", (stream.size() + 3) / 4 * 4);
  parts.more = R"(,"extensionsUsed":["KHR_draco_mesh_compression"],)"
               R"("extensionsRequired":["KHR_draco_mesh_compression"])";
  return parts;
}

class Draco : public Gltf {
 protected:
  std::string errorOfStream(const std::string& stream) { return errorOf(partsOf(stream), stream); }
};

/// The largest errors in mm of a vertex and of its normal, compared with the torus.
std::array<double, 2> errorsOf(const Mesh& mesh, const Torus& torus) {
  std::array<double, 2> largest{};
  for (std::size_t v = 0; v < mesh.positionsMm.size(); ++v) {
    double nearest = 1e30;
    double normal = 0;
    for (std::size_t i = 0; i < torus.positions.size(); ++i) {
      double distance = 0;
      double turned = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        distance += std::pow(mesh.positionsMm[v][c] - 1000.0 * torus.positions[i][c], 2);
        turned += std::pow(mesh.normals[v][c] - torus.normals[i][c], 2);
      }
      if (distance >= nearest) continue;
      nearest = distance;
      normal = turned;
    }
    largest[0] = std::max(largest[0], std::sqrt(nearest));
    largest[1] = std::max(largest[1], std::sqrt(normal));
  }
  return largest;
}

TEST_F(Draco, GivesTheMeshThatWasEncoded) {
  const Torus made = torus();
  double volume = 0;
  for (const auto method : {draco::MESH_SEQUENTIAL_ENCODING, draco::MESH_EDGEBREAKER_ENCODING}) {
    for (const int speed : {0, 5, 10}) {
      for (const int bits : {0, 14}) {
        const std::string stream = encoded(made, {method, speed, bits});
        const Scene scene = load(partsOf(stream), stream);
        test::expectSound(scene);
        ASSERT_EQ(scene.objects.size(), 1U);
        const Mesh& mesh = scene.objects[0].mesh;
        EXPECT_EQ(mesh.triangles.size(), made.triangles.size());
        EXPECT_EQ(mesh.positionsMm.size(), made.positions.size());
        // Half a step along each axis; a step is the longest side of the box, 8 m, by 2^bits − 1.
        const double step = bits == 0 ? 0 : 8000.0 / ((1 << bits) - 1);
        const auto [distance, normal] = errorsOf(mesh, made);
        EXPECT_LE(distance, std::sqrt(0.75) * step + 1e-3);  // plus rounding to 32 bits
        EXPECT_LE(normal, 1e-6);
        if (volume == 0) volume = volumeMm3(scene);
        EXPECT_NEAR(volumeMm3(scene) / volume, 1, 1e-4);
        EXPECT_TRUE(scene.repairs.empty());
      }
    }
  }
  // A torus has 2 π² R r². Polygons of n corners have n sin(2π/n) / 2π of a circle's area, which is
  // 0.955 along the rings and 0.974 along the sectors.
  EXPECT_NEAR(volume / (2e9 * M_PI * M_PI * 3), 0.955 * 0.974, 0.005);
}

TEST_F(Draco, NeedsNoIndicesAndReadsOtherAttributesAsUsual) {
  const std::string stream = encoded(torus(), {.attributes = false});
  Parts parts = partsOf(stream);
  parts.meshes = R"({"primitives":[{"attributes":{"POSITION":0,"_OTHER":3},"mode":5,"extensions":{
      "KHR_draco_mesh_compression":{"bufferView":0,"attributes":{"POSITION":0}}}}]})";
  EXPECT_EQ(load(parts, stream).objects[0].mesh.triangles.size(), 6U * rings * sectors / 3);
}

TEST_F(Draco, StreamsThatEndEarlyAreErrors) {
  for (const auto method : {draco::MESH_SEQUENTIAL_ENCODING, draco::MESH_EDGEBREAKER_ENCODING}) {
    const std::string stream = encoded(torus(), {method, 5, 11});
    for (std::size_t size = 0; size < stream.size(); size += 1 + size / 16) {
      EXPECT_THAT(errorOfStream(stream.substr(0, size) + std::string(size == 0, ' ')),
                  HasSubstr("the Draco stream of mesh 0"))
          << size;
    }
  }
}

TEST_F(Draco, DamagedStreamsLoadSoundlyOrAreRefused) {
  const char* wanted = std::getenv("OPALINE_MUTATIONS");
  const int count = wanted != nullptr ? std::atoi(wanted) : 200;
  std::mt19937 random(20081213);
  for (const auto method : {draco::MESH_SEQUENTIAL_ENCODING, draco::MESH_EDGEBREAKER_ENCODING}) {
    for (const int speed : {0, 10}) {
      const std::string stream = encoded(torus(), {method, speed, 11});
      for (int i = 0; i < count; ++i) {
        std::string damaged = stream;
        for (std::size_t n = 1 + random() % 3; n-- > 0;) {
          // Half of the changes hit the beginning, which holds sizes and methods.
          const std::size_t end = random() % 2 == 0 ? 64 : damaged.size();
          damaged[11 + random() % (end - 11)] = static_cast<char>(random());
        }
        try {
          test::expectSound(load(partsOf(damaged), damaged));
        } catch (const Error& error) {
          ASSERT_THAT(error.what(), HasSubstr("a.glb"));
        }
        ASSERT_FALSE(HasFailure()) << i;
      }
    }
  }
}

TEST_F(Draco, HeadersAreNotBelieved) {
  // Draco bitstream 2.2: five letters, version, kind, method and flags precede the numbers of
  // vertices and triangles, seven bits per byte. Edgebreaker's traversal type precedes those.
  std::string stream = encoded(torus(), {draco::MESH_SEQUENTIAL_ENCODING});
  EXPECT_THAT(errorOfStream(stream.substr(0, 11) + "\xFF\xFF\xFF\xFF\x0F" + stream.substr(13)),
              HasSubstr("promises 4294967295 triangles"));
  EXPECT_THAT(errorOfStream(stream.substr(0, 13) + "\xFF\xFF\xFF\xFF\x0F" + stream.substr(15)),
              HasSubstr("4294967295 vertices"));
  stream = encoded(torus(), {draco::MESH_EDGEBREAKER_ENCODING});
  EXPECT_THAT(errorOfStream(stream.substr(0, 12) + "\xFF\xFF\xFF\xFF\x0F" + stream.substr(14)),
              HasSubstr("4294967295 vertices"));
  EXPECT_THAT(errorOfStream(stream.substr(0, 14) + "\xFF\xFF\xFF\xFF\x0F" + stream.substr(16)),
              HasSubstr("promises 4294967295 triangles"));
  stream[7] = 0;
  EXPECT_THAT(errorOfStream(stream), HasSubstr("holds no triangles"));
  stream[6] = 1;
  EXPECT_THAT(errorOfStream(stream), HasSubstr("version 2.1, but glTF has 2.2"));
  stream[0] = 'T';
  EXPECT_THAT(errorOfStream(stream), HasSubstr("damaged"));
}

TEST_F(Draco, PrimitivesThatDoNotFitTheirStreamAreErrors) {
  const std::string stream = encoded(torus(), {});
  const auto errorWith = [&](const std::string& old, const std::string& by) {
    Parts parts = partsOf(stream);
    parts.meshes = changed(parts.meshes, old, by);
    return errorOf(parts, stream);
  };
  EXPECT_THAT(errorWith(R"("bufferView":0)", R"("bufferView":7)"), HasSubstr("no buffer view"));
  EXPECT_THAT(errorWith(R"("bufferView":0)", R"("view":0)"), HasSubstr("no buffer view"));
  EXPECT_THAT(errorWith(R"("mode":4)", R"("mode":1)"), HasSubstr("mode 1"));
  EXPECT_THAT(errorWith(R"("NORMAL":1,"_WEIGHTS":2}}})", R"("NORMAL":9,"_WEIGHTS":2}}})"),
              HasSubstr("does not hold its NORMAL"));
  EXPECT_THAT(errorWith(R"("NORMAL":1,"_WEIGHTS":2}}})", R"("NORMAL":2,"_WEIGHTS":2}}})"),
              HasSubstr("NORMAL in the Draco stream of mesh 0 do not fit accessor 1"));
  EXPECT_THAT(errorWith(R"({"POSITION":0)", R"({"POSITION":99)"), HasSubstr("accessor 99"));
  Parts parts = partsOf(stream);
  parts.views = changed(parts.views, R"("buffer":0)", R"("buffer":0,"byteOffset":5)");
  EXPECT_THAT(errorOf(parts, stream), HasSubstr("beyond the end of its compressed buffer"));
}

}  // namespace
}  // namespace opaline
