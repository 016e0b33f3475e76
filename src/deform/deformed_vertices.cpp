#include "deform/deformed_vertices.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/possible_position.h"
#include "deform/deformer.h"
#include "deform/smooth_groups.h"
#include "opaline/error.h"
#include "opaline/options/picture.h"
#include "scene/matrix.h"
#include "scene/mesh/normals.h"

namespace opaline::deform {

namespace {

using scene::Double3;
using scene::Matrix4;
using scene::Pose;
using scene::operator*;
using scene::operator+;
using scene::toDouble;

Double3 unitOr(const Double3& v, const Double3& other) {
  const double size = scene::length(v);
  return size > 0 && scene::isFinite(v) ? (1 / size) * v : other;
}

SurfacePoint morphed(const Rig& rig, std::span<const float> weights, std::size_t v) {
  SurfacePoint point{toDouble(rig.positions[v]), toDouble(rig.normals[v])};
  for (std::size_t t = 0; t < rig.targets.size(); ++t) {
    const MorphTarget& target = rig.targets[t];
    const double weight{weights[t]};
    if (!target.positions.empty()) {
      point.position = point.position + weight * toDouble(target.positions[v]);
    }
    if (!target.normals.empty()) point.normal = point.normal + weight * toDouble(target.normals[v]);
  }
  return point;
}

Matrix4 mapOf(const Rig& rig, std::span<const Matrix4> matrices, std::size_t v) {
  scene::MatrixSum sum;
  for (std::size_t i = rig.firstInfluence[v]; i < rig.firstInfluence[v + 1]; ++i) {
    sum.add(double{rig.influences[i].weight}, matrices[rig.influences[i].joint]);
  }
  return sum.weight() > 0 ? sum.mean() : matrices[0];
}

DeformedVertices rigged(const Rig& rig, const Pose& pose) {
  std::vector<Matrix4> matrices(std::max<std::size_t>(rig.joints.size(), 1));
  jointMatrices(rig, pose, matrices);
  const std::span<const float> weights = morphWeights(rig, pose);
  DeformedVertices mesh;
  for (std::size_t v = 0; v < rig.positions.size(); ++v) {
    const SurfacePoint point = morphed(rig, weights, v);
    const Matrix4 map = rig.joints.empty() ? matrices[0] : mapOf(rig, matrices, v);
    mesh.positionsMm.push_back(map.point(point.position));
    mesh.normals.push_back(unitOr(map.normal(point.normal), {0, 0, 1}));
  }
  return mesh;
}

DeformedVertices resting(const Mesh& mesh) {
  DeformedVertices result;
  for (const Vec3& p : mesh.positionsMm) result.positionsMm.push_back(toDouble(p));
  for (const Vec3& n : mesh.normals) result.normals.push_back(unitOr(toDouble(n), {0, 0, 1}));
  return result;
}

SurfacePoint under(const std::vector<Deformer>& deformers, SurfacePoint point,
                   const Bounds& restBox, double seconds) {
  for (const Deformer& deformer : deformers) point = deformed(deformer, restBox, seconds, point);
  return point;
}

/// Normals follow by cofactors.
DeformedVertices moved(const Scene& scene, const Object& object, const Pose& pose,
                       const Bounds& restBox, double seconds) {
  DeformedVertices mesh = object.rig ? rigged(*object.rig, pose) : resting(object.mesh);
  for (std::size_t v = 0; v < mesh.positionsMm.size(); ++v) {
    const SurfacePoint point =
        under(scene.deformers, {mesh.positionsMm[v], mesh.normals[v]}, restBox, seconds);
    mesh.positionsMm[v] = point.position;
    mesh.normals[v] = point.normal;
  }
  return mesh;
}

void facet(const std::vector<Triangle>& triangles, double side, DeformedVertices& mesh) {
  for (const Triangle& t : triangles) {
    const Double3 area =
        scene::areaVector(mesh.positionsMm[t[0]], mesh.positionsMm[t[1]], mesh.positionsMm[t[2]]);
    for (const std::uint32_t v : t) mesh.normals[v] = unitOr(side * area, mesh.normals[v]);
  }
}

bool mirrorsAt(const Rig& rig, const Pose& pose) {
  std::vector<Matrix4> matrices(std::max<std::size_t>(rig.joints.size(), 1));
  jointMatrices(rig, pose, matrices);
  return mirrors(matrices);
}

/// -1 if exactly one of the pose and the rest pose mirrors the object, else 1.
double sideOf(const Scene& scene, const Object& object, const Pose& pose) {
  if (!object.rig) return 1;
  return mirrorsAt(*object.rig, pose) == mirrorsAt(*object.rig, scene::makePose(scene)) ? 1 : -1;
}

void smooth(const Mesh& rest, double side, DeformedVertices& mesh) {
  const std::vector<std::uint32_t> groups = smoothGroups(rest);
  std::vector<Triangle> triangles = rest.triangles;
  for (Triangle& t : triangles) {
    for (std::uint32_t& v : t) v = groups[v];
  }
  const std::vector<Double3> normals = scene::smoothNormals(mesh.positionsMm, triangles);
  for (std::size_t v = 0; v < groups.size(); ++v) mesh.normals[v] = side * normals[groups[v]];
}

}  // namespace

void requireTime(const Scene& scene, const SceneTime& time) {
  if (const std::string complaint = options::complaintAbout(time); !complaint.empty())
    throw UsageError(complaint);
  if (time.clip > 0 && static_cast<std::size_t>(time.clip) >= scene.clips.size())
    throw UsageError(
        fmt::format("there is no clip {}: the scene has {}", time.clip, scene.clips.size()));
}

void requireFit(const Scene& scene, const PositionsByObject& positionsMm) {
  for (const auto& [object, positions] : positionsMm) {
    if (object >= scene.objects.size() ||
        positions.size() != scene.objects[object].mesh.positionsMm.size())
      throw UsageError(
          fmt::format("the {} positions given do not fit object {}", positions.size(), object));
    const auto bad = std::find_if_not(positions.begin(), positions.end(), core::isPossible);
    if (bad != positions.end())
      throw UsageError(fmt::format(
          "the position given for vertex {} of object {} is not finite, or beyond 1e18 mm",
          bad - positions.begin(), object));
  }
}

bool normalsFromTriangles(const Object& object) {
  if (object.mesh.facetted) return true;
  if (!object.rig) return false;
  const std::vector<MorphTarget>& targets = object.rig->targets;
  return std::any_of(targets.begin(), targets.end(),
                     [](const MorphTarget& target) { return target.normals.empty(); });
}

std::vector<Double3> deformedPositions(const Scene& scene, std::size_t object, const Pose& pose,
                                       const Bounds& restBox, double seconds) {
  return moved(scene, scene.objects[object], pose, restBox, seconds).positionsMm;
}

std::vector<Double3> deformedPositions(const std::vector<Deformer>& deformers,
                                       const std::vector<Vec3>& positionsMm, const Bounds& restBox,
                                       double seconds) {
  std::vector<Double3> result;
  result.reserve(positionsMm.size());
  for (const Vec3& p : positionsMm) {
    result.push_back(under(deformers, {toDouble(p), {0, 0, 1}}, restBox, seconds).position);
  }
  return result;
}

DeformedVertices deformedVertices(const Scene& scene, std::size_t object, const Pose& pose,
                                  const Bounds& restBox, double seconds) {
  const Object& of = scene.objects[object];
  DeformedVertices mesh = moved(scene, of, pose, restBox, seconds);
  if (of.mesh.facetted) {
    facet(of.mesh.triangles, sideOf(scene, of, pose), mesh);
  } else if (normalsFromTriangles(of)) {
    smooth(of.mesh, sideOf(scene, of, pose), mesh);
  }
  return mesh;
}

DeformedVertices deformedVertices(const Scene& scene, std::size_t object, int clip,
                                  double seconds) {
  Pose pose = scene::makePose(scene);
  poseAt(scene, clip, seconds, pose);
  return deformedVertices(scene, object, pose, boundsOf(scene), seconds);
}

}  // namespace opaline::deform
