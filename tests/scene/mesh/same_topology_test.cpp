#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <thread>

#include "opaline/error.h"
#include "opaline/scene.h"
#include "opaline/scene_file.h"
#include "opaline/sequence.h"
#include "scene/shapes.h"

// Files whose positions replace each other: morphs and sequences.

namespace opaline {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string plyOf(const scene::RawMesh& mesh) {
  std::string text = "ply\nformat ascii 1.0\nelement vertex " +
                     std::to_string(mesh.positions.size()) +
                     "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                     std::to_string(mesh.triangles.size()) +
                     "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Vec3& p : mesh.positions) {
    for (const float x : p) text += std::to_string(x) + " ";
  }
  for (const Triangle& t : mesh.triangles) {
    text += "\n3";
    for (const std::uint32_t v : t) text += " " + std::to_string(v);
  }
  return text;
}

/// A cube with two superfluous vertices: an unused first one, and a copy of a corner for one
/// triangle. Every coordinate is multiplied by `factor`.
scene::RawMesh awkwardCube(float factor) {
  scene::RawMesh mesh = test::cube();
  mesh.positions.insert(mesh.positions.begin(), {5, 5, 5});
  for (Triangle& t : mesh.triangles) {
    for (std::uint32_t& v : t) ++v;
  }
  mesh.positions.push_back(mesh.positions[mesh.triangles[0][0]]);
  mesh.triangles[0][0] = 9;
  for (Vec3& p : mesh.positions) {
    for (float& x : p) x *= factor;
  }
  return mesh;
}

class SameTopology : public testing::Test {
 protected:
  void write(const char* name, const scene::RawMesh& mesh) {
    test::writeBytes(folder / name, plyOf(mesh));
  }
  test::TemporaryFolder folder;
};

class MorphTo : public SameTopology {
 protected:
  Scene load() {
    LoadOptions options;
    options.diagonalMm = std::sqrt(3.0F) * 10;
    options.morphTo = folder / "b.ply";
    return loadScene(folder / "a.ply", options);
  }
};

TEST_F(MorphTo, OneTargetTakesTheFirstMeshToTheSecond) {
  write("a.ply", awkwardCube(1));
  write("b.ply", awkwardCube(3));
  const Scene scene = load();
  test::expectSound(scene);
  const Object& object = scene.objects[0];
  ASSERT_TRUE(object.rig);
  ASSERT_EQ(object.rig->targets.size(), 1U);
  EXPECT_TRUE(object.rig->targets[0].normals.empty());
  EXPECT_FALSE(object.mesh.facetted);
  ASSERT_EQ(object.rig->positions.size(), 8U);
  for (std::size_t v = 0; v < 8; ++v) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      // Both use the first file's scale, ten millimetres per unit; the second is twice as large.
      EXPECT_FLOAT_EQ(10 * object.rig->positions[v][axis], object.mesh.positionsMm[v][axis]);
      EXPECT_FLOAT_EQ(20 * object.rig->positions[v][axis],
                      10 * object.rig->targets[0].positions[v][axis]);
    }
    EXPECT_EQ(object.rig->normals[v], object.mesh.normals[v]);
  }
  EXPECT_FLOAT_EQ(object.rig->toScene.columns[2][2], 10);
  ASSERT_EQ(scene.clips.size(), 1U);
  EXPECT_EQ(scene.clips[0].name, "morph");
  EXPECT_EQ(scene.clips[0].seconds, 4);
  const Track& track = scene.clips[0].tracks[0];
  EXPECT_EQ(track.interpolation, Interpolation::CubicSpline);
  EXPECT_THAT(track.seconds, ElementsAre(0, 2, 4));
  EXPECT_THAT(track.values, ElementsAre(0, 0, 0, 0, 1, 0, 0, 0, 0));
}

TEST_F(MorphTo, OtherTopologiesAreErrorsThatNameBothFiles) {
  write("a.ply", test::cube());
  const auto errorWith = [&](const scene::RawMesh& other) {
    write("b.ply", other);
    std::string message = test::messageOf([&] { load(); });
    EXPECT_THAT(message, HasSubstr("a.ply"));
    EXPECT_THAT(message, HasSubstr("b.ply"));
    return message;
  };
  scene::RawMesh other = test::cube();
  other.positions.push_back({0, 0, 0});
  EXPECT_THAT(errorWith(other), HasSubstr("8 vertices against 9"));
  other = test::cube();
  other.triangles.pop_back();
  EXPECT_THAT(errorWith(other), HasSubstr("12 faces against 11"));
  other = test::cube();
  std::swap(other.triangles[0], other.triangles[1]);
  EXPECT_THAT(errorWith(other), HasSubstr("join other vertices"));
}

/// A quadrilateral that is convex in only one of the files is cut in two ways.
TEST_F(MorphTo, PolygonsAreComparedUncut) {
  const auto quad = [](const char* tip) {
    return std::string(
               "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\n"
               "property float y\nproperty float z\nelement face 1\n"
               "property list uchar int vertex_indices\nend_header\n0 0 0\n") +
           tip + "\n1 1 0\n0 1 0\n4 0 1 2 3\n";
  };
  test::writeBytes(folder / "a.ply", quad("1 0 0"));
  test::writeBytes(folder / "b.ply", quad("0.1 0.9 0"));
  EXPECT_EQ(load().objects[0].rig->positions.size(), 4U);
}

TEST_F(MorphTo, BuiltInScenesHaveNoOtherMesh) {
  LoadOptions options;
  options.morphTo = folder / "b.ply";
  EXPECT_THROW(builtInTeapot(options), UsageError);
}

class Sequence : public SameTopology {
 protected:
  std::filesystem::path pattern() const { return folder / "frame_%03d.ply"; }
};

TEST_F(Sequence, NumbersInARowFromTheSmallest) {
  for (const char* name : {"frame_007.ply", "frame_008.ply", "frame_009.ply", "frame_011.ply",
                           "frame_10.ply", "frame_0010.ply", "frame_x.ply", "frame_-01.ply"}) {
    write(name, awkwardCube(2));
  }
  const MeshSequence sequence(pattern());
  EXPECT_EQ(sequence.firstNumber(), 7);
  EXPECT_EQ(sequence.lastNumber(), 9);
  EXPECT_EQ(sequence.frameCount(), 3);
  EXPECT_EQ(sequence.file(8), folder / "frame_008.ply");
  EXPECT_EQ(sequence.scene().objects.size(), 1U);
  EXPECT_FALSE(sequence.scene().objects[0].rig);
  EXPECT_TRUE(sequence.scene().nodes.empty());
}

TEST_F(Sequence, FramesComeAtTheScaleAndInTheOrderOfTheFirst) {
  write("frame_000.ply", awkwardCube(1));
  write("frame_001.ply", awkwardCube(3));
  LoadOptions options;
  options.diagonalMm = std::sqrt(3.0F) * 10;
  const MeshSequence sequence(pattern(), options);
  test::expectSound(sequence.scene());
  const std::vector<Vec3>& rest = sequence.scene().objects[0].mesh.positionsMm;
  ASSERT_EQ(rest.size(), 8U);
  std::vector<Vec3> positions;
  std::thread([&] { sequence.read(0, positions); }).join();
  EXPECT_EQ(positions, rest);
  sequence.read(1, positions);
  ASSERT_EQ(positions.size(), 8U);
  for (std::size_t v = 0; v < 8; ++v) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_FLOAT_EQ(positions[v][axis], 3 * rest[v][axis]);
    }
  }
}

TEST_F(Sequence, FramesThatDoNotFitAreErrors) {
  write("frame_000.ply", awkwardCube(1));
  write("frame_001.ply", test::cube());
  test::writeBytes(folder / "frame_002.ply", "ply\nnonsense");
  scene::RawMesh far = awkwardCube(1);
  std::string text = plyOf(far);
  text.replace(text.find("0.000000"), 8, "nan");
  test::writeBytes(folder / "frame_003.ply", text);
  const MeshSequence sequence(pattern());
  EXPECT_EQ(sequence.frameCount(), 4);
  std::vector<Vec3> positions;
  const auto errorOf = [&](int number) {
    return test::messageOf([&] { sequence.read(number, positions); });
  };
  EXPECT_THAT(errorOf(1), HasSubstr("8 vertices against 10"));
  EXPECT_THAT(errorOf(1), HasSubstr("frame_000.ply"));
  EXPECT_THAT(errorOf(2), HasSubstr("frame_002.ply"));
  EXPECT_THAT(errorOf(3), HasSubstr("not finite"));
  EXPECT_THAT(errorOf(4), HasSubstr("frame_004.ply"));
}

TEST_F(Sequence, ASceneFilePlacesEveryMeshAsTheFirst) {
  write("frame_000.ply", awkwardCube(1));
  write("frame_001.ply", awkwardCube(3));
  LoadOptions size;
  size.diagonalMm = 17;
  const MeshSequence plain(pattern(), size);
  test::writeBytes(folder / "a.toml",
                   "model = \"frame_%03d.ply\"\ndiagonal_mm = 17\n[objects." +
                       plain.scene().objects[0].name +
                       "]\nscale = 2\nrotation_degrees = [0, 90, 0]\ntranslation_mm = [1, 2, 3]\n");
  const LoadedScene loaded = loadSceneFile(folder / "a.toml");
  test::expectSound(loaded.scene);
  ASSERT_TRUE(loaded.sequence);
  EXPECT_FALSE(loaded.scene.objects[0].rig);
  std::vector<Vec3> given;
  std::vector<Vec3> placed;
  loaded.sequence->read(0, placed);
  EXPECT_EQ(placed, loaded.scene.objects[0].mesh.positionsMm);
  for (const int number : {0, 1}) {
    plain.read(number, given);
    loaded.sequence->read(number, placed);
    ASSERT_EQ(placed.size(), given.size());
    for (std::size_t v = 0; v < given.size(); ++v) {
      // A quarter turn about y takes z to x.
      const Vec3 wanted{2 * given[v][2] + 1, 2 * given[v][1] + 2, -2 * given[v][0] + 3};
      for (std::size_t axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(placed[v][axis], wanted[axis], 1e-4F) << number;
    }
  }

  writeScene(folder / "b.toml", describe(loaded.scene, loaded.source, {}));
  const LoadedScene again = loadSceneFile(folder / "b.toml");
  ASSERT_TRUE(again.sequence);
  again.sequence->read(1, given);
  EXPECT_EQ(given, placed);

  test::writeBytes(folder / "c.toml", "model = \"frame_%03d.ply\"\nmorph_to = \"frame_001.ply\"\n");
  EXPECT_THROW(loadSceneFile(folder / "c.toml"), UsageError);
}

TEST_F(Sequence, PatternsHaveExactlyOneNumber) {
  EXPECT_TRUE(MeshSequence::isPattern("a/frame_%d.ply"));
  EXPECT_TRUE(MeshSequence::isPattern("100%_%05d.obj"));
  for (const char* name : {"frame.ply", "%d_%d.ply", "%s.ply", "%4d.ply", "a%d/frame.ply", "%"}) {
    EXPECT_FALSE(MeshSequence::isPattern(name)) << name;
    EXPECT_THROW(MeshSequence{name}, UsageError) << name;
  }
  EXPECT_THAT(test::messageOf([&] { const MeshSequence none(pattern()); }),
              HasSubstr("no file of this pattern"));
  EXPECT_THAT(test::messageOf([&] { const MeshSequence none(folder / "no/frame_%d.ply"); }),
              HasSubstr("cannot be listed"));
}

}  // namespace
}  // namespace opaline
