#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "opaline/scene.h"
#include "opaline/scene_file.h"
#include "scene/shapes.h"

namespace opaline {

/// Scene files next to a model.
class Toml : public testing::Test {
 protected:
  Toml() {
    // A cube from (1,0,0) to (2,1,1).
    std::string cube =
        "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\n"
        "property float y\nproperty float z\nelement face 12\n"
        "property list uchar int vertex_indices\nend_header\n";
    const scene::RawMesh mesh = test::cube({1, 0, 0});
    for (const Vec3& p : mesh.positions) {
      for (const float x : p) cube += std::to_string(x) + " ";
    }
    for (const Triangle& t : mesh.triangles) {
      cube += "\n3";
      for (const std::uint32_t v : t) cube += " " + std::to_string(v);
    }
    test::writeBytes(folder / "cube.ply", cube);
  }
  LoadedScene load(const std::string& text, const LoadOptions& options = {}) {
    test::writeBytes(folder / "a.toml", text);
    return loadSceneFile(folder / "a.toml", options);
  }
  std::string errorOf(const std::string& text) {
    std::string message = test::messageOf([&] { load(text); });
    EXPECT_THAT(message, testing::HasSubstr("a.toml"));
    return message;
  }
  test::TemporaryFolder folder;
};

/// A cube of edge 10 mm.
inline const std::string model = "model = 'cube.ply'\ndiagonal_mm = 17.3205081\n";

}  // namespace opaline
