#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "renderer/renderer_fixture.h"
#include "renderer/shapes.h"

namespace opaline::test {

inline std::vector<Aov> asked() {
  return {Aov::Radiance, Aov::Exitance};
}

inline Scene wobblyBall() {
  Scene scene = sceneOf(sphere({0, 0, 0}, 6, 3), marble(), {0, 3, 24}, 7);
  scene.lighting.directional.push_back({{0, 0.6F, -0.8F}, {3, 3, 3}});
  scene.deformers.push_back({DeformerKind::Twist, 0.4F, 0});
  return scene;
}

/// The first light, and no other.
inline Lighting turned(Lighting lighting) {
  std::swap(lighting.directional[0].directionToLight[0],
            lighting.directional[0].directionToLight[2]);
  return lighting;
}

inline Image gradient() {
  Image sky(16, 8);
  for (std::size_t i = 0; i < sky.rgba.size(); ++i)
    sky.rgba[i] = 0.01F * static_cast<float>(i % 97);
  return sky;
}

/// Whether the view's last frame had that pass.
inline bool runs(const View& view, const char* pass) {
  const std::vector<PassTime> passes = view.report().passes;
  return std::any_of(passes.begin(), passes.end(),
                     [&](const PassTime& time) { return time.name == pass; });
}

struct Method {
  const char* name;
  Transport transport;
  Sum sum;
  Site site;
};

inline constexpr Method methods[] = {{"boundary", Transport::Boundary, Sum::Tree, Site::Vertex},
                                     {"tree", Transport::BetterDipole, Sum::Tree, Site::Fragment},
                                     {"pattern", Transport::Dipole, Sum::Pattern, Site::Fragment}};

inline RenderOptions optionsOf(const Method& method) {
  RenderOptions options = smallOptions();
  options.transport = method.transport;
  options.sum = method.sum;
  options.site = method.site;
  options.width = options.height = 32;
  options.dsmSize = options.shadowSize = 128;
  options.maxSurfels = 4096;
  options.maxClusters = 256;
  return options;
}

inline void expectSame(const std::vector<Image>& a, const std::vector<Image>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].rgba, b[i].rgba) << "image " << i;
}

}  // namespace opaline::test
