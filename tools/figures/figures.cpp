// Figures 2, 7 and 8 of Gong et al. 2008.

#include "figures.h"

#include <array>
#include <memory>
#include <vector>

#include "opaline/image_file.h"

namespace opaline::figures {

namespace {

void sourceMap(Studio& studio, const char* name) {
  constexpr int size = 384;
  Scene scene = load(studio, "bunny.ply", "marble", 30);
  scene.camera = defaultCamera(scene, {0.1F, 0.1F, 1}, 30.5F);
  scene.lighting = stageLight();
  studio.renderer.setScene(scene);
  RenderOptions options = paperMethod();
  options.dsmSize = size;
  const std::vector<Image> maps =
      studio.renderer.render(options, {Aov::DsmPosition, Aov::DsmNormal, Aov::DsmIrradiance})
          .images;
  publish(studio, name,
          sheet({photograph(studio, objectSpace(), {0, size, size}),
                 plain(overBox(maps.at(0), boundsOf(scene)), dark),
                 plain(asColour(maps.at(1)), dark), develop(maps.at(2), -2.5F)},
                4, gapPixels, white));
}

Image dimmed(Image radiance, float factor) {
  for (std::size_t i = 0; i < radiance.rgba.size(); ++i) {
    if (i % 4 != 3) radiance.rgba[i] *= factor;
  }
  return radiance;
}

void buddha(Studio& studio, const char* name) {
  Scene scene = load(studio, "buddha.ply", "jade", 120);
  scene.camera = defaultCamera(scene, {0.15F, 0.1F, 1}, 36);
  scene.lighting = {};
  const Vec3& centre = scene.camera.targetMm;
  scene.lighting.points = {
      {{centre[0] - 75, centre[1] + 62, centre[2] + 10}, {66000, 61000, 54000}}};
  const Exposure exposure{0, 512, 704};
  studio.renderer.setScene(scene);
  const Image8 point = photograph(studio, objectSpace(), exposure);
  scene.lighting.environment = std::make_shared<const Image>(
      dimmed(readHdrImage(studio.models / "env" / "venice_sunset_1k.hdr"), 0.3F));
  studio.renderer.setScene(scene);
  publish(studio, name,
          sheet({point, photograph(studio, objectSpace(), exposure)}, 2, gapPixels, white));
}

void threeModels(Studio& studio, const char* name) {
  std::vector<Image8> panels;
  const auto show = [&](Scene scene, const Vec3& direction, float fovDegrees, float stops) {
    scene.camera = defaultCamera(scene, direction, fovDegrees);
    scene.lighting = stageLight();
    studio.renderer.setScene(scene);
    panels.push_back(photograph(studio, paperMethod(), {stops, 512, 512}));
  };
  show(teapot("marble", 40), {-0.1F, 0.35F, 1}, 33, 0.9F);
  show(load(studio, "bunny.ply", "jade", 50), {0.1F, 0.1F, 1}, 32, 0.3F);
  show(bear("gummy-orange", 50), {0.25F, 0.12F, 1}, 37, 0.5F);
  publish(studio, name, sheet(panels, 3, gapPixels, white));
}

}  // namespace

std::span<const Figure> stillFigures() {
  static constexpr std::array all{Figure{"figure_2", sourceMap}, Figure{"figure_7", buddha},
                                  Figure{"figure_8", threeModels}};
  return all;
}

}  // namespace opaline::figures
