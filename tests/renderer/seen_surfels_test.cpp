// Aov::Surfels against the host's division of the same mesh: for every pixel's place the nearest
// piece is searched in double precision.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <vector>

#include "renderer/renderer_fixture.h"
#include "renderer/scene/division.h"
#include "renderer/shapes.h"
#include "scene/mesh/merged_mesh.h"
#include "surfels/tree.h"

namespace opaline {
namespace {

using namespace test;

using SeenSurfelsTest = RendererTest;

RenderOptions optionsOf(Transport transport, Sum sum = Sum::Tree) {
  RenderOptions options = smallOptions();
  options.width = options.height = 48;
  options.transport = transport;
  options.sum = sum;
  options.maxSurfels = 4096;
  options.maxClusters = 256;
  options.bounces = 0;
  return options;
}

// A ball in front of a box with edges, far from the origin.
Scene ballAndBox() {
  Scene scene = sceneOf(sphere({0, 0, 0}, 4, 2), skin(), {2, 5, 26}, 9);
  scene.objects.push_back(scene.objects[0]);
  scene.objects[1].mesh = box({5, -3, -4}, {3, 4, 2}, 3);
  scene.objects[1].medium = marble();
  scene.lighting.directional = {{{0.3F, 0.5F, 0.8F}, {1, 1, 1}}};
  return scene;
}

Vector crossOf(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double distanceToEdge(const Vector& p, const Vector& a, const Vector& b) {
  const double along = std::clamp(dot(p - a, b - a) / dot(b - a, b - a), 0.0, 1.0);
  return length(p - (a + along * (b - a)));
}

double distanceToTriangle(const Vector& p, const std::array<Vector, 3>& t) {
  const Vector normal = unit(crossOf(t[1] - t[0], t[2] - t[0]));
  double nearest = std::numeric_limits<double>::max();
  bool inside = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector& a = t[i];
    const Vector& b = t[(i + 1) % 3];
    inside = inside && dot(crossOf(b - a, p - a), normal) >= 0;
    nearest = std::min(nearest, distanceToEdge(p, a, b));
  }
  return inside ? std::abs(dot(p - t[0], normal)) : nearest;
}

/// The pieces of a division at the current positions of the vertices.
class Pieces {
 public:
  Pieces(const Division& division, const scene::MergedMesh& merged) : division_(division) {
    for (const surfels::Piece& piece : division.surfels.pieces) {
      std::array<Vector, 3> vertices;
      for (std::size_t i = 0; i < 3; ++i)
        vertices[i] = toVector(merged.positionsMm[merged.triangles[piece.triangle][i]]);
      std::array<Vector, 3> corners;
      for (std::size_t i = 0; i < 3; ++i) {
        const double v = static_cast<double>(piece.corners[i][0]);
        const double w = static_cast<double>(piece.corners[i][1]);
        corners[i] = (1 - v - w) * vertices[0] + (v * vertices[1] + w * vertices[2]);
      }
      corners_.push_back(corners);
    }
  }

  double distanceToSurfel(const Vector& p, std::uint32_t surfel) const {
    const std::uint32_t pieces = division_.surfels.piecesPerSurfel;
    double nearest = std::numeric_limits<double>::max();
    for (std::uint32_t i = pieces * surfel; i < pieces * (surfel + 1); ++i)
      if (division_.surfels.pieces[i].fraction > 0)
        nearest = std::min(nearest, distanceToTriangle(p, corners_[i]));
    return nearest;
  }

  double distanceToObject(const Vector& p, std::size_t object) const {
    double nearest = std::numeric_limits<double>::max();
    const std::vector<std::uint32_t>& first = division_.surfels.firstOfObject;
    for (std::uint32_t surfel = first[object]; surfel < first[object + 1]; ++surfel)
      nearest = std::min(nearest, distanceToSurfel(p, surfel));
    return nearest;
  }

 private:
  const Division& division_;
  std::vector<std::array<Vector, 3>> corners_;
};

struct SurfelRange {
  std::uint32_t first = 0;
  std::uint32_t end = 0;

  bool holds(const SurfelRange& other) const { return first <= other.first && other.end <= end; }
};

// The range of a node: from the first leaf below it to the last.
SurfelRange rangeOf(const surfels::Tree& tree, std::uint32_t node) {
  const surfels::NodeLink link = surfels::linkOf(tree, node);
  if (link.leaf) return {link.first, link.first + link.count};
  return {rangeOf(tree, node + 1).first, rangeOf(tree, link.end - 1).end};
}

Division divisionOf(const Scene& scene, const RenderOptions& options) {
  const bool boundary = options.transport == Transport::Boundary;
  const scene::MergedMesh merged = scene::mergedMesh(scene);
  return divide(merged, divisionFor(scene, merged,
                                    {std::vector<bool>(scene.objects.size(), true),
                                     std::vector<bool>(scene.objects.size(), false)},
                                    static_cast<std::size_t>(options.maxSurfels),
                                    boundary ? std::optional(options.maxClusters) : std::nullopt));
}

// `images`: Surfels, Position, Object.
void expectTrue(const std::vector<Image>& images, const Division& division, const Pieces& pieces) {
  constexpr double roundedMm = 2e-5;
  std::set<float> objects;
  const int covered = forEachCovered(images[1], [&](std::size_t i) {
    const auto object = static_cast<std::size_t>(images[2].rgba[i]);
    objects.insert(images[2].rgba[i]);
    const Vector place = toVector(&images[1].rgba[i]);
    ASSERT_EQ(images[0].rgba[i + 3], 1);
    ASSERT_GE(images[0].rgba[i], 0);
    const auto surfel = static_cast<std::uint32_t>(images[0].rgba[i]);
    ASSERT_EQ(static_cast<float>(surfel), images[0].rgba[i]);
    ASSERT_GE(surfel, division.surfels.firstOfObject[object]);
    ASSERT_LT(surfel, division.surfels.firstOfObject[object + 1]);
    EXPECT_LE(pieces.distanceToSurfel(place, surfel),
              pieces.distanceToObject(place, object) + roundedMm);
    const float cluster = images[0].rgba[i + 1];
    if (division.clusters) {
      ASSERT_GE(cluster, 0);
      const auto& its = division.clusters->clusters.at(static_cast<std::size_t>(cluster));
      EXPECT_LE(its.firstSurfel, surfel);
      EXPECT_GT(its.endSurfel, surfel);
    } else {
      EXPECT_EQ(cluster, -1);
    }
  });
  EXPECT_GT(covered, 400);
  EXPECT_EQ(objects.size(), division.surfels.firstOfObject.size() - 1);
}

const std::vector<Aov> asked{Aov::Surfels, Aov::Position, Aov::Object};

TEST_F(SeenSurfelsTest, EveryPixelShowsTheSurfelThatLiesThere) {
  const Scene scene = ballAndBox();
  renderer().setScene(scene);
  for (const Transport transport : {Transport::Dipole, Transport::Boundary})
    for (const Sum sum : {Sum::Tree, Sum::All}) {
      const RenderOptions options = optionsOf(transport, sum);
      const Division division = divisionOf(scene, options);
      expectTrue(render(options, asked), division, Pieces(division, scene::mergedMesh(scene)));
    }
}

TEST_F(SeenSurfelsTest, SurfelsOfManyTrianglesToo) {
  Scene scene = ballAndBox();
  scene.objects[0].mesh = sphere({0, 0, 0}, 4, 4);
  RenderOptions options = optionsOf(Transport::Dipole);
  options.maxSurfels = 1024;
  const Division division = divisionOf(scene, options);
  ASSERT_GT(division.surfels.piecesPerSurfel, 1U);
  expectTrue(render(scene, options, asked), division, Pieces(division, scene::mergedMesh(scene)));
}

// The division is that of the rest pose, wherever the vertices are.
TEST_F(SeenSurfelsTest, FollowTheBodyAsItDeforms) {
  const Scene scene = ballAndBox();
  Scene moved = scene;
  for (Vec3& p : moved.objects[0].mesh.positionsMm)
    p = {0.6F * p[1] + 1, 1.3F * p[0] - 0.2F * p[2] * p[2], p[2] + 0.3F * p[0]};
  for (const Transport transport : {Transport::BetterDipole, Transport::Boundary}) {
    const RenderOptions options = optionsOf(transport);
    const Division division = divisionOf(scene, options);
    renderer().setScene(scene);
    const Image atRest = render(options, asked)[0];
    renderer().replacePositions(0, moved.objects[0].mesh.positionsMm);
    const std::vector<Image> images = render(options, asked);
    EXPECT_NE(images[0].rgba, atRest.rgba);
    expectTrue(images, division, Pieces(division, scene::mergedMesh(moved)));
  }
}

TEST_F(SeenSurfelsTest, NodesHoldTheSurfelAndWhatIsBelowThem) {
  const Scene scene = ballAndBox();
  renderer().setScene(scene);
  RenderOptions options = optionsOf(Transport::Dipole);
  const Division division = divisionOf(scene, options);
  const surfels::Tree& tree = division.surfels.tree;
  std::optional<Image> above;
  std::size_t kindsAbove = 0;
  for (const int level : {0, 1, 2, 3, 4, 5, 64}) {
    options.treeLevel = level;
    const std::vector<Image> images = render(options, asked);
    std::set<float> kinds;
    forEachCovered(images[1], [&](std::size_t i) {
      const auto surfel = static_cast<std::uint32_t>(images[0].rgba[i]);
      const auto node = static_cast<std::uint32_t>(images[0].rgba[i + 2]);
      kinds.insert(images[0].rgba[i + 2]);
      const SurfelRange range = rangeOf(tree, node);
      EXPECT_TRUE(range.holds({surfel, surfel + 1}));
      if (level == 0) {
        EXPECT_EQ(node, tree.rootOfObject[static_cast<std::size_t>(images[2].rgba[i])]);
      } else {
        const auto parent = static_cast<std::uint32_t>(above->rgba[i + 2]);
        EXPECT_TRUE(rangeOf(tree, parent).holds(range));
      }
      const bool leaf = surfels::linkOf(tree, node).leaf;
      EXPECT_TRUE(leaf || level < 64);
      if (level == 0) {
        const auto object = static_cast<std::size_t>(images[2].rgba[i]);
        EXPECT_EQ(range.first, division.surfels.firstOfObject[object]);
        EXPECT_EQ(range.end, division.surfels.firstOfObject[object + 1]);
      } else {
        // A level deeper the range is smaller, unless it was a leaf already.
        const SurfelRange parent = rangeOf(tree, static_cast<std::uint32_t>(above->rgba[i + 2]));
        EXPECT_TRUE(leaf || range.end - range.first < parent.end - parent.first);
      }
    });
    EXPECT_GE(kinds.size(), kindsAbove);
    kindsAbove = kinds.size();
    above = images[0];
  }
}

// Whatever was rendered before: other methods, another division, or light that is reused.
TEST_F(SeenSurfelsTest, ChangeFromFrameToFrame) {
  const Scene scene = ballAndBox();
  Scene harder = scene;
  harder.objects[0].medium = marble();
  Camera aside = scene.camera;
  aside.positionMm[0] += 6;
  Scene fromAside = scene;
  fromAside.camera = aside;
  for (const Transport transport : {Transport::Dipole, Transport::Boundary}) {
    RenderOptions options = optionsOf(transport);
    const Image first = render(scene, options, {Aov::Surfels})[0];
    const Image ofHarder = render(harder, options, {Aov::Surfels})[0];
    const Image seenAside = render(fromAside, options, {Aov::Surfels})[0];
    EXPECT_NE(first.rgba, ofHarder.rgba);
    renderer().setScene(scene);
    RenderOptions pattern = smallOptions();
    pattern.sum = Sum::Pattern;
    EXPECT_NO_THROW(render(pattern, {Aov::Radiance}));
    View view(renderer(), options);
    const auto surfels = [&] {
      return view.render({.aovs = {Aov::Surfels}, .reuseLight = true}).images[0].rgba;
    };
    EXPECT_NO_THROW(view.render({.reuseLight = true}));
    EXPECT_TRUE(surfels() == first.rgba);
    view.setCamera(aside);
    EXPECT_TRUE(surfels() == seenAside.rgba);
    view.setCamera(std::nullopt);
    renderer().setMedium(0, marble());
    EXPECT_TRUE(surfels() == ofHarder.rgba);
  }
}

TEST_F(SeenSurfelsTest, AnOpenMeshHasNoClusters) {
  Scene scene = sceneOf(sheet({0, 0, 0}, {4, 0, 0}, {0, 4, 0}, 4), marble(), {0, 0, 25}, 6);
  const Image image = render(scene, optionsOf(Transport::Boundary), {Aov::Surfels})[0];
  EXPECT_GT(forEachCovered(image,
                           [&](std::size_t i) {
                             EXPECT_GE(image.rgba[i], 0);
                             EXPECT_EQ(image.rgba[i + 1], -1);
                           }),
            100);
}

TEST_F(SeenSurfelsTest, WhatMakesNoSenseIsRefused) {
  renderer().setScene(ballAndBox());
  const RenderOptions pattern = optionsOf(Transport::Dipole, Sum::Pattern);
  EXPECT_THROW(render(pattern, {Aov::Surfels}), UsageError);
  EXPECT_NO_THROW(render(pattern, {Aov::Depth}));
  RenderOptions tree = optionsOf(Transport::Dipole);
  for (const int level : {-1, 65}) {
    tree.treeLevel = level;
    EXPECT_THROW(render(tree, {Aov::Surfels}), UsageError);
  }
}

}  // namespace
}  // namespace opaline
