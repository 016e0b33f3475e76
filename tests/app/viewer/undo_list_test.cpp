#include "viewer/session/undo_list.h"

#include <gtest/gtest.h>

#include <memory>

namespace opaline::app::viewer {
namespace {

Session sessionWithTwoObjects() {
  Session session;
  session.scene.objects.resize(2);
  session.scene.objects[0].medium = {"one", {1, 2, 3}, {0.1, 0.2, 0.3}, 1.3};
  session.scene.objects[1].medium = {"two", {4, 5, 6}, {0.4, 0.5, 0.6}, 1.4};
  session.scene.lighting.directional.resize(1);
  session.edits.material.assign(2, false);
  return session;
}

/// The session one step back, with what that changed.
Edits undone(UndoList& list, Session& session) {
  session.edits = {};
  session.edits.material.assign(session.scene.objects.size(), false);
  list.undo();
  restore(list.present(), session);
  return session.edits;
}

TEST(UndoList, AMediumComesBackAndNoOtherIsTouched) {
  Session session = sessionWithTwoObjects();
  UndoList list;
  list.begin(editStateOf(session));
  session.scene.objects[1].medium.sigmaAPerMm[2] = 7;
  EXPECT_FALSE(isStateOf(list.present(), session));
  list.add(editStateOf(session));
  const Edits edits = undone(list, session);
  EXPECT_EQ(session.scene.objects[1].medium.sigmaAPerMm[2], 0.6);
  EXPECT_EQ(edits.material, (std::vector<bool>{false, true}));
  EXPECT_FALSE(edits.lighting);
  EXPECT_FALSE(edits.deformers);
  EXPECT_FALSE(edits.camera);
  list.redo();
  restore(list.present(), session);
  EXPECT_EQ(session.scene.objects[1].medium.sigmaAPerMm[2], 7);
}

// A scene file would say it of the object.
TEST(UndoList, WhatIsSavedOfAMaterialComesBackWithIt) {
  Session session = sessionWithTwoObjects();
  UndoList list;
  list.begin(editStateOf(session));
  session.scene.objects[0].surface = TranslucentSurface{.roughness = 0.5F};
  session.source.numbersOfObject["a"].surface =
      options::chosenIn(*session.scene.objects[0].surface);
  list.add(editStateOf(session));
  const Edits edits = undone(list, session);
  EXPECT_EQ(edits.material, (std::vector<bool>{true, false}));
  EXPECT_FALSE(session.scene.objects[0].surface);
  EXPECT_TRUE(session.source.numbersOfObject.empty());
}

TEST(UndoList, WhatWasUndoneIsForgottenByTheNextEdit) {
  Session session = sessionWithTwoObjects();
  UndoList list;
  list.begin(editStateOf(session));
  session.exposesByLight = false;
  list.begin(editStateOf(session));
  for (const float stops : {1.0F, 2.0F}) {
    session.tone.exposureStops = stops;
    list.add(editStateOf(session));
  }
  undone(list, session);
  EXPECT_EQ(session.tone.exposureStops, 1);
  EXPECT_TRUE(list.canRedo());
  session.options.antialias = 8;
  list.add(editStateOf(session));
  EXPECT_FALSE(list.canRedo());
  undone(list, session);
  undone(list, session);
  EXPECT_EQ(session.tone.exposureStops, 0);
  EXPECT_FALSE(list.canUndo());
  undone(list, session);
  EXPECT_EQ(session.tone.exposureStops, 0) << "there is nothing before the beginning";
}

TEST(UndoList, ItsLengthIsBounded) {
  Session session = sessionWithTwoObjects();
  UndoList list;
  list.begin(editStateOf(session));
  for (std::size_t i = 0; i < 2 * UndoList::most; ++i) {
    session.options.bounces = static_cast<int>(i % 7);
    list.add(editStateOf(session));
  }
  std::size_t steps = 0;
  for (; list.canUndo(); list.undo()) ++steps;
  EXPECT_EQ(steps, UndoList::most - 1);
}

TEST(EditState, NeitherCameraNorTimeIsAnEdit) {
  Session session = sessionWithTwoObjects();
  const EditState before = editStateOf(session);
  session.scene.camera.positionMm = {1, 2, 3};
  session.scene.camera.targetMm = {4, 5, 6};
  session.time.seconds = 3;
  session.playback.playing = true;
  session.divider = 0.2F;
  EXPECT_TRUE(isStateOf(before, session));
  session.options.antialias = 1;
  restore(before, session);
  EXPECT_EQ(session.time.seconds, 3);
  EXPECT_EQ(session.scene.camera.positionMm, (Vec3{1, 2, 3}));
}

TEST(EditState, EveryKindOfEditIsSeenAndUndone) {
  const Session plain = sessionWithTwoObjects();
  const EditState before = editStateOf(plain);
  using Edit = void (*)(Session&);
  const Edit all[] = {
      [](Session& s) { s.scene.objects[0].medium.eta = 1.5; },
      [](Session& s) { s.scene.objects[0].medium.name = "custom"; },
      [](Session& s) { s.scene.objects[0].surface = TranslucentSurface{.roughness = 0.5F}; },
      [](Session& s) {
        s.scene.objects[1].opaque = mattMaterial({1, 0, 0});
      },
      [](Session& s) { s.scene.lighting.directional[0].irradiance[0] = 9; },
      [](Session& s) { s.scene.lighting.directional.clear(); },
      [](Session& s) { s.scene.lighting.points.emplace_back(); },
      [](Session& s) { s.scene.lighting.spots.emplace_back(); },
      [](Session& s) { s.scene.lighting.areas.emplace_back(TubeLight{}); },
      [](Session& s) {
        s.scene.lighting.ambient = {1, 0, 0};
      },
      [](Session& s) {
        s.scene.deformers.push_back({DeformerKind::Bend, 1, 2});
      },
      [](Session& s) { s.options.transport = Transport::Dipole; },
      [](Session& s) { s.options.pattern.nearRings = 2; },
      [](Session& s) { s.options.shadowSize = 512; },
      [](Session& s) { s.options.specular = false; },
      [](Session& s) { s.time.clip = -1; },
      [](Session& s) { s.tone.curve = ToneCurve::None; },
      [](Session& s) { s.exposesByLight = false; },
      [](Session& s) { s.film.perSecond = 24; },
      [](Session& s) { s.playback.beginSeconds = 1; },
      [](Session& s) {
        s.pictureSize = {64, 32};
      },
      [](Session& s) {
        s.tone.background = Rgb{1, 1, 1};
      },
      [](Session& s) { s.scene.camera.verticalFovDegrees = 50; },
      [](Session& s) { s.playback.loop = false; },
      [](Session& s) { s.playback.speed = 2; },
      [](Session& s) { s.divided = true; },
      [](Session& s) { s.quickWhileMoving = false; },
      [](Session& s) { s.aov = Aov::Normal; },
      [](Session& s) { s.treeLevel = 1; },
  };
  for (std::size_t i = 0; i < std::size(all); ++i) {
    Session session = plain;
    all[i](session);
    EXPECT_FALSE(isStateOf(before, session)) << i;
    restore(before, session);
    EXPECT_TRUE(isStateOf(before, session)) << i;
    EXPECT_TRUE(session.edits.any()) << i;
  }
}

TEST(EditState, ExposureThatFollowsTheLightIsNoStepOfItsOwn) {
  Session session = sessionWithTwoObjects();
  exposeByLight(session);
  const EditState before = editStateOf(session);
  const float stops = session.tone.exposureStops;
  session.scene.lighting.directional[0].irradiance = {100, 100, 100};
  const EditState brighter = editStateOf(session);
  exposeByLight(session);
  EXPECT_NE(session.tone.exposureStops, stops);
  EXPECT_TRUE(isStateOf(brighter, session));
  session.exposesByLight = false;
  session.tone.exposureStops = 3;
  restore(before, session);
  EXPECT_EQ(session.tone.exposureStops, stops);
}

TEST(EditState, AnotherSizeIsToBeLoadedFirst) {
  Session session = sessionWithTwoObjects();
  const EditState before = editStateOf(session);
  session.asked.setDiagonalMm(20);
  EXPECT_FALSE(isStateOf(before, session));
  EXPECT_FALSE(hasSizeOf(before, session));
}

TEST(EditState, AnEnvironmentIsTurnedBack) {
  Session session = sessionWithTwoObjects();
  auto image = std::make_shared<Image>(8, 4);
  image->rgba[0] = 5;
  session.environment = session.scene.lighting.environment = image;
  session.source.environment = EnvironmentFile{"/sky.hdr"};
  const EditState straight = editStateOf(session);
  session.source.environment->rotationDegrees = 90;
  session.scene.lighting.environment = std::make_shared<Image>(8, 4);
  const EditState turned = editStateOf(session);
  EXPECT_EQ(turned.lighting.environment, nullptr) << "only the file's own picture is kept";
  restore(straight, session);
  EXPECT_EQ(session.scene.lighting.environment, image);
  EXPECT_TRUE(session.edits.lighting);
  restore(turned, session);
  // A quarter turn moves it by a quarter of its width, to the left.
  EXPECT_EQ(session.scene.lighting.environment->rgba[4 * 6], 5);
  session.source.environment.reset();
  session.environment.reset();
  session.scene.lighting.environment.reset();
  restore(turned, session);
  ASSERT_TRUE(session.scene.lighting.environment);
  EXPECT_EQ(session.source.environment->rotationDegrees, 90);
}

TEST(EditState, ALightThatIsGoneIsNotSelected) {
  Session session = sessionWithTwoObjects();
  const EditState one = editStateOf(session);
  session.scene.lighting.directional.resize(2);
  session.light = 1;
  restore(one, session);
  EXPECT_EQ(session.light, -1);
}

TEST(UndoList, WhatMakesNoPictureIsTakenBackToWhatDid) {
  Session session = sessionWithTwoObjects();
  session.exposesByLight = false;
  UndoList list;
  list.begin(editStateOf(session));
  EXPECT_FALSE(list.takeBack()) << "nothing has made one yet";
  list.markTried();
  list.markSound();
  for (const float stops : {1.0F, 2.0F}) {
    session.tone.exposureStops = stops;
    list.add(editStateOf(session));
  }
  EXPECT_FALSE(list.isSound());
  EXPECT_TRUE(list.takeBack());
  EXPECT_TRUE(list.isSound());
  EXPECT_EQ(list.present().tone.exposureStops, 0);
  EXPECT_FALSE(list.canRedo());
}

TEST(UndoList, TakesBackAlsoWhenTheOldestStatesAreForgotten) {
  Session session = sessionWithTwoObjects();
  session.exposesByLight = false;
  UndoList list;
  list.begin(editStateOf(session));
  const auto edit = [&](int count) {
    for (int i = 0; i < count; ++i) {
      session.tone.exposureStops += 1;
      list.add(editStateOf(session));
    }
  };
  edit(100);
  list.markTried();
  list.markSound();
  edit(static_cast<int>(UndoList::most) - 1);
  EXPECT_TRUE(list.takeBack());
  EXPECT_EQ(list.present().tone.exposureStops, 100);
  list.markTried();
  list.markSound();
  edit(static_cast<int>(UndoList::most));
  EXPECT_FALSE(list.takeBack()) << "it is not remembered";
}

}  // namespace
}  // namespace opaline::app::viewer
