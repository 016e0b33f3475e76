#include "viewer/picture/picture_input.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include <GLFW/glfw3.h>

#include "film/framing.h"
#include "viewer/picture/orbit.h"

namespace opaline::app::viewer {

namespace {

bool anyDown() {
  return ImGui::IsMouseDown(ImGuiMouseButton_Left) || ImGui::IsMouseDown(ImGuiMouseButton_Right) ||
         ImGui::IsMouseDown(ImGuiMouseButton_Middle);
}

// Whoever moves camera or body wants to see it, and not the truth of an earlier moment.
void showPicture(Session& session) {
  session.shown = Shown::Picture;
}

/// A map shows no camera, so moving it would do nothing that is seen.
bool cameraIsSeen(Session& session) {
  if (showsMap(session.aov)) session.refused = mapHasNoCamera;
  return !showsMap(session.aov);
}

void expose(Session& session, float stops) {
  session.exposesByLight = false;
  session.tone.exposureStops = std::clamp(session.tone.exposureStops + stops, -8.0F, 8.0F);
}

void step(Session& session, double seconds) {
  if (!movesInTime(session)) {
    session.refused = nothingMoves;
    return;
  }
  session.time.seconds = std::max(0.0, session.time.seconds + seconds);
  session.edits.picture = true;
}

}  // namespace

PictureInput::Drag PictureInput::begin(Session& session, const Projection& projection,
                                       const Area& area, Poke& poke) {
  const ImGuiIO& io = ImGui::GetIO();
  const glm::vec2 mouse(io.MousePos.x, io.MousePos.y);
  const bool right = ImGui::IsMouseClicked(ImGuiMouseButton_Right);
  if (right || ImGui::IsMouseClicked(ImGuiMouseButton_Middle)) {
    if (!cameraIsSeen(session)) return Drag::None;
    return right ? Drag::Dolly : Drag::Pan;
  }
  if (!ImGui::IsMouseClicked(ImGuiMouseButton_Left)) return Drag::None;
  if (session.divided && session.shown == Shown::Picture) {
    const float x = static_cast<float>(area.x) + session.divider * static_cast<float>(area.width);
    if (std::abs(mouse.x - x) < 0.6F * ImGui::GetFontSize()) return Drag::Divider;
  }
  if (session.gizmos && showsScene(session)) {
    if (const auto handle = handles_.at(session, projection, mouse)) {
      handles_.grab(session, projection, *handle, mouse);
      session.light = handle->light;
      return Drag::Light;
    }
  }
  if ((session.poke || io.KeyCtrl) && !showsMap(session.aov) &&
      poke.grab(session, projection.through(mouse))) {
    showPicture(session);
    return Drag::Poke;
  }
  if (!cameraIsSeen(session)) return Drag::None;
  return io.KeyShift ? Drag::Pan : Drag::Orbit;
}

void PictureInput::go(Session& session, const Projection& projection, const Area& area,
                      Poke& poke) {
  const ImGuiIO& io = ImGui::GetIO();
  if (drag_ == Drag::Divider) {
    session.divider = std::clamp(
        (io.MousePos.x - static_cast<float>(area.x)) / static_cast<float>(area.width), 0.0F, 1.0F);
    return;
  }
  if (drag_ == Drag::Poke) return poke.pull(projection, {io.MousePos.x, io.MousePos.y});
  if (io.MouseDelta.x == 0 && io.MouseDelta.y == 0) return;
  const auto height = static_cast<float>(area.height);
  const float right = io.MouseDelta.x / height;
  const float down = io.MouseDelta.y / height;
  Camera& camera = session.scene.camera;
  constexpr float turn = 3.2F;  // radians over the height of the picture
  switch (drag_) {
    case Drag::Orbit:
      orbit(camera, -turn * right, turn * down);
      break;
    case Drag::Pan:
      pan(camera, -right, down);
      break;
    case Drag::Dolly:
      dolly(camera, std::exp(2 * down), session.diagonalMm);
      break;
    case Drag::Light:
      if (handles_.drag(session, projection, {io.MousePos.x, io.MousePos.y})) {
        session.edits.lighting = true;
      }
      return;
    default:
      return;
  }
  showPicture(session);
  session.edits.camera = true;
}

void PictureInput::useMouse(Session& session, const Area& area, Poke& poke) {
  const ImGuiIO& io = ImGui::GetIO();
  const Projection projection(session.scene.camera, area);
  const bool over =
      !io.WantCaptureMouse && ImGui::IsMousePosValid() && area.holds(io.MousePos.x, io.MousePos.y);
  if (!anyDown()) {
    if (drag_ == Drag::Poke) poke.release();
    drag_ = Drag::None;
    handles_.release();
  }
  // Movement before the button was pressed is not part of the drag.
  if (drag_ != Drag::None) {
    go(session, projection, area, poke);
  } else if (over) {
    drag_ = begin(session, projection, area, poke);
  }
  if (over && io.MouseWheel != 0 && cameraIsSeen(session)) {
    showPicture(session);
    dolly(session.scene.camera, std::exp(-0.12F * io.MouseWheel), session.diagonalMm);
    session.edits.camera = true;
  }
}

void PictureInput::useKey(const KeyPress& press, Session& session, const Area& area) {
  constexpr double frameSeconds = 1.0 / 30;
  Playback& playback = session.playback;
  if (press.control) return;
  if (press.key == GLFW_KEY_LEFT) return step(session, -frameSeconds);
  if (press.key == GLFW_KEY_RIGHT) return step(session, frameSeconds);
  if (press.repeated) return;
  switch (press.key) {
    case GLFW_KEY_F:
      if (area.empty() || !cameraIsSeen(session)) return;
      showPicture(session);
      frame(session.scene, session.time, session.positionsMm, area.aspect());
      session.edits.camera = true;
      return;
    case GLFW_KEY_T:
      if (!playback.turntable && !cameraIsSeen(session)) return;
      playback.turntable = !playback.turntable;
      showPicture(session);
      return;
    case GLFW_KEY_SPACE:
      if (movesInTime(session)) {
        playback.playing = !playback.playing;
      } else {
        session.refused = nothingMoves;
      }
      return;
    case GLFW_KEY_C:
      session.divided = !session.divided;
      showPicture(session);
      session.edits.picture = true;
      return;
    case GLFW_KEY_B:
      session.poke = !session.poke;
      return;
    case GLFW_KEY_H:
      session.gizmos = session.scaleBar = !(session.gizmos || session.scaleBar);
      return;
    case GLFW_KEY_O:
      return expose(session, 0.5F);
    case GLFW_KEY_X:
      return expose(session, -0.5F);
    default:
      return;
  }
}

}  // namespace opaline::app::viewer
