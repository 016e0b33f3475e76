#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "opaline/scene.h"
#include "scene/gltf/glb.h"
#include "scene/shapes.h"

namespace opaline::test {

/// A tetrahedron of floats: 48 bytes of positions, followed by 12 indices of 16 bits.
inline const std::vector<float> tetrahedron{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
inline const std::vector<std::uint16_t> tetrahedronFaces{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};

inline std::string tetrahedronBytes() {
  return raw(tetrahedron) + raw(tetrahedronFaces);
}

/// The text with the first occurrence of `piece`, which must exist, replaced.
inline std::string changed(std::string text, const std::string& piece, const std::string& to) {
  const std::size_t at = text.find(piece);
  EXPECT_NE(at, std::string::npos) << piece;
  return at == std::string::npos ? text : text.replace(at, piece.size(), to);
}

/// Parts of a file around the tetrahedron; tests replace single ones.
struct Parts {
  std::string nodes = R"({"mesh":0,"name":"tetra"})";
  std::string meshes = R"({"primitives":[{"attributes":{"POSITION":0},"indices":1}]})";
  std::string accessors =
      R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},
         {"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"})";
  std::string views = R"({"buffer":0,"byteOffset":0,"byteLength":48},
                         {"buffer":0,"byteOffset":48,"byteLength":24})";
  std::string buffers = R"({"byteLength":72})";
  std::string scene = R"("scene":0,"scenes":[{"nodes":[0]}],)";
  std::string more{};

  std::string json() const {
    return R"({"asset":{"version":"2.0"},)" + scene + R"("nodes":[)" + nodes + R"(],"meshes":[)" +
           meshes + R"(],"accessors":[)" + accessors + R"(],"bufferViews":[)" + views +
           R"(],"buffers":[)" + buffers + "]" + more + "}";
  }
};

class Gltf : public testing::Test {
 protected:
  Scene loadBytes(const std::string& bytes, const LoadOptions& options = {}) {
    writeBytes(folder / "a.glb", bytes);
    return loadScene(folder / "a.glb", options);
  }
  Scene load(const Parts& parts, const std::string& binary = tetrahedronBytes()) {
    LoadOptions options;
    options.log = [&](LogLevel, std::string_view message) { notes.emplace_back(message); };
    return loadBytes(glb(parts.json(), binary), options);
  }
  std::string errorOf(const Parts& parts, const std::string& binary = tetrahedronBytes()) {
    std::string message = messageOf([&] { load(parts, binary); });
    EXPECT_THAT(message, testing::HasSubstr("a.glb"));
    EXPECT_LT(message.size(), 500U);
    return message;
  }
  static double volumeMm3(const Scene& scene) {
    double sum = 0;
    for (const Object& object : scene.objects) {
      sum += signedVolume(object.mesh.positionsMm, object.mesh.triangles);
    }
    return sum;
  }
  TemporaryFolder folder;
  std::vector<std::string> notes;
};

}  // namespace opaline::test
