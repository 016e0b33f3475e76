#include "scene/shapes.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace opaline::test {

std::size_t badEdges(const std::vector<Triangle>& triangles) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
  for (const Triangle& t : triangles) {
    for (std::size_t c = 0; c < 3; ++c) ++sides[{t[c], t[(c + 1) % 3]}];
  }
  std::size_t bad = 0;
  for (const auto& [side, count] : sides) bad += count > 1 ? 1U : 0U;
  return bad;
}

namespace {

bool finite(const std::vector<float>& values) {
  return std::all_of(values.begin(), values.end(), [](float v) { return std::isfinite(v); });
}

void expectSoundTrack(const Scene& scene, const Track& track) {
  ASSERT_LT(track.node, scene.nodes.size());
  ASSERT_FALSE(track.seconds.empty());
  ASSERT_TRUE(finite(track.seconds) && finite(track.values));
  for (std::size_t k = 1; k < track.seconds.size(); ++k) {
    ASSERT_LT(track.seconds[k - 1], track.seconds[k]);
  }
  const std::size_t parts = track.interpolation == Interpolation::CubicSpline ? 3 : 1;
  ASSERT_EQ(track.values.size() % (parts * track.seconds.size()), 0U);
  const std::size_t width = track.values.size() / (parts * track.seconds.size());
  switch (track.target) {
    case TrackTarget::Rotation:
      ASSERT_EQ(width, 4U);
      return;
    case TrackTarget::Translation:
    case TrackTarget::Scale:
      ASSERT_EQ(width, 3U);
      return;
    case TrackTarget::MorphWeights:
      ASSERT_GT(width, 0U);
      return;
  }
}

void expectSoundRig(const Scene& scene, const Object& object) {
  const Rig& rig = *object.rig;
  const std::size_t vertices = object.mesh.positionsMm.size();
  ASSERT_LT(rig.node, scene.nodes.size());
  ASSERT_EQ(rig.positions.size(), vertices);
  ASSERT_EQ(rig.normals.size(), vertices);
  for (std::size_t v = 0; v < vertices; ++v) {
    ASSERT_TRUE(finite({rig.positions[v].begin(), rig.positions[v].end()}));
    const Vec3& n = rig.normals[v];
    ASSERT_NEAR(std::hypot(n[0], n[1], n[2]), 1.0F, 1e-4F);
  }
  for (const MorphTarget& target : rig.targets) {
    ASSERT_EQ(target.positions.size(), vertices);
    ASSERT_TRUE(target.normals.empty() || target.normals.size() == vertices);
  }
  ASSERT_EQ(rig.firstInfluence.size(), rig.joints.empty() ? 0 : vertices + 1);
  for (const Joint& joint : rig.joints) ASSERT_LT(joint.node, scene.nodes.size());
  if (rig.joints.empty()) return;
  ASSERT_EQ(rig.firstInfluence.back(), rig.influences.size());
  for (std::size_t v = 0; v < vertices; ++v) {
    float sum = 0;
    for (std::size_t i = rig.firstInfluence[v]; i < rig.firstInfluence[v + 1]; ++i) {
      ASSERT_LT(rig.influences[i].joint, rig.joints.size());
      sum += rig.influences[i].weight;
    }
    ASSERT_NEAR(sum, 1.0F, 1e-5F);
  }
}

}  // namespace

void expectSound(const Scene& scene) {
  ASSERT_FALSE(scene.objects.empty());
  for (std::size_t n = 0; n < scene.nodes.size(); ++n) {
    ASSERT_LT(scene.nodes[n].parent, static_cast<int>(n));
  }
  for (const Clip& clip : scene.clips) {
    for (const Track& track : clip.tracks) expectSoundTrack(scene, track);
  }
  for (const Object& object : scene.objects) {
    if (object.rig) expectSoundRig(scene, object);
  }
  for (const Object& object : scene.objects) {
    const Mesh& mesh = object.mesh;
    ASSERT_FALSE(mesh.triangles.empty());
    ASSERT_EQ(mesh.positionsMm.size(), mesh.normals.size());
    for (const Triangle& t : mesh.triangles) {
      for (const std::uint32_t v : t) ASSERT_LT(v, mesh.positionsMm.size());
    }
    for (std::size_t v = 0; v < mesh.normals.size(); ++v) {
      const Vec3& p = mesh.positionsMm[v];
      const Vec3& n = mesh.normals[v];
      ASSERT_TRUE(std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]));
      ASSERT_NEAR(std::hypot(n[0], n[1], n[2]), 1.0F, 1e-4F);
    }
    ASSERT_EQ(badEdges(mesh.triangles), 0U);
  }
  ASSERT_TRUE(std::isfinite(diagonalMm(scene)));
}

}  // namespace opaline::test
