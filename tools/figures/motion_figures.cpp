// Figure 9 of Gong et al. 2008, and motion that the paper does not show.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "figures.h"
#include "film/film_encoder.h"
#include "opaline/soft_body.h"

namespace opaline::figures {

namespace {

/// One panel for each time.
std::vector<Image8> film(Studio& studio, const RenderOptions& options, const Exposure& exposure,
                         double stepSeconds, int frames) {
  std::vector<Image8> panels;
  for (int frame = 0; frame < frames; ++frame) {
    studio.renderer.setTime({.seconds = stepSeconds * frame});
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
  std::vector<Image8> panels = film(studio, paperMethod(), exposure, 0.4, 6);
  for (Image8& panel : film(studio, objectSpace(), exposure, 0.4, 6)) {
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
  publish(studio, name, sheet(film(studio, usual(), {0.3F, 272, 320}, 1.0 / 12, 12), 6, 0, dark));
}

void walk(Studio& studio, const char* name) {
  Scene scene = load(studio, "gltf/CesiumMan.glb", "skin1", 60);
  scene.camera = defaultCamera(scene, {0.35F, 0.12F, 1}, 37);
  scene.lighting = stageLight();
  studio.renderer.setScene(scene);
  publish(studio, name, sheet(film(studio, usual(), {0.8F, 220, 320}, 2.0 / 8, 8), 8, 0, dark));
}

void deformers(Studio& studio, const char* name) {
  Scene scene = bear("gummy-orange", 50);
  scene.camera = defaultCamera(scene, {0.25F, 0.12F, 1}, 40);
  scene.lighting = stageLight();
  std::vector<Image8> panels;
  for (const Deformer& deformer :
       {Deformer{DeformerKind::Twist, 0}, Deformer{DeformerKind::Twist, 1.5F},
        Deformer{DeformerKind::Bend, 0.6F}, Deformer{DeformerKind::Squash, 0.3F},
        Deformer{DeformerKind::Wobble, 0.12F}}) {
    scene.deformers = {deformer};
    studio.renderer.setScene(scene);
    panels.push_back(photograph(studio, usual(), {0.3F, 336, 384}));
  }
  publish(studio, name, sheet(panels, 5, 0, dark));
}

// The bear that is pulled at an ear, released, and then pressed into the belly.
Scene bearToPoke() {
  Scene scene = bear("gummy-red", 50);
  scene.camera = defaultCamera(scene, {0.25F, 0.12F, 1}, 40);
  scene.camera.targetMm[0] += 5;
  scene.camera.positionMm[0] += 5;
  scene.lighting = stageLight();
  return scene;
}

void poke(Studio& studio, const char* name) {
  const Scene scene = bearToPoke();
  studio.renderer.setScene(scene);
  const Mesh& mesh = scene.objects[0].mesh;
  SoftBody body(studio.renderer, 0, mesh.positionsMm, mesh.triangles);
  std::vector<Image8> panels;
  const auto show = [&](double seconds) {
    for (double left = seconds; left > 0; left -= SoftBody::maxStepSeconds)
      body.step(std::min(left, SoftBody::maxStepSeconds));
    panels.push_back(photograph(studio, usual(), {0.3F, 336, 384}));
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

// A hand's action on the bear: between two times it holds the flesh at `place` and moves it to
// `to`, then lets go.
struct Hold {
  double from;
  double until;
  Vec3 place;
  Vec3 to;
};

constexpr std::array holds{Hold{0.3, 1.6, {7.5F, 36, 0}, {25, 38, 8}},
                           Hold{3.2, 4.0, {0, 16, 10}, {0, 14, -2}},
                           Hold{5.2, 6.2, {0, 44, 4}, {-14, 30, 12}}};

void pokeFilm(Studio& studio, const char* name) {
  const Scene scene = bearToPoke();
  studio.renderer.setScene(scene);
  const Mesh& mesh = scene.objects[0].mesh;
  SoftBody body(studio.renderer, 0, mesh.positionsMm, mesh.triangles);
  constexpr int framesPerSecond = 30;
  constexpr int width = 320;
  constexpr int height = 384;
  constexpr int frames = 8 * framesPerSecond;
  const std::filesystem::path file = studio.output / fmt::format("{}.mp4", name);
  app::FilmEncoder film(file, width, height, framesPerSecond);
  const Hold* held = nullptr;
  for (int frame = 0; frame < frames; ++frame) {
    const double now = static_cast<double>(frame) / framesPerSecond;
    const auto found = std::find_if(holds.begin(), holds.end(), [&](const Hold& hold) {
      return now >= hold.from && now < hold.until;
    });
    const Hold* hold = found == holds.end() ? nullptr : &*found;
    if (hold != held && hold == nullptr) body.release();
    if (hold != held && hold != nullptr) body.grab(hold->place, 4);
    held = hold;
    if (held != nullptr) {
      const auto share = static_cast<float>(std::min(1.0, 2.5 * (now - held->from)));
      Vec3 to{};
      for (std::size_t axis = 0; axis < 3; ++axis)
        to[axis] = std::lerp(held->place[axis], held->to[axis], share);
      body.pull(to);
    }
    body.step(1.0 / framesPerSecond);
    film.add(photograph(studio, objectSpace(), {0.3F, width, height}));
  }
  film.finish();
  fmt::print("{}\n", file.string());
}

}  // namespace

std::span<const Figure> motionFigures() {
  static constexpr std::array all{Figure{"figure_9", morph}, Figure{"wobble", wobble},
                                  Figure{"walk", walk},      Figure{"deformers", deformers},
                                  Figure{"poke", poke},      Figure{"poke_film", pokeFilm}};
  return all;
}

}  // namespace opaline::figures
