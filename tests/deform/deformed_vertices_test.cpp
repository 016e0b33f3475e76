#include "deform/deformed_vertices.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "deform/deformer.h"
#include "deform/vectors.h"

namespace opaline::deform {
namespace {

using scene::Double3;

/// A triangle at a node that moves along x.
Scene riggedTriangle() {
  Scene scene;
  scene.nodes.push_back({"node"});
  Object object;
  object.name = "triangle";
  object.mesh.positionsMm = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  object.mesh.normals.assign(3, {0, 0, 1});
  object.mesh.triangles = {{0, 1, 2}};
  object.rig.emplace();
  object.rig->positions = object.mesh.positionsMm;
  object.rig->normals = object.mesh.normals;
  scene.objects.push_back(object);
  return scene;
}

TEST(DeformedVertices, AnObjectWithoutJointsFollowsItsNode) {
  Scene scene = riggedTriangle();
  scene.objects[0].rig->toScene = Affine{{{{10, 0, 0}, {0, 10, 0}, {0, 0, 10}, {0, 0, 0}}}};
  scene.clips.push_back(
      {"go",
       2,
       {{0, TrackTarget::Translation, Interpolation::Linear, {0, 2}, {0, 0, 0, 4, 0, 0}},
        {0, TrackTarget::Rotation, Interpolation::Step, {0}, {root, 0, 0, root}}}});
  const DeformedVertices mesh = deformedVertices(scene, 0, 0, 1);
  expectVector(mesh.positionsMm[0], {20, 0, 0}, 1e-5);
  expectVector(mesh.positionsMm[1], {30, 0, 0}, 1e-5);
  expectVector(mesh.positionsMm[2], {20, 0, 10}, 1e-5);  // a quarter turn about x takes y to z
  expectVector(mesh.normals[0], {0, -1, 0}, 1e-6);       // and z to −y
}

/// Two joints: one is fixed, the other has turned by a quarter about z around (0, 1, 0). Half of
/// each moves (0, 2, 0) to the middle between (0, 2, 0) and (−1, 1, 0).
TEST(DeformedVertices, TwoJointsBlend) {
  Scene scene = riggedTriangle();
  scene.nodes.push_back({"still"});
  scene.nodes.push_back({"elbow", -1, {0, 1, 0}, {0, 0, root, root}});
  Rig& rig = *scene.objects[0].rig;
  rig.positions = {{0, 2, 0}, {0, 2, 0}, {1, 2, 0}};
  rig.normals = {{1, 0, 0}, {1, 0, 0}, {0, 0, 1}};
  rig.joints = {{1, {}}, {2, Affine{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}}}}}};
  rig.firstInfluence = {0, 1, 3, 4};
  rig.influences = {{0, 1}, {0, 0.5F}, {1, 0.5F}, {1, 1}};
  // The node of a skinned object does not move it.
  scene.nodes[0].translation = {100, 0, 0};
  const DeformedVertices mesh = deformedVertices(scene, 0, -1, 0);
  expectVector(mesh.positionsMm[0], {0, 2, 0});
  expectVector(mesh.positionsMm[1], {-0.5, 1.5, 0});
  expectVector(mesh.positionsMm[2], {-1, 2, 0});
  expectVector(mesh.normals[0], {1, 0, 0});
  // The mean matrix's columns are (½, ½, 0), (−½, ½, 0), (0, 0, 1): an eighth of a turn.
  expectVector(mesh.normals[1], {std::sqrt(0.5), std::sqrt(0.5), 0});
  expectVector(mesh.normals[2], {0, 0, 1});
}

TEST(DeformedVertices, MorphsBeforeItSkins) {
  Scene scene = riggedTriangle();
  scene.nodes[0].morphWeights = {0.5F, 2};
  scene.nodes.push_back({"joint", -1, {0, 0, 0}, {0, 0, root, root}});
  Rig& rig = *scene.objects[0].rig;
  rig.targets = {{{{2, 0, 0}, {2, 0, 0}, {2, 0, 0}}, {{2, 0, -2}, {0, 0, 0}, {0, 0, 0}}},
                 {{{0, 0, 1}, {0, 0, 0}, {0, 0, 0}}, {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}}};
  rig.joints = {{1, {}}};
  rig.firstInfluence = {0, 1, 2, 3};
  rig.influences = {{0, 1}, {0, 1}, {0, 1}};
  const DeformedVertices mesh = deformedVertices(scene, 0, -1, 0);
  // (0,0,0) + ½(2,0,0) + 2(0,0,1) = (1,0,2), turned about z.
  expectVector(mesh.positionsMm[0], {0, 1, 2});
  expectVector(mesh.positionsMm[1], {0, 2, 0});
  expectVector(mesh.positionsMm[2], {-1, 1, 0});
  expectVector(mesh.normals[0], {0, 1, 0});
}

TEST(DeformedVertices, NormalsComeFromTheTrianglesWhereTargetsHaveNone) {
  Scene scene = riggedTriangle();
  scene.nodes[0].morphWeights = {1};
  scene.objects[0].rig->targets = {{{{0, 0, 0}, {0, 0, 1}, {0, 0, 0}}, {}}};
  EXPECT_TRUE(normalsFromTriangles(scene.objects[0]));
  const DeformedVertices mesh = deformedVertices(scene, 0, -1, 0);
  // (1,0,1) × (0,1,0) = (−1, 0, 1).
  for (const Double3& n : mesh.normals) expectVector(n, {-std::sqrt(0.5), 0, std::sqrt(0.5)});
}

/// A scale of (1, 1, 2) tilts the plane with normal (0, 1, 1) to (0, 2, 1).
TEST(DeformedVertices, NormalsFollowUnevenScale) {
  Scene scene = riggedTriangle();
  scene.nodes[0].scale = {1, 1, 2};
  scene.objects[0].rig->normals.assign(3, {0, root, root});
  const DeformedVertices mesh = deformedVertices(scene, 0, -1, 0);
  expectVector(mesh.normals[0], {0, 2 / std::sqrt(5.0), 1 / std::sqrt(5.0)});
  // Mirrored, they still point outwards.
  scene.nodes[0].scale = {-1, 1, 2};
  expectVector(deformedVertices(scene, 0, -1, 0).normals[0],
               {0, 2 / std::sqrt(5.0), 1 / std::sqrt(5.0)});
}

TEST(DeformedVertices, DeformersFollowInTheirOrder) {
  Scene scene = riggedTriangle();
  scene.objects[0].rig.reset();
  scene.deformers = {{DeformerKind::Squash, 0.75F, 0}, {DeformerKind::Twist, 2, 0}};
  const Bounds box = boundsOf(scene);
  const DeformedVertices mesh = deformedVertices(scene, 0, -1, 0.3);
  for (std::size_t v = 0; v < 3; ++v) {
    SurfacePoint point{scene::toDouble(scene.objects[0].mesh.positionsMm[v]), {0, 0, 1}};
    point = deformed(scene.deformers[0], box, 0.3, point);
    point = deformed(scene.deformers[1], box, 0.3, point);
    expectVector(mesh.positionsMm[v], point.position, 1e-12);
    expectVector(mesh.normals[v], point.normal, 1e-12);
  }
}

TEST(DeformedVertices, FacetsKeepTheirTrianglesNormal) {
  Scene scene = riggedTriangle();
  scene.objects[0].rig.reset();
  scene.objects[0].mesh.facetted = true;
  scene.deformers = {{DeformerKind::Twist, 2, 0}};
  const DeformedVertices mesh = deformedVertices(scene, 0, -1, 0);
  const auto& p = mesh.positionsMm;
  const Double3 area = scene::areaVector(p[0], p[1], p[2]);
  for (const Double3& n : mesh.normals) {
    EXPECT_NEAR(scene::dot(n, area), scene::length(area), 1e-12);
  }
}

// Two triangles of a roof, halved along its slope by a seam of texture coordinates. The seam's
// vertices exist twice, but stay one smooth surface when the roof is bent along it.
TEST(DeformedVertices, VerticesOnASeamShareTheirNormal) {
  Scene scene;
  Object object;
  object.mesh.positionsMm = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {0, 1, 0}, {-1, 0, 0}};
  object.mesh.normals.assign(6, {0, 0, 1});
  object.mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
  Rig rig;
  rig.positions = object.mesh.positionsMm;
  rig.normals = object.mesh.normals;
  // Both sides go down by 1: their normals lean apart by equal angles, and their mean points up.
  rig.targets = {{{{0, 0, 0}, {0, 0, -1}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, -1}}, {}}};
  object.rig = rig;
  Node node;
  node.morphWeights = {1};
  scene.nodes = {node};
  scene.objects = {object};
  const DeformedVertices mesh = deformedVertices(scene, 0, -1, 0);
  for (const std::size_t v : {0U, 2U, 3U, 4U}) EXPECT_NEAR(mesh.normals[v][2], 1, 1e-12) << v;
  EXPECT_NEAR(mesh.normals[1][2], std::sqrt(0.5), 1e-12);
}

}  // namespace
}  // namespace opaline::deform
