#include "viewer/session/opening.h"

#include <gtest/gtest.h>

#include "renderer/shapes.h"

namespace opaline::app::viewer {
namespace {

Object opaqueObject(const char* name, float metallic) {
  Object object{.name = name, .mesh = test::box({0, 0, 0}, {1, 1, 1}, 1)};
  object.opaque = OpaqueMaterial{};
  object.opaque->metallic = metallic;
  return object;
}

Loader::Result fileWith(float metallic) {
  Loader::Result result;
  result.loaded.emplace();
  result.loaded->scene.objects = {opaqueObject("edited", metallic),
                                  opaqueObject("other", metallic)};
  result.loaded->source.numbersOfObject["other"] = {};
  return result;
}

Session sessionOf(const Loader::Result& result) {
  Session session;
  session.scene = result.loaded->scene;
  session.source = result.loaded->source;
  session.diagonalMm = 1;
  return session;
}

TEST(Resized, KeepsEditsOfMaterials) {
  Session edited = sessionOf(fileWith(0.25F));
  edited.scene.objects[0].opaque->metallic = 0.75F;
  edited.scene.objects[0].medium.name = "chosen";
  edited.source.numbersOfObject["edited"].opaque =
      options::chosenIn(*edited.scene.objects[0].opaque);
  edited.source.numbersOfObject.erase("other");
  // Meanwhile the file has changed.
  const Session made = resized(edited, fileWith(0.5F));
  EXPECT_EQ(made.scene.objects[0].opaque->metallic, 0.75F);
  EXPECT_EQ(made.scene.objects[0].medium.name, "chosen");
  EXPECT_EQ(made.scene.objects[1].opaque->metallic, 0.5F);
  EXPECT_TRUE(made.source.numbersOfObject.contains("edited"));
}

}  // namespace
}  // namespace opaline::app::viewer
