#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "opaline/render_options.h"
#include "opaline/scene.h"

namespace opaline::test {

/// Random numbers that are equal with every standard library.
class Dice {
 public:
  explicit Dice(std::uint32_t seed) : bits_(seed) {}

  float between(float low, float high);
  /// Uniform in the logarithm.
  float betweenLog(float low, float high);
  int below(int count);
  bool chance(float probability) { return between(0, 1) < probability; }
  Vec3 direction();

 private:
  std::mt19937 bits_;
};

/// A random scene of up to three bodies: solids, thin plates, needles and bodies that touch. Their
/// size is 1e-3 to 1e6 mm, and their distance from the origin up to 10,000 times that (at most 1e7
/// mm). They have any medium from 1/3 to 1,000 mean free paths wide, deformers, and lights of all
/// kinds.
struct DrawnScene {
  Scene scene;
  std::size_t bodies = 1;  ///< objects without the ground, which is the last
  float sizeMm = 1;
  Vec3 middleMm{};
};
DrawnScene drawScene(Dice& dice);

/// The same, and some bodies are opaque, painted or rough, or stand on a ground.
DrawnScene drawSceneOfAllKinds(Dice& dice);

/// For a scene of that size at that place.
Medium drawMedium(Dice& dice, float sizeMm);
Material drawMaterial(Dice& dice, float sizeMm, bool opaque);
Lighting drawLighting(Dice& dice, float sizeMm, const Vec3& middleMm);
Camera drawCamera(Dice& dice, float sizeMm, const Vec3& middleMm);
Mesh drawBody(Dice& dice, float sizeMm, const Vec3& middleMm);

std::vector<Deformer> drawDeformers(Dice& dice);

/// Whether Sum::Pattern can show the scene.
bool isKnownToPattern(const Scene& scene);

/// Options for small pictures by any method that can show the scene.
RenderOptions drawOptions(Dice& dice, const Scene& scene);

}  // namespace opaline::test
