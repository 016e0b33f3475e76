// What tests of opaque materials share.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <vector>

#include "renderer/renderer_fixture.h"
#include "renderer/shapes.h"

namespace opaline::test {

constexpr int edgePixels = 32;
constexpr float halfEdgeMm = 10;

inline std::shared_ptr<const TexturePixels> texturePixels(
    int width, std::vector<std::array<double, 4>> texels) {
  TexturePixels made;
  made.width = width;
  made.height = static_cast<int>(texels.size()) / width;
  for (const auto& texel : texels)
    for (const double value : texel)
      made.rgba.push_back(static_cast<std::uint16_t>(std::lround(65535 * value)));
  return std::make_shared<const TexturePixels>(made);
}

class OpaqueTest : public RendererTest {
 protected:
  static RenderOptions options() {
    RenderOptions options = smallOptions();
    options.transport = Transport::Boundary;
    options.width = options.height = edgePixels;
    options.antialias = 1;
    return options;
  }

  // A square that faces the camera on +z and more than fills the picture. Its upper left corner has
  // the texture's.
  static Scene squareOf(const OpaqueMaterial& material) {
    Mesh square;
    for (const float y : {1.0F, -1.0F})
      for (const float x : {-1.0F, 1.0F}) {
        square.positionsMm.push_back({halfEdgeMm * x, halfEdgeMm * y, 0});
        square.normals.push_back({0, 0, 1});
        square.textureCoordinates[0].push_back({0.5F + 0.5F * x, 0.5F - 0.5F * y});
      }
    square.triangles = {{0, 2, 1}, {1, 2, 3}};
    Scene scene;
    scene.objects.push_back({.name = "square", .mesh = square, .medium = marble()});
    scene.objects[0].opaque = material;
    scene.camera.positionMm = {0, 0, 1000};
    scene.camera.targetMm = {0, 0, 0};
    scene.camera.verticalFovDegrees =
        static_cast<float>(2 * std::atan(0.009) * 180 / std::numbers::pi);
    return scene;
  }

  Vector radianceAt(const Scene& scene, int x, int y) {
    return toVector(render(scene, options(), {Aov::Radiance})[0].pixel(x, y));
  }
};

}  // namespace opaline::test
