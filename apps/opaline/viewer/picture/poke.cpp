#include "viewer/picture/poke.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "opaline/positions.h"
#include "viewer/picture/vectors.h"

namespace opaline::app::viewer {

namespace {

struct Hit {
  float distanceMm = std::numeric_limits<float>::infinity();
  std::size_t object = 0;
  std::size_t triangle = 0;
  std::array<glm::vec3, 3> corners{};  // of the triangle
  float u = 0;
  float v = 0;
};

// Möller and Trumbore 1997.
void meet(const Ray& ray, const std::array<glm::vec3, 3>& corners, Hit& nearest, std::size_t object,
          std::size_t triangle) {
  const glm::vec3 ab = corners[1] - corners[0];
  const glm::vec3 ac = corners[2] - corners[0];
  const glm::vec3 p = glm::cross(ray.direction, ac);
  const float determinant = glm::dot(ab, p);
  if (!(std::abs(determinant) > 0)) return;
  const glm::vec3 offset = ray.origin - corners[0];
  const float u = glm::dot(offset, p) / determinant;
  const glm::vec3 q = glm::cross(offset, ab);
  const float v = glm::dot(ray.direction, q) / determinant;
  const float t = glm::dot(ac, q) / determinant;
  if (u < 0 || v < 0 || u + v > 1 || !(t > 0) || t >= nearest.distanceMm) return;
  nearest = {t, object, triangle, corners, u, v};
}

std::array<glm::vec3, 3> cornersOf(const std::vector<Vec3>& vertices, const Triangle& triangle) {
  return {toGlm(vertices[triangle[0]]), toGlm(vertices[triangle[1]]), toGlm(vertices[triangle[2]])};
}

glm::vec3 within(const std::array<glm::vec3, 3>& corners, float u, float v) {
  return (1 - u - v) * corners[0] + u * corners[1] + v * corners[2];
}

// A right-handed frame: along the first edge, across it, outwards.
glm::mat3 frameOf(const std::array<glm::vec3, 3>& corners) {
  const glm::vec3 along = glm::normalize(corners[1] - corners[0]);
  const glm::vec3 out = glm::normalize(glm::cross(along, corners[2] - corners[0]));
  return {along, glm::cross(out, along), out};
}

bool finite(const glm::mat3& matrix) {
  const auto* values = &matrix[0][0];
  return std::all_of(values, values + 9, [](float value) { return std::isfinite(value); });
}

}  // namespace

bool Poke::grab(Session& session, const Ray& ray) {
  Scene& scene = session.scene;
  const std::vector<Object>& objects = scene.objects;
  const auto vertices = positionsAt(scene, session.time, session.positionsMm);
  Hit hit;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (objects[i].isGround) continue;
    const std::vector<Triangle>& triangles = objects[i].mesh.triangles;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      meet(ray, cornersOf(vertices[i], triangles[t]), hit, i, t);
    }
  }
  if (!std::isfinite(hit.distanceMm)) return false;
  const std::vector<Triangle>& triangles = objects[hit.object].mesh.triangles;
  std::vector<Deformer> deformers = std::exchange(scene.deformers, {});
  const std::vector<Vec3> restVertices =
      std::move(positionsAt(scene, session.time, session.positionsMm)[hit.object]);
  scene.deformers = std::move(deformers);
  const std::array<glm::vec3, 3> rest = cornersOf(restVertices, triangles[hit.triangle]);
  seen_ = within(hit.corners, hit.u, hit.v);
  rest_ = within(rest, hit.u, hit.v);
  back_ = frameOf(rest) * glm::transpose(frameOf(hit.corners));
  if (!finite(back_)) back_ = glm::mat3(1);
  const bool plays = session.sequence || (!session.scene.clips.empty() && session.time.clip >= 0);
  if (plays) session.playback.playing = false;
  constexpr float radiusInDiagonals = 0.08F;
  wanted_ = {hit.object, restVertices, triangles, radiusInDiagonals * session.diagonalMm};
  goal_ = fromGlm(rest_);
  held_ = true;
  return true;
}

void Poke::pull(const Projection& projection, const glm::vec2& pixel) {
  if (!held_) return;
  const Ray ray = projection.through(pixel);
  const glm::vec3& ahead = projection.view().ahead;
  const float along = glm::dot(ray.direction, ahead);
  const float depth = glm::dot(seen_ - ray.origin, ahead);
  if (!(along > 0) || !(depth > 0)) return;
  const glm::vec3 to = ray.origin + depth / along * ray.direction;
  const glm::vec3 wanted = rest_ + back_ * (to - seen_);
  if (std::isfinite(wanted.x) && std::isfinite(wanted.y) && std::isfinite(wanted.z)) {
    goal_ = fromGlm(wanted);
  }
}

void Poke::take() {
  const Grab grab = *std::exchange(wanted_, std::nullopt);
  if (!body_ || object_ != grab.object) {
    body_.reset();
    body_.emplace(renderer_, grab.object, grab.restMm, grab.triangles);
    object_ = grab.object;
  }
  body_->grab(fromGlm(rest_), grab.radiusMm);
}

void Poke::release() {
  held_ = false;
  wanted_.reset();  // released before the body was taken hold of
}

void Poke::advance(double seconds) {
  // No more than a swing's duration is owed, however long the wait.
  constexpr double longest = 3;
  owedSeconds_ = body_ ? std::min(owedSeconds_ + seconds, longest) : 0;
}

bool Poke::step() {
  if (wanted_) take();
  if (!body_) return false;
  if (!moves()) {
    end();
    return true;
  }
  if (held_) {
    body_->pull(goal_);
  } else {
    body_->release();
  }
  for (double left = std::exchange(owedSeconds_, 0); left > 0; left -= SoftBody::maxStepSeconds) {
    body_->step(std::min(left, SoftBody::maxStepSeconds));
  }
  return true;
}

void Poke::end() {
  held_ = false;
  wanted_.reset();
  body_.reset();
}

}  // namespace opaline::app::viewer
