#include "scene/random_scene.h"

#include <cmath>
#include <random>
#include <string>

#include "opaline/image_file.h"
#include "opaline/media.h"
#include "scene/environment_file.h"

namespace opaline::test {
namespace {

/// Numbers that are awkward to print: any mantissa, over many powers of ten.
class Numbers {
 public:
  explicit Numbers(unsigned seed) : random_(seed) {}

  double within(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  float real(double low, double high) { return static_cast<float>(within(low, high)); }
  float size() { return static_cast<float>(std::pow(10, within(-12, 6))); }
  Rgb light() { return {size(), size(), below(4) == 0 ? 0 : size()}; }
  Vec3 place() { return {real(-100, 100), real(-1, 1), real(-1e4, 1e4)}; }
  Vec3 direction() {
    const Vec3 v{real(-1, 1), real(-1, 1), real(0.1, 1)};
    const float length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    return {v[0] / length, v[1] / length, v[2] / length};
  }
  int below(int limit) { return static_cast<int>(random_() % static_cast<unsigned>(limit)); }

 private:
  std::mt19937 random_;
};

SceneFileSettings randomSettings(Numbers& random) {
  options::PictureSettings picture;
  RenderOptions& render = picture.render;
  render.width = 1 + random.below(16384);
  render.height = 1 + random.below(16384);
  render.transport = random.below(2) == 0 ? Transport::Boundary : Transport::BetterDipole;
  render.sum = random.below(2) == 0 ? Sum::Tree : Sum::All;
  render.site = random.below(2) == 0 ? Site::Vertex : Site::Auto;
  render.tolerance = random.real(1e-4, 1);
  render.maxSurfels = 1024 + random.below(4'000'000);
  render.bounces = random.below(9);
  render.maxClusters = 64 + random.below(200'000);
  render.pattern = {random.below(16), random.real(1e-3, 100), random.real(1e-3, 1000)};
  render.dsmSize = 64 + random.below(4000);
  render.shadowSize = 64 + random.below(8000);
  render.specular = random.below(2) == 0;
  render.roughness = random.real(0.05, 1);
  render.antialias = 1 << random.below(4);
  picture.time.seconds = random.within(0, 1e6);
  picture.tone = {random.real(-32, 32), ToneCurve::None, Rgb{random.real(0, 1), 0, 1}};
  auto chosen = options::chosenIn(picture);
  const options::Spelling none = [](const auto&, const options::Value&) { return std::string(); };
  while (const auto unused = options::findUnused(chosen, render, none)) chosen.erase(unused->key);
  return {chosen, "a \"GPU\"\t№ 1", "none"};
}

}  // namespace

Image sky() {
  Image image(8, 4);
  for (std::size_t i = 0; i < image.rgba.size(); ++i) {
    image.rgba[i] = i % 4 == 3 ? 1 : static_cast<float>(i * i) / 7;
  }
  return image;
}

LoadedScene randomScene(unsigned seed, const std::filesystem::path& model,
                        const std::filesystem::path& skyFile) {
  Numbers random(seed);
  LoadOptions options;
  if (random.below(2) == 0) options.diagonalMm = random.real(1, 1000);
  LoadedScene loaded = loadSceneFile(model, options);
  Scene& scene = loaded.scene;
  scene.objects[0].medium = findMedium("ketchup").value();
  for (std::size_t i = 1; i < scene.objects.size(); ++i) {
    scene.objects[i].medium = {"soap [" + std::to_string(i) + "] \"x\"",
                               {random.within(0, 10), 1.0 / 3, random.within(0, 1e-7)},
                               {random.within(0, 10), 0.1, 1e-300},
                               random.within(1.01, 3)};
  }
  scene.lighting = {};
  for (int i = random.below(3); i >= 0; --i) {
    scene.lighting.directional.push_back({random.direction(), random.light()});
    scene.lighting.points.push_back({random.place(), random.light()});
    const float outer = random.real(0.1, 90);
    scene.lighting.spots.push_back(
        {random.place(), random.direction(), random.light(), outer * random.real(0, 1), outer});
  }
  scene.lighting.areas = {
      RectangleLight{random.place(), random.direction(), random.place(), random.light(), true,
                     true},
      DiscLight{random.place(), random.direction(), random.real(0.1, 100), random.light(), false,
                true},
      SphereLight{random.place(), random.real(1e-3, 1e5), random.light()},
      TubeLight{random.place(), random.place(), random.real(0.1, 9), random.light()}};
  scene.lighting.points.push_back({{0, 1e-4F, -3e-5F}, {1, 1e30F, 0}});
  scene.lighting.ambient = random.light();
  writeExr(skyFile, sky());
  loaded.source.environment = {skyFile, random.real(0, 100), random.within(-1e6, 1e6)};
  scene.lighting.environment = readEnvironment(*loaded.source.environment);
  scene.camera = {random.place(), random.place(), random.place(), random.real(1, 170)};
  scene.deformers = {{DeformerKind::Twist, random.real(-100, 100), random.real(0.001, 100)},
                     {DeformerKind::Wobble, random.real(-1, 1), 0},
                     {DeformerKind::Squash, -0.0F, 1e6F},
                     {DeformerKind::Bend, -6.28F, 0.001F}};
  loaded.settings = randomSettings(random);
  return loaded;
}

}  // namespace opaline::test
