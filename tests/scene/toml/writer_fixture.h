#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "opaline/scene.h"
#include "opaline/scene_file.h"
#include "scene/gltf/glb.h"
#include "scene/random_scene.h"
#include "scene/shapes.h"

namespace opaline {

namespace fs = std::filesystem;

inline const std::vector<std::string> names{"plain", "dots.and\"quotes\"\\'", "bär🐻]{[x"};

inline std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result;
}

/// A row of 10 mm cubes, one per name.
inline std::string rowOfCubes(const std::vector<std::string>& objects) {
  const scene::RawMesh mesh = test::cube({0, 0, 0}, 0.01F);
  std::string binary;
  for (const Vec3& p : mesh.positions) binary += test::raw<float>({p[0], p[1], p[2]});
  for (const Triangle& t : mesh.triangles) binary += test::raw<std::uint32_t>({t[0], t[1], t[2]});
  std::string nodes;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    nodes += (i > 0 ? R"(,{"mesh":0,"name":")" : R"({"mesh":0,"name":")") + escaped(objects[i]) +
             R"(","translation":[)" + std::to_string(0.023 * static_cast<double>(i)) + ",0.1," +
             std::to_string(-0.0071 * static_cast<double>(i)) + "]}";
  }
  return test::glb(
      R"({"asset":{"version":"2.0"},"nodes":[)" + nodes +
          R"(],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],"accessors":[)"
          R"({"bufferView":0,"componentType":5126,"count":8,"type":"VEC3"},)"
          R"({"bufferView":1,"componentType":5125,"count":36,"type":"SCALAR"}],"bufferViews":[)"
          R"({"buffer":0,"byteLength":96},{"buffer":0,"byteOffset":96,"byteLength":144}],)"
          R"("buffers":[{"byteLength":240}]})",
      binary);
}

/// Scenes of cubes with awkward names, written and loaded again.
class SceneWriter : public testing::Test {
 protected:
  SceneWriter() {
    fs::create_directories(folder / "models");
    fs::create_directories(folder / "scenes" / "mine");
    test::writeBytes(model(), rowOfCubes(names));
  }
  fs::path model() const { return folder / "models" / "cubes.glb"; }
  fs::path file() const { return folder / "scenes" / "mine" / "a.toml"; }

  std::string written(const SceneDescription& description) {
    writeScene(file(), description);
    return test::readBytes(file());
  }
  std::string written(const LoadedScene& loaded) {
    return written(describe(loaded.scene, loaded.source, loaded.settings));
  }
  LoadedScene back() { return loadSceneFile(file()); }
  std::string complaint(const LoadedScene& loaded) {
    return test::messageOf([&] { written(loaded); });
  }

  LoadedScene random(unsigned seed) {
    return test::randomScene(seed, model(), folder / "sky \"1\".exr");
  }

  test::TemporaryFolder folder;
};

}  // namespace opaline
