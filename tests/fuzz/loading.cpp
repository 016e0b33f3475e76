#include "loading.h"

#include <gtest/gtest.h>
#include <stb_image_write.h>

#include <span>

#include "deform/deformed_vertices.h"
#include "opaline/error.h"
#include "scene/finish.h"
#include "scene/shapes.h"

namespace opaline::fuzz {

namespace {

std::string cubePly(float edge) {
  std::string text =
      "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\n"
      "property float z\nelement face 12\nproperty list uchar int vertex_indices\nend_header\n";
  const scene::RawMesh mesh = test::cube({0, 0, 0}, edge);
  for (const Vec3& p : mesh.positions)
    for (const float x : p) text += std::to_string(x) + " ";
  for (const Triangle& t : mesh.triangles) {
    text += "\n3";
    for (const std::uint32_t v : t) text += " " + std::to_string(v);
  }
  return text;
}

void append(void* to, void* data, int size) {
  static_cast<std::string*>(to)->append(static_cast<const char*>(data),
                                        static_cast<std::size_t>(size));
}

std::string texturePng() {
  const std::array<std::uint8_t, 16> pixels{255, 0, 0, 255, 0, 255, 0, 128, 0, 0, 255, 0, 9, 9, 9};
  std::string bytes;
  stbi_write_png_to_func(append, &bytes, 2, 2, 4, pixels.data(), 8);
  return bytes;
}

/// At rest, inside, and far beyond the end.
void move(const Scene& scene) {
  constexpr std::size_t enough = 4;
  for (std::size_t object = 0; object < std::min(enough, scene.objects.size()); ++object)
    for (int clip = -1; clip < static_cast<int>(std::min(enough, scene.clips.size())); ++clip)
      for (const double seconds : {0.0, 0.3, 1e6})
        EXPECT_EQ(deform::deformedVertices(scene, object, clip, seconds).positionsMm.size(),
                  scene.objects[object].mesh.positionsMm.size());
}

}  // namespace

void writeNeighbours() {
  static const bool once = [] {
    fileOf("cube.ply", cubePly(1));
    fileOf("cube_1.ply", cubePly(1));
    fileOf("cube_2.ply", cubePly(2));
    fileOf("texture.png", texturePng());
    fileOf("sky.hdr",
           "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n\x80\x40\x20\x81\x89\x89\x89\x91");
    return true;
  }();
  static_cast<void>(once);
}

void expectSoundOrRefused(const std::function<Scene()>& load) {
  writeNeighbours();
  expectReadOrRefused([&] {
    const Scene scene = load();
    test::expectSound(scene);
    if (!testing::Test::HasFailure()) move(scene);
  });
}

void expectSoundOrRefused(scene::RawScene (*load)(const scene::Input&), std::string_view name,
                          std::string_view bytes) {
  const std::filesystem::path file = folder() / name;
  const LogCallback log = [](LogLevel, std::string_view note) { EXPECT_FALSE(note.empty()); };
  expectSoundOrRefused([&] {
    std::vector<Repair> repairs;
    scene::RawScene raw = load({file, std::as_bytes(std::span(bytes)), log});
    raw = scene::inMillimetres(std::move(raw), file, true, log, repairs);
    return scene::finished(std::move(raw), file, std::move(repairs), {});
  });
}

}  // namespace opaline::fuzz
