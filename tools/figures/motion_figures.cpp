// Figure 9 of Gong et al. 2008, and motion that it does not show.

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "figures.h"
#include "opaline/soft_body.h"

namespace opaline::figures {

namespace {

/// One panel for each time.
std::vector<core::Image8> film(Studio& studio, RenderOptions options, const Exposure& exposure,
                               double stepSeconds, int frames) {
  std::vector<core::Image8> panels;
  for (int frame = 0; frame < frames; ++frame) {
    options.seconds = stepSeconds * frame;
    panels.push_back(photograph(studio, options, exposure));
  }
  return panels;
}

void morph(Studio& studio, const char* name) {
  Scene scene = load(studio, "bunny_egg_a.ply", "jade", 40, "bunny_egg_b.ply");
  scene.camera = defaultCamera(scene, {0.1F, 0.1F, 1}, 33);
  scene.lighting = stageLight();
  studio.renderer.setScene(scene);
  const Exposure exposure{0.7F, 304, 304};
  std::vector<core::Image8> panels = film(studio, paperMethod(), exposure, 0.4, 6);
  for (core::Image8& panel : film(studio, objectSpace(), exposure, 0.4, 6)) {
    panels.push_back(std::move(panel));
  }
  publish(studio, name, sheet(panels, 6, 0, dark));
}

void wobble(Studio& studio, const char* name) {
  Scene scene = bear("gummy-red", 50);
  scene.camera = defaultCamera(scene, {0.25F, 0.12F, 1}, 38);
  scene.lighting = stageLight();
  scene.deformers = {{DeformerKind::Wobble, 0.09F, 1}};
  studio.renderer.setScene(scene);
  publish(studio, name,
          sheet(film(studio, objectSpace(), {0.3F, 272, 320}, 1.0 / 12, 12), 6, 0, dark));
}

void walk(Studio& studio, const char* name) {
  Scene scene = load(studio, "gltf/CesiumMan.glb", "skin1", 60);
  scene.camera = defaultCamera(scene, {0.35F, 0.12F, 1}, 37);
  scene.lighting = stageLight();
  studio.renderer.setScene(scene);
  publish(studio, name,
          sheet(film(studio, objectSpace(), {0.8F, 220, 320}, 2.0 / 8, 8), 8, 0, dark));
}

void deformers(Studio& studio, const char* name) {
  Scene scene = bear("gummy-orange", 50);
  scene.camera = defaultCamera(scene, {0.25F, 0.12F, 1}, 40);
  scene.lighting = stageLight();
  std::vector<core::Image8> panels;
  for (const Deformer& deformer :
       {Deformer{DeformerKind::Twist, 0}, Deformer{DeformerKind::Twist, 1.5F},
        Deformer{DeformerKind::Bend, 0.6F}, Deformer{DeformerKind::Squash, 0.3F},
        Deformer{DeformerKind::Wobble, 0.12F}}) {
    scene.deformers = {deformer};
    studio.renderer.setScene(scene);
    panels.push_back(photograph(studio, objectSpace(), {0.3F, 336, 384}));
  }
  publish(studio, name, sheet(panels, 5, 0, dark));
}

// Pulled at an ear, and after it is let go; then pressed into the belly.
void poke(Studio& studio, const char* name) {
  Scene scene = bear("gummy-red", 50);
  scene.camera = defaultCamera(scene, {0.25F, 0.12F, 1}, 40);
  scene.camera.targetMm[0] += 5;
  scene.camera.positionMm[0] += 5;
  scene.lighting = stageLight();
  studio.renderer.setScene(scene);
  const Mesh& mesh = scene.objects[0].mesh;
  SoftBody body(studio.renderer, 0, mesh.positionsMm, mesh.triangles);
  std::vector<core::Image8> panels;
  const auto show = [&](double seconds) {
    for (double left = seconds; left > 0; left -= SoftBody::maxStepSeconds)
      body.step(std::min(left, SoftBody::maxStepSeconds));
    panels.push_back(photograph(studio, objectSpace(), {0.3F, 336, 384}));
  };
  show(0);
  body.grab({7.5F, 36, 0}, 4);
  body.pull({26, 37, 8});
  show(2);
  body.release();
  for (int i = 0; i < 3; ++i) show(0.1);
  for (int i = 0; i < 20; ++i) body.step(SoftBody::maxStepSeconds);
  body.grab({0, 16, 10}, 4);
  body.pull({0, 14, -2});
  show(2);
  publish(studio, name, sheet(panels, 6, 0, dark));
}

}  // namespace

std::span<const Figure> motionFigures() {
  static constexpr std::array all{Figure{"figure_9", morph}, Figure{"wobble", wobble},
                                  Figure{"walk", walk}, Figure{"deformers", deformers},
                                  Figure{"poke", poke}};
  return all;
}

}  // namespace opaline::figures
