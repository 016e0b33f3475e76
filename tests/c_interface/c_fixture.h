#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "c_interface/handles.h"
#include "opaline/media.h"
#include "opaline/mesh.h"
#include "opaline/opaline_c.h"
#include "opaline/renderer.h"

namespace opaline_c_test {

struct SceneDeleter {
  void operator()(OpalineScene* scene) const { opalineDestroyScene(scene); }
};
struct RendererDeleter {
  void operator()(OpalineRenderer* renderer) const { opalineDestroyRenderer(renderer); }
};
struct ViewDeleter {
  void operator()(OpalineView* view) const { opalineDestroyView(view); }
};
using Scene = std::unique_ptr<OpalineScene, SceneDeleter>;
using Renderer = std::unique_ptr<OpalineRenderer, RendererDeleter>;
using View = std::unique_ptr<OpalineView, ViewDeleter>;

constexpr int edge = 24;
constexpr std::size_t floats = std::size_t{4} * edge * edge;

/// An octahedron of 20 mm; its vertices have four more floats than needed.
struct Body {
  static constexpr std::size_t count = 6;
  std::array<std::array<float, 7>, count> vertices{};
  std::array<std::uint32_t, 24> triangles{0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4,
                                          2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};

  Body() {
    for (std::size_t i = 0; i < count; ++i) vertices[i][i / 2] = i % 2 == 0 ? 10.F : -10.F;
  }
  OpalineObject object() const {
    OpalineObject object{};
    object.size = sizeof object;
    object.name = "octahedron";
    object.positionsMm = vertices[0].data();
    object.positionStrideBytes = sizeof vertices[0];
    object.vertexCount = count;
    object.triangles = triangles.data();
    object.triangleCount = triangles.size() / 3;
    return object;
  }
};

inline OpalineRenderOptions smallDipole() {
  OpalineRenderOptions options{};
  options.size = sizeof options;
  EXPECT_EQ(opalineDefaultRenderOptions(&options), OpalineOk);
  options.width = options.height = edge;
  options.maxSurfels = 4096;
  options.transport = OpalineTransportDipole;
  return options;
}

/// smallDipole() in C++.
inline opaline::RenderOptions sameDipole() {
  opaline::RenderOptions options;
  options.width = options.height = edge;
  options.maxSurfels = 4096;
  options.transport = opaline::Transport::Dipole;
  return options;
}

inline Scene sceneOf(const Body& body) {
  OpalineScene* scene = nullptr;
  EXPECT_EQ(opalineCreateScene(&scene), OpalineOk);
  const OpalineObject object = body.object();
  EXPECT_EQ(opalineAddObject(scene, &object, nullptr), OpalineOk) << opalineLastError();
  EXPECT_EQ(opalineUseDefaultLights(scene), OpalineOk);
  OpalineCamera camera{};
  camera.size = sizeof camera;
  const std::array<float, 3> towards{0.3F, 0.4F, 1};
  EXPECT_EQ(opalineDefaultCamera(scene, towards.data(), 30, &camera), OpalineOk);
  EXPECT_EQ(opalineSetSceneCamera(scene, &camera), OpalineOk);
  return Scene(scene);
}

struct Drawn {
  Renderer renderer;
  View view;

  explicit Drawn(const Scene& scene) {
    OpalineRenderer* made = nullptr;
    EXPECT_EQ(opalineCreateRenderer(nullptr, &made), OpalineOk) << opalineLastError();
    renderer.reset(made);
    EXPECT_EQ(opalineSetScene(made, scene.get()), OpalineOk) << opalineLastError();
    const OpalineRenderOptions options = smallDipole();
    OpalineView* drawn = nullptr;
    EXPECT_EQ(opalineCreateView(made, &options, &drawn), OpalineOk);
    view.reset(drawn);
  }

  std::vector<float> picture(OpalineAov aov = OpalineAovExitance) const {
    std::vector<float> rgba(floats);
    const OpalineTarget target{sizeof target, aov, rgba.data(), rgba.size()};
    EXPECT_EQ(opalineRender(view.get(), &target, 1), OpalineOk) << opalineLastError();
    return rgba;
  }
};

/// The same scene as sceneOf(), in C++.
inline opaline::Scene sameScene(const Body& body) {
  opaline::Scene scene;
  std::vector<opaline::Vec3> positions;
  for (const auto& vertex : body.vertices) positions.push_back({vertex[0], vertex[1], vertex[2]});
  std::vector<opaline::Triangle> triangles;
  for (std::size_t i = 0; i < body.triangles.size(); i += 3) {
    triangles.push_back({body.triangles[i], body.triangles[i + 1], body.triangles[i + 2]});
  }
  scene.objects.push_back({"octahedron", opaline::makeMesh(positions, triangles),
                           opaline::findMedium("marble").value()});
  scene.lighting = opaline::defaultLighting();
  scene.camera = opaline::defaultCamera(scene, {0.3F, 0.4F, 1});
  return scene;
}

/// Its picture in C++, by the renderer behind a handle, which has compiled what it needs.
inline std::vector<float> samePicture(const opaline::Scene& scene, const Drawn& drawn,
                                      opaline::Aov aov = opaline::Aov::Exitance) {
  drawn.renderer->renderer.setScene(scene);
  return drawn.renderer->renderer.render(sameDipole(), {aov}).images[0].rgba;
}

}  // namespace opaline_c_test
