#include "viewer/picture/light_handles.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "viewer/picture/vectors.h"

namespace opaline::app::viewer {

namespace {

constexpr float reachPixels = 14;

std::size_t lightCount(const Session& session) {
  const Lighting& lighting = session.scene.lighting;
  return lighting.directional.size() + lighting.points.size();
}

// So large that the handles stand beside the body and within the picture.
float sphereMm(const Session& session, const Projection& projection) {
  return std::min(0.55F * session.diagonalMm, 0.24F * projection.view().distanceMm);
}

glm::vec3 placeOf(const Session& session, const Projection& projection, std::size_t light) {
  const Lighting& lighting = session.scene.lighting;
  if (light >= lighting.directional.size()) {
    return toGlm(lighting.points[light - lighting.directional.size()].positionMm);
  }
  return toGlm(session.scene.camera.targetMm) +
         sphereMm(session, projection) *
             glm::normalize(toGlm(lighting.directional[light].directionToLight));
}

ImU32 colorOf(const Rgb& power, float alpha) {
  const float most = std::max({power[0], power[1], power[2], 1e-6F});
  return ImGui::GetColorU32(ImVec4(std::sqrt(power[0] / most), std::sqrt(power[1] / most),
                                   std::sqrt(power[2] / most), alpha));
}

}  // namespace

int LightHandles::at(const Session& session, const Projection& projection,
                     const glm::vec2& pixel) const {
  int nearest = -1;
  float least = reachPixels * ImGui::GetIO().DisplayFramebufferScale.x;
  for (std::size_t i = 0; i < lightCount(session); ++i) {
    const std::optional<glm::vec2> place = projection.toWindow(placeOf(session, projection, i));
    if (!place) continue;
    const float distance = glm::length(*place - pixel);
    if (distance > least) continue;
    least = distance;
    nearest = static_cast<int>(i);
  }
  return nearest;
}

void LightHandles::grab(const Session& session, const Projection& projection, int light) {
  grabbed_ = light;
  const glm::vec3 offset = placeOf(session, projection, static_cast<std::size_t>(light)) -
                           toGlm(session.scene.camera.targetMm);
  inFront_ = glm::dot(offset, projection.view().ahead) <= 0;
}

bool LightHandles::drag(Session& session, const Projection& projection,
                        const glm::vec2& pixel) const {
  if (grabbed_ < 0 || static_cast<std::size_t>(grabbed_) >= lightCount(session)) return false;
  const auto light = static_cast<std::size_t>(grabbed_);
  Lighting& lighting = session.scene.lighting;
  const ViewFrame& view = projection.view();
  const bool directional = light < lighting.directional.size();
  const glm::vec3 about =
      directional ? toGlm(session.scene.camera.targetMm) : placeOf(session, projection, light);
  // Where the mouse is in the plane through that, parallel to the picture.
  const Ray ray = projection.through(pixel);
  const float along = glm::dot(ray.direction, view.ahead);
  const float depth = glm::dot(about - ray.origin, view.ahead);
  if (!(along > 0) || !(depth > 0)) return false;
  const glm::vec3 place = ray.origin + depth / along * ray.direction;
  if (!directional) {
    lighting.points[light - lighting.directional.size()].positionMm = fromGlm(place);
    return true;
  }
  const glm::vec3 offset = (place - about) / sphereMm(session, projection);
  float across = glm::length(offset);
  if (!(across > 1e-6F)) {
    lighting.directional[light].directionToLight = fromGlm(inFront_ ? -view.ahead : view.ahead);
    return true;
  }
  const glm::vec3 outwards = offset / across;
  bool front = inFront_;
  if (across > 1) {  // past the rim
    front = !front;
    across = std::max(0.0F, 2 - across);
  }
  const float towards = std::sqrt(std::max(0.0F, 1 - across * across));
  lighting.directional[light].directionToLight =
      fromGlm(glm::normalize(across * outwards + (front ? -towards : towards) * view.ahead));
  return true;
}

void LightHandles::draw(const Session& session, const Projection& projection,
                        ImDrawList& list) const {
  const Lighting& lighting = session.scene.lighting;
  const std::optional<glm::vec2> target = projection.toWindow(toGlm(session.scene.camera.targetMm));
  for (std::size_t i = 0; i < lightCount(session); ++i) {
    const glm::vec3 spot = placeOf(session, projection, i);
    const std::optional<glm::vec2> place = projection.toWindow(spot);
    if (!place) continue;
    const bool directional = i < lighting.directional.size();
    const Rgb& power = directional ? lighting.directional[i].irradiance
                                   : lighting.points[i - lighting.directional.size()].intensity;
    const glm::vec3 offset = spot - toGlm(session.scene.camera.targetMm);
    const bool behind = glm::dot(offset, projection.view().ahead) > 0;
    const ImVec2 middle(place->x, place->y);
    const float radius = 0.45F * ImGui::GetFontSize();
    if (directional && target) {
      list.AddLine(middle, {target->x, target->y}, colorOf(power, behind ? 0.25F : 0.5F), 1);
    }
    // Behind the body a ring, before it a disc.
    if (behind) {
      list.AddCircleFilled(middle, radius, IM_COL32(20, 20, 22, 160));
      list.AddCircle(middle, radius, colorOf(power, 1), 0, 2.5F);
    } else {
      list.AddCircleFilled(middle, radius, colorOf(power, 1));
    }
    if (static_cast<int>(i) == session.light || static_cast<int>(i) == grabbed_) {
      list.AddCircle(middle, 1.6F * radius, IM_COL32(255, 255, 255, 200), 0, 1.5F);
    }
  }
}

}  // namespace opaline::app::viewer
