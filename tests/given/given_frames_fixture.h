#pragma once

#include <cmath>
#include <optional>

#include "given/engine_fixture.h"

namespace opaline::test {

constexpr std::uint32_t size = 48;
constexpr double nearMm = 2;
constexpr double farMm = 200;

class GivenFramesTest : public EngineTest {
 protected:
  using EngineTest::EngineTest;
  void SetUp() override {
    EngineTest::SetUp();
    scene_ = wobblyBall();
    renderer_.emplace(engine().options());
    renderer_->setScene(scene_);
  }
  void TearDown() override {
    renderer_.reset();
    EngineTest::TearDown();
  }

  Renderer& renderer() { return *renderer_; }

  static RenderOptions options() {
    RenderOptions options = tinyOptions();
    options.width = options.height = size;
    return options;
  }
  static RenderOptions optionsOf(const Method& method) {
    RenderOptions made = options();
    made.transport = method.transport;
    made.sum = method.sum;
    made.site = method.site;
    return made;
  }

  /// Records a frame, submits it and waits.
  void runFrame(View& view, const DeviceOutputs& outputs, const FrameOrder& order) {
    const VkCommandBuffer commands = engine().begin();
    const TimelinePoint finished = engine().nextPoint();
    view.record({.commands = commands, .finished = finished, .outputs = outputs}, order);
    engine().submit(commands, finished);
    engine().waitFor(finished);
  }

  /// What the scene's camera sees, with an ordinary or a reversed depth.
  CameraMatrices matrices(bool reversed) const {
    const Vector position = toVector(scene_.camera.positionMm);
    const Vector axis = unit(toVector(scene_.camera.targetMm) - position);
    const Vector right = unit(cross(axis, toVector(scene_.camera.up)));
    const Vector down = cross(axis, right);
    const double focal = 1 / std::tan(static_cast<double>(scene_.camera.verticalFovDegrees) *
                                      3.14159265358979 / 360);
    CameraMatrices made;
    const Vector rows[] = {right, down, axis};
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < 3; ++column)
        made.worldToView[4 * column + row] = static_cast<float>(rows[row][column]);
      made.worldToView[12 + row] = static_cast<float>(-dot(rows[row], position));
    }
    made.worldToView[15] = 1;
    made.viewToClip[0] = made.viewToClip[5] = static_cast<float>(focal);
    made.viewToClip[11] = 1;
    const double a = reversed ? -nearMm / (farMm - nearMm) : farMm / (farMm - nearMm);
    const double b = (reversed ? farMm : -farMm) * nearMm / (farMm - nearMm);
    made.viewToClip[10] = static_cast<float>(a);
    made.viewToClip[14] = static_cast<float>(b);
    return made;
  }
  /// What an orthographic camera of that height sees, as matrices() otherwise.
  CameraMatrices orthographic(bool reversed, float heightMm) const {
    CameraMatrices made = matrices(reversed);
    made.viewToClip = {};
    made.viewToClip[0] = made.viewToClip[5] = 2 / heightMm;
    made.viewToClip[15] = 1;
    const double slope = 1 / (farMm - nearMm);
    made.viewToClip[10] = static_cast<float>(reversed ? -slope : slope);
    made.viewToClip[14] = static_cast<float>(slope * (reversed ? farMm : -nearMm));
    return made;
  }
  /// Of something at that distance along the axis.
  static double depthAt(double mm, bool reversed) {
    const double ordinary = farMm * (mm - nearMm) / ((farMm - nearMm) * mm);
    return reversed ? 1 - ordinary : ordinary;
  }

  Scene scene_;

 private:
  std::optional<Renderer> renderer_;
};

}  // namespace opaline::test
