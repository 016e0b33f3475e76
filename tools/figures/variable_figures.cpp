// The figures of docs/pipeline.md and docs/scattering.md for the stages between scene and picture.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "figures.h"
#include "opaline/image_file.h"
#include "opaline/scene.h"

namespace opaline::figures {

namespace {

constexpr int mapTexels = 512;
constexpr Paper black{8, 8, 10};

Image mapOfBear(Studio& studio, Aov aov) {
  studio.renderer.setScene(bear("gummy-red", 50));
  RenderOptions options = paperMethod();
  options.dsmSize = mapTexels;
  return studio.renderer.render(options, {aov}).images.at(0);
}

void positionMap(Studio& studio, const char* name) {
  const Image map = mapOfBear(studio, Aov::DsmPosition);
  publish(studio, name, plain(overBox(map, boundsOf(bear("gummy-red", 50))), black));
}

void normalMap(Studio& studio, const char* name) {
  publish(studio, name, plain(asColour(mapOfBear(studio, Aov::DsmNormal)), black));
}

void irradianceMap(Studio& studio, const char* name) {
  publish(studio, name, develop(mapOfBear(studio, Aov::DsmIrradiance), -1, black));
}

/// Full texels are ¾ white.
void areaMap(Studio& studio, const char* name) {
  Image map = mapOfBear(studio, Aov::DsmArea);
  float most = 0;
  for (std::size_t i = 0; i < map.rgba.size(); i += 4) most = std::max(most, map.rgba[i]);
  for (std::size_t i = 0; i < map.rgba.size(); i += 4) {
    const float share = most > 0 ? 0.75F * map.rgba[i] / most : 0;
    std::fill_n(map.rgba.begin() + static_cast<std::ptrdiff_t>(i), 3, share);
  }
  publish(studio, name, plain(map, black));
}

void exitance(Studio& studio, const char* name) {
  studio.renderer.setScene(bear("gummy-red", 50));
  RenderOptions options = paperMethod();
  options.width = options.height = 2 * 384;
  publish(studio, name,
          develop(halved(studio.renderer.render(options, {Aov::Exitance}).images.at(0)), -1));
}

void models(Studio& studio, const char* name) {
  std::vector<Image8> panels;
  const auto show = [&](Scene scene, const Vec3& direction, float fovDegrees) {
    scene.camera = defaultCamera(scene, direction, fovDegrees);
    scene.lighting = stageLight();
    studio.renderer.setScene(scene);
    panels.push_back(photograph(studio, usual(), {0, 480, 480}));
  };
  show(load(studio, "bunny_closed.ply", "jade", 50), {0.1F, 0.1F, 1}, 32);
  show(load(studio, "bunny_closed.ply", "skimmilk", 50), {0.1F, 0.1F, 1}, 32);
  show(load(studio, "buddha.ply", "marble", 100), {0.15F, 0.1F, 1}, 40);
  publish(studio, name, sheet(panels, 3, 0, dark));
}

/// Gives neighbouring indices very different colours.
Rgb colourOfIndex(float index) {
  std::uint32_t bits = static_cast<std::uint32_t>(index) * 2654435769U;
  bits = (bits ^ (bits >> 15U)) * 2246822519U;
  bits ^= bits >> 13U;
  Rgb colour{};
  for (std::size_t c = 0; c < 3; ++c)
    colour[c] = 0.1F + 0.8F * static_cast<float>((bits >> (8 * c)) & 255U) / 255;
  return colour;
}

void surfels(Studio& studio, const char* name) {
  studio.renderer.setScene(bear("marble", 50));
  RenderOptions options = usual();
  options.width = 360;
  options.height = 464;
  options.maxSurfels = 8192;
  options.treeLevel = 4;
  options.antialias = 1;
  const Image indices = studio.renderer.render(options, {Aov::Surfels}).images.at(0);
  std::vector<Image8> panels;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    Image shown = indices;
    for (std::size_t i = 0; i < shown.rgba.size(); i += 4) {
      const Rgb colour = colourOfIndex(indices.rgba[i + channel]);
      std::copy(colour.begin(), colour.end(), shown.rgba.begin() + static_cast<std::ptrdiff_t>(i));
    }
    panels.push_back(plain(shown, white));
  }
  publish(studio, name, sheet(panels, 3, 0, white));
}

}  // namespace

std::span<const Figure> variableFigures() {
  static constexpr std::array all{Figure{"dsm_position", positionMap},
                                  Figure{"dsm_normal", normalMap},
                                  Figure{"dsm_irradiance", irradianceMap},
                                  Figure{"dsm_area", areaMap},
                                  Figure{"exitance", exitance},
                                  Figure{"models", models},
                                  Figure{"surfels", surfels}};
  return all;
}

}  // namespace opaline::figures
