#include "viewer/picture/light_handles.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "viewer/picture/vectors.h"
#include "viewer/session/light_list.h"

namespace opaline::app::viewer {

namespace {

// Handles that are as near to each other as that cover each other.
constexpr float tieInReaches = 0.2F;

// A place on the sphere of directional lights.
glm::vec3 placeOf(const Session& session, const Projection& projection,
                  const DirectionalLight& light) {
  return toGlm(session.scene.camera.targetMm) +
         radiusOfSphereMm(session, projection) * glm::normalize(toGlm(light.directionToLight));
}

glm::vec3 placeOf(const Session& session, const Projection& projection, const LightEntry& entry) {
  const Lighting& lighting = session.scene.lighting;
  switch (entry.kind) {
    case LightKind::Directional:
      return placeOf(session, projection, lighting.directional[entry.index]);
    case LightKind::Point:
      return toGlm(lighting.points[entry.index].positionMm);
    case LightKind::Spot:
      return toGlm(lighting.spots[entry.index].positionMm);
    case LightKind::Area:
      break;
  }
  return middleOfArea(lighting.areas[entry.index]);
}

// A place on the light's axis, beside the object that it lights.
glm::vec3 aimOf(const Session& session, const SpotLight& light) {
  const glm::vec3 from = toGlm(light.positionMm);
  const glm::vec3 axis = glm::normalize(toGlm(light.direction));
  const float along = glm::dot(toGlm(session.scene.camera.targetMm) - from, axis);
  return from + std::max(along, 0.3F * session.diagonalMm) * axis;
}

void addHandles(const Session& session, const Projection& projection, std::size_t number,
                std::vector<LightHandle>& handles) {
  const Lighting& lighting = session.scene.lighting;
  const LightEntry entry = entryOf(lighting, number);
  const auto light = static_cast<int>(number);
  handles.push_back({light, LightPart::Place, placeOf(session, projection, entry)});
  if (light != session.light) return;
  if (entry.kind == LightKind::Spot)
    handles.push_back({light, LightPart::Aim, aimOf(session, lighting.spots[entry.index])});
  if (entry.kind != LightKind::Area) return;
  const float reach = 0.2F * session.diagonalMm;
  for (const AreaGrip& grip : gripsOf(lighting.areas[entry.index], projection.view().right, reach))
    handles.push_back({light, LightPart::Grip, grip.placeMm, grip.kind});
}

// Those of the selected light come last, so that they are drawn over all others.
std::vector<LightHandle> handlesOf(const Session& session, const Projection& projection) {
  const std::size_t count = countOf(session.scene.lighting);
  std::vector<LightHandle> handles;
  const auto selected = static_cast<std::size_t>(session.light);
  for (std::size_t i = 0; i < count; ++i)
    if (i != selected) addHandles(session, projection, i, handles);
  if (selected < count) addHandles(session, projection, selected, handles);
  return handles;
}

ImU32 colorOf(const Rgb& power, float alpha) {
  const float most = std::max({power[0], power[1], power[2], 1e-6F});
  return ImGui::GetColorU32(ImVec4(std::sqrt(power[0] / most), std::sqrt(power[1] / most),
                                   std::sqrt(power[2] / most), alpha));
}

// The direction of a handle that is dragged on the sphere about the target.
glm::vec3 onSphere(const glm::vec3& offsetInRadii, bool inFront, const glm::vec3& ahead) {
  float across = glm::length(offsetInRadii);
  if (!(across > 1e-6F)) return inFront ? -ahead : ahead;
  const glm::vec3 outwards = offsetInRadii / across;
  bool front = inFront;
  if (across > 1) {  // past the rim
    front = !front;
    across = std::max(0.0F, 2 - across);
  }
  const float towards = std::sqrt(std::max(0.0F, 1 - across * across));
  return glm::normalize(across * outwards + (front ? -towards : towards) * ahead);
}

void drawOutline(const AreaLight& light, const Projection& projection, ImU32 color,
                 ImDrawList& list) {
  const std::vector<glm::vec3> outline = outlineOf(light, projection.view().ahead);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const auto a = projection.toWindow(outline[i]);
    const auto b = projection.toWindow(outline[(i + 1) % outline.size()]);
    if (a && b) list.AddLine({a->x, a->y}, {b->x, b->y}, color, 1.5F);
  }
}

void drawSun(const DirectionalLight& sun, const Session& session, const Projection& projection,
             ImDrawList& list) {
  const auto place = projection.toWindow(placeOf(session, projection, sun));
  const auto target = projection.toWindow(toGlm(session.scene.camera.targetMm));
  if (!place) return;
  const ImU32 color = colorOf(sun.irradiance, 0.9F);
  const float radius = 0.35F * ImGui::GetFontSize();
  constexpr int rays = 8;
  for (int i = 0; i < rays; ++i) {
    const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / rays;
    const glm::vec2 along(std::cos(angle), std::sin(angle));
    const glm::vec2 from = *place + 1.4F * radius * along;
    const glm::vec2 to = *place + 2.3F * radius * along;
    list.AddLine({from.x, from.y}, {to.x, to.y}, color, 1.5F);
  }
  list.AddCircle({place->x, place->y}, radius, color, 0, 1.5F);
  if (target)
    list.AddLine({place->x, place->y}, {target->x, target->y}, colorOf(sun.irradiance, 0.25F), 1);
}

// The other end of a handle's line: the light's own place for an aim or a normal, and the camera's
// target for a directional light.
std::optional<glm::vec3> endOfLine(const Session& session, const LightHandle& handle,
                                   const LightEntry& entry) {
  if (handle.part == LightPart::Aim)
    return toGlm(session.scene.lighting.spots[entry.index].positionMm);
  if (handle.part == LightPart::Grip && handle.grip == AreaGrip::Kind::Normal)
    return middleOfArea(session.scene.lighting.areas[entry.index]);
  if (entry.kind == LightKind::Directional) return toGlm(session.scene.camera.targetMm);
  return std::nullopt;
}

// A handle that only turns its light is anywhere on the light's axis.
bool turns(const LightHandle& handle) {
  return handle.part == LightPart::Aim ||
         (handle.part == LightPart::Grip && handle.grip == AreaGrip::Kind::Normal);
}

bool isSame(const LightHandle& a, const LightHandle& b) {
  return a.light == b.light && a.part == b.part && a.grip == b.grip;
}

}  // namespace

float reachOfHandles() {
  constexpr float reach = 14;
  return reach * ImGui::GetIO().DisplayFramebufferScale.x;
}

// The sphere is large enough that handles stand beside the body, and small enough that they are in
// the picture.
float radiusOfSphereMm(const Session& session, const Projection& projection) {
  return std::min(0.55F * session.diagonalMm, 0.24F * projection.view().distanceMm);
}

std::vector<glm::vec3> placesOfHandles(const Session& session, const Projection& projection) {
  std::vector<glm::vec3> places;
  for (const LightHandle& handle : handlesOf(session, projection)) places.push_back(handle.placeMm);
  return places;
}

std::vector<LightHandle> LightHandles::shown(const Session& session,
                                             const Projection& projection) const {
  std::vector<LightHandle> handles = handlesOf(session, projection);
  if (!grabbed_ || !turns(*grabbed_)) return handles;
  for (LightHandle& handle : handles)
    if (isSame(handle, *grabbed_)) handle.placeMm = grabbed_->placeMm;
  return handles;
}

std::optional<LightHandle> LightHandles::at(const Session& session, const Projection& projection,
                                            const glm::vec2& pixel) const {
  std::optional<LightHandle> nearest;
  const float reach = reachOfHandles();
  float least = reach;
  for (const LightHandle& handle : shown(session, projection)) {
    const std::optional<glm::vec2> place = projection.toWindow(handle.placeMm);
    if (!place) continue;
    const float distance = glm::length(*place - pixel);
    const float lead = handle.light == session.light ? tieInReaches * reach : 0;
    if (distance > reach || distance - lead > least) continue;
    least = distance - lead;
    nearest = handle;
  }
  return nearest;
}

void LightHandles::grab(const Session& session, const Projection& projection,
                        const LightHandle& handle, const glm::vec2& pixel) {
  grabbed_ = handle;
  const LightEntry entry = entryOf(session.scene.lighting, static_cast<std::size_t>(handle.light));
  const glm::vec3& ahead = projection.view().ahead;
  const float depth = glm::dot(handle.placeMm - toGlm(session.scene.camera.targetMm), ahead);
  inFront_ = depth <= 0;
  // A place on the sphere is dragged in the plane through the sphere's middle.
  const bool onSphere = entry.kind == LightKind::Directional;
  const glm::vec3 dragged = handle.placeMm - (onSphere ? depth : 0) * ahead;
  offset_ = projection.toWindow(dragged).value_or(pixel) - pixel;
}

bool LightHandles::drag(Session& session, const Projection& projection, const glm::vec2& pixel) {
  Lighting& lighting = session.scene.lighting;
  if (!grabbed_ || static_cast<std::size_t>(grabbed_->light) >= countOf(lighting)) return false;
  const LightEntry entry = entryOf(lighting, static_cast<std::size_t>(grabbed_->light));
  const ViewFrame& view = projection.view();
  const glm::vec3 target = toGlm(session.scene.camera.targetMm);
  const glm::vec3 about = entry.kind == LightKind::Directional ? target : grabbed_->placeMm;
  // The place of the mouse in the plane through the handle, parallel to the picture.
  const Ray ray = projection.through(pixel + offset_);
  const float along = glm::dot(ray.direction, view.ahead);
  const float depth = glm::dot(about - ray.origin, view.ahead);
  if (!(along > 0) || !(depth > 0)) return false;
  const glm::vec3 place = ray.origin + depth / along * ray.direction;
  if (turns(*grabbed_)) grabbed_->placeMm = place;
  switch (entry.kind) {
    case LightKind::Directional:
      lighting.directional[entry.index].directionToLight = fromGlm(
          onSphere((place - about) / radiusOfSphereMm(session, projection), inFront_, view.ahead));
      return true;
    case LightKind::Point:
      lighting.points[entry.index].positionMm = fromGlm(place);
      return true;
    case LightKind::Area: {
      AreaLight& area = lighting.areas[entry.index];
      if (grabbed_->part == LightPart::Place)
        moveArea(place, area);
      else
        dragGrip(grabbed_->grip, place, area);
      return true;
    }
    case LightKind::Spot:
      break;
  }
  SpotLight& spot = lighting.spots[entry.index];
  if (grabbed_->part == LightPart::Place) {
    spot.positionMm = fromGlm(place);
    return true;
  }
  const glm::vec3 axis = place - toGlm(spot.positionMm);
  if (!(glm::length(axis) > 1e-6F * session.diagonalMm)) return false;
  spot.direction = fromGlm(glm::normalize(axis));
  return true;
}

void LightHandles::draw(const Session& session, const Projection& projection,
                        ImDrawList& list) const {
  const Lighting& lighting = session.scene.lighting;
  for (const DirectionalLight& sun : session.suns) drawSun(sun, session, projection, list);
  for (const LightHandle& handle : shown(session, projection)) {
    const std::optional<glm::vec2> place = projection.toWindow(handle.placeMm);
    if (!place) continue;
    const LightEntry entry = entryOf(lighting, static_cast<std::size_t>(handle.light));
    const Rgb power = powerOf(lighting, entry);
    const glm::vec3 offset = handle.placeMm - toGlm(session.scene.camera.targetMm);
    const bool behind = glm::dot(offset, projection.view().ahead) > 0;
    const ImVec2 middle(place->x, place->y);
    const bool main = handle.part == LightPart::Place;
    const float radius = (main ? 0.45F : 0.3F) * ImGui::GetFontSize();
    if (main && entry.kind == LightKind::Area)
      drawOutline(lighting.areas[entry.index], projection, colorOf(power, behind ? 0.4F : 0.8F),
                  list);
    const auto from = endOfLine(session, handle, entry);
    if (const auto end = from ? projection.toWindow(*from) : std::nullopt)
      list.AddLine(middle, {end->x, end->y}, colorOf(power, behind ? 0.25F : 0.5F), 1);
    // A ring if it is behind the body, a disc if it is in front.
    if (behind || !main) {
      list.AddCircleFilled(middle, radius, IM_COL32(20, 20, 22, 160));
      list.AddCircle(middle, radius, colorOf(power, 1), 0, 2.5F);
    } else {
      list.AddCircleFilled(middle, radius, colorOf(power, 1));
    }
    const bool isGrabbed = grabbed_ && handle.light == grabbed_->light;
    if (main && (handle.light == session.light || isGrabbed))
      list.AddCircle(middle, 1.6F * radius, IM_COL32(255, 255, 255, 200), 0, 1.5F);
  }
}

}  // namespace opaline::app::viewer
