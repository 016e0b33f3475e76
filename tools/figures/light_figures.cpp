// Soft shadows.

#include <array>
#include <cstdint>
#include <vector>

#include "figures.h"

namespace opaline::figures {

namespace {

/// A square in the plane of x and z, of cells² smaller squares, seen from above.
Mesh plate(const Vec3& centreMm, float halfMm, int cells) {
  Mesh mesh;
  const auto corner = [&](int i) {
    return halfMm * (2 * static_cast<float>(i) / static_cast<float>(cells) - 1);
  };
  for (int row = 0; row <= cells; ++row)
    for (int column = 0; column <= cells; ++column) {
      mesh.positionsMm.push_back(
          {centreMm[0] + corner(column), centreMm[1], centreMm[2] + corner(row)});
      mesh.normals.push_back({0, 1, 0});
    }
  const auto vertex = [&](int row, int column) {
    return static_cast<std::uint32_t>(row * (cells + 1) + column);
  };
  for (int row = 0; row < cells; ++row)
    for (int column = 0; column < cells; ++column) {
      mesh.triangles.push_back(
          {vertex(row, column), vertex(row + 1, column), vertex(row + 1, column + 1)});
      mesh.triangles.push_back(
          {vertex(row, column), vertex(row + 1, column + 1), vertex(row, column + 1)});
    }
  return mesh;
}

/// The bear on a plate, under equally bright balls of light in four sizes.
void softShadows(Studio& studio, const char* name) {
  Scene scene = bear("gummy-red", 50);
  const Bounds bounds = boundsOf(scene);
  const Vec3 middle = middleOf(bounds);
  const float floor = bounds.minMm[1];
  Medium chalk{"chalk", {8, 8, 8}, {0.002, 0.003, 0.005}, 1.3};
  scene.objects.push_back(
      {"plate", plate({middle[0], floor, middle[2]}, 110, 160 / studio.shrunk), chalk});
  scene.camera.targetMm = {middle[0] + 9, floor + 12, middle[2]};
  scene.camera.positionMm = {middle[0] + 20, floor + 100, middle[2] + 105};
  scene.camera.verticalFovDegrees = 28;
  std::vector<Image8> pictures;
  for (const float radiusMm : {0.5F, 4.0F, 12.0F, 24.0F}) {
    const float radiance = 7000 / (radiusMm * radiusMm);
    scene.lighting = {};
    scene.lighting.areas = {SphereLight{
        {middle[0] - 60, floor + 85, middle[2] + 10}, radiusMm, {radiance, radiance, radiance}}};
    scene.lighting.ambient = {0.12F, 0.13F, 0.15F};
    studio.renderer.setScene(scene);
    pictures.push_back(photograph(studio, usual(), {0, 384, 320}));
  }
  publish(studio, name, sheet(pictures, static_cast<int>(pictures.size()), gapPixels, white));
}

}  // namespace

std::span<const Figure> lightFigures() {
  static constexpr std::array all{Figure{"soft_shadows", softShadows}};
  return all;
}

}  // namespace opaline::figures
