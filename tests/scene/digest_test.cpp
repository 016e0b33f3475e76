#include "opaline/digest.h"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "opaline/scene.h"

namespace opaline {
namespace {

std::uint64_t digestOfText(std::string_view text) {
  return digestOf(std::as_bytes(std::span(text.data(), text.size())));
}

// The test vectors of Fowler, Noll and Vo.
TEST(Digest, IsTheirs) {
  EXPECT_EQ(digestOfText(""), 0xcbf29ce484222325U);
  EXPECT_EQ(digestOfText("a"), 0xaf63dc4c8601ec8cU);
  EXPECT_EQ(digestOfText("foobar"), 0x85944171f73967e8U);
}

TEST(Digest, KnowsWhatDecidesPictures) {
  const Scene scene = builtInTeapot();
  const std::uint64_t digest = digestOf(scene);
  EXPECT_EQ(digestOf(builtInTeapot()), digest);
  const std::vector<std::pair<const char*, std::function<void(Scene&)>>> edits{
      {"a vertex", [](Scene& s) { s.objects[0].mesh.positionsMm[7][1] += 0.001F; }},
      {"a triangle",
       [](Scene& s) {
         std::swap(s.objects[0].mesh.triangles[0][0], s.objects[0].mesh.triangles[0][1]);
       }},
      {"a medium", [](Scene& s) { s.objects[0].medium.g = 0.5; }},
      {"paint", [](Scene& s) { s.objects[0].paint = Paint{}; }},
      {"roughness", [](Scene& s) { s.objects[0].surface.emplace().roughness = 0.5F; }},
      {"an opaque material", [](Scene& s) { s.objects[0].opaque = OpaqueMaterial{}; }},
      {"a light", [](Scene& s) { s.lighting.directional[0].irradiance[2] *= 1.001F; }},
      {"a light more", [](Scene& s) { s.lighting.points.emplace_back(); }},
      {"a light with a size", [](Scene& s) { s.lighting.areas.emplace_back(SphereLight{}); }},
      {"the sky", [](Scene& s) { s.lighting.ambient[0] += 0.001F; }},
      {"an environment",
       [](Scene& s) { s.lighting.environment = std::make_shared<const Image>(2, 1); }},
      {"the camera", [](Scene& s) { s.camera.shiftX = 0.1F; }},
      {"a deformer",
       [](Scene& s) {
         s.deformers.push_back({DeformerKind::Bend, 0.1F, 0});
       }},
  };
  std::vector<std::uint64_t> seen{digest};
  for (const auto& [what, edit] : edits) {
    Scene edited = scene;
    edit(edited);
    const std::uint64_t now = digestOf(edited);
    for (const std::uint64_t other : seen) EXPECT_NE(now, other) << what;
    seen.push_back(now);
  }
}

TEST(Digest, KnowsNoNamesAndNotes) {
  Scene scene = builtInTeapot();
  const std::uint64_t digest = digestOf(scene);
  scene.name = "another";
  scene.objects[0].name = "pot";
  scene.objects[0].medium.name = "stone";
  scene.repairs.push_back({"holes", 3});
  scene.notShown.push_back({"clouds", 1, {}});
  EXPECT_EQ(digestOf(scene), digest);
}

}  // namespace
}  // namespace opaline
