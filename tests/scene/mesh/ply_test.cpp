#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "opaline/error.h"
#include "opaline/scene.h"
#include "scene/shapes.h"

namespace opaline {
namespace {

using testing::HasSubstr;

class Ply : public testing::Test {
 protected:
  Scene load(const std::string& bytes, const LoadOptions& options = {}) {
    test::writeBytes(folder / "a.ply", bytes);
    return loadScene(folder / "a.ply", options);
  }
  std::string errorOf(const std::string& bytes) {
    std::string message = test::messageOf([&] { load(bytes); });
    EXPECT_THAT(message, HasSubstr("a.ply"));
    return message;
  }
  test::TemporaryFolder folder;
};

const std::string tetrahedronText =
    "ply\nformat ascii 1.0\ncomment made by hand\nelement vertex 4\nproperty float x\n"
    "property float y\nproperty float z\nelement face 4\nproperty list uchar int vertex_indices\n"
    "end_header\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  text.replace(text.find(what), what.size(), with);
  return text;
}

LoadOptions exactly(float diagonal) {
  LoadOptions options;
  options.diagonalMm = diagonal;
  return options;
}

TEST_F(Ply, AsciiIsScaledToFiftyMillimetresWithANote) {
  std::vector<std::string> notes;
  LoadOptions options;
  options.log = [&](LogLevel, std::string_view message) { notes.emplace_back(message); };
  const Scene scene = load(tetrahedronText, options);
  test::expectSound(scene);
  EXPECT_NEAR(diagonalMm(scene), 50, 1e-4);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_THAT(notes[0], HasSubstr("50 mm"));
  EXPECT_EQ(scene.name, "a");
  EXPECT_EQ(scene.objects[0].medium.name, "marble");
  EXPECT_TRUE(scene.repairs.empty());
  EXPECT_NEAR(diagonalMm(load(tetrahedronText, exactly(7))), 7, 1e-5);
}

TEST_F(Ply, OldMacintoshAndWindowsLineEnds) {
  for (const std::string end : {"\r", "\r\n"}) {
    std::string text;
    for (const char c : tetrahedronText) text += c == '\n' ? end : std::string(1, c);
    EXPECT_EQ(load(text).objects[0].mesh.triangles.size(), 4U);
  }
}

template <typename T>
void put(std::string& bytes, T value, bool big) {
  std::array<char, sizeof(T)> raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
  if (big) std::reverse(raw.begin(), raw.end());
  bytes.append(raw.data(), raw.size());
}

/// A cube with an unknown element, extra properties and odd types.
std::string binaryCube(bool big) {
  const scene::RawMesh cube = test::cube();
  std::string bytes = std::string("ply\nformat ") +
                      (big ? "binary_big_endian" : "binary_little_endian") +
                      " 1.0\nelement strange 2\nproperty list ushort double what\nproperty char c\n"
                      "element vertex 8\nproperty uchar red\nproperty double x\nproperty short y\n"
                      "property list uchar float nothing\nproperty float z\n"
                      "element face 6\nproperty float quality\n"
                      "property list ushort uint vertex_index\nproperty list uchar int more\n"
                      "end_header\n";
  for (int i = 0; i < 2; ++i) {
    put<std::uint16_t>(bytes, 2, big);
    put<double>(bytes, 1.5, big);
    put<double>(bytes, 2.5, big);
    put<std::int8_t>(bytes, -1, big);
  }
  for (const Vec3& p : cube.positions) {
    put<std::uint8_t>(bytes, 200, big);
    put<double>(bytes, double{p[0]}, big);
    put<std::int16_t>(bytes, static_cast<std::int16_t>(p[1]), big);
    put<std::uint8_t>(bytes, 1, big);
    put<float>(bytes, 9, big);
    put<float>(bytes, p[2], big);
  }
  for (std::size_t side = 0; side < 6; ++side) {
    // Two triangles a b c and a c d of each side form the quad a b c d.
    const Triangle& first = cube.triangles[2 * side];
    const Triangle& second = cube.triangles[2 * side + 1];
    put<float>(bytes, 0.5F, big);
    put<std::uint16_t>(bytes, 4, big);
    for (const std::uint32_t v : {first[0], first[1], first[2], second[2]}) put(bytes, v, big);
    put<std::uint8_t>(bytes, 1, big);
    put<std::int32_t>(bytes, 77, big);
  }
  return bytes;
}

TEST_F(Ply, BinaryOfBothEndsWithStrangeProperties) {
  for (const bool big : {false, true}) {
    const Scene scene = load(binaryCube(big), exactly(std::sqrt(3.0F)));
    test::expectSound(scene);
    EXPECT_TRUE(scene.repairs.empty());
    const Mesh& mesh = scene.objects[0].mesh;
    EXPECT_EQ(mesh.positionsMm.size(), 8U);
    EXPECT_EQ(mesh.triangles.size(), 12U);
    EXPECT_NEAR(test::signedVolume(mesh.positionsMm, mesh.triangles), 1, 1e-6);
  }
}

TEST_F(Ply, ColoursAreNotShownWhichIsSaid) {
  const Scene scene = load(
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nproperty uchar red\nproperty float s\nelement face 1\n"
      "property list uchar int vertex_indices\nproperty uchar red\nend_header\n"
      "0 0 0 9 1\n1 0 0 9 1\n0 1 0 9 1\n3 0 1 2 9\n");
  std::vector<std::string> kinds;
  for (const NotShown& kind : scene.notShown) kinds.push_back(kind.what);
  EXPECT_THAT(kinds, testing::ElementsAre("vertex colours", "texture coordinates", "face colours"));
}

TEST_F(Ply, OtherElementsAreNotShownWhichIsSaid) {
  const std::string edges =
      replaced(tetrahedronText, "end_header",
               "element edge 2\nproperty int vertex1\nproperty int vertex2\nelement none 0\n"
               "property int a\nend_header") +
      "0 1\n1 2\n";
  const Scene scene = load(edges);
  EXPECT_EQ(scene.objects[0].mesh.triangles.size(), 4U);
  ASSERT_EQ(scene.notShown.size(), 1U);
  EXPECT_EQ(scene.notShown[0].what, "other elements");
  EXPECT_THAT(scene.notShown[0].names, testing::ElementsAre("edge"));
}

// The strip 0 2 1 3 is the triangles 0 2 1 and 1 2 3.
TEST_F(Ply, TriangleStripsAreRead) {
  const std::string strips =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
      "property float z\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n"
      "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
  for (const char* list : {"12 0 2 1 3 -1 0 1 3 -1 0 3 2", "7 0 2 1 3 0 2 2"}) {
    const Scene scene = load(strips + list + "\n", exactly(std::sqrt(3.0F)));
    test::expectSound(scene);
    EXPECT_TRUE(scene.repairs.empty());
    EXPECT_TRUE(scene.notShown.empty());
    const Mesh& mesh = scene.objects[0].mesh;
    EXPECT_EQ(mesh.triangles.size(), 4U);
    EXPECT_NEAR(test::signedVolume(mesh.positionsMm, mesh.triangles), 1.0 / 6, 1e-6) << list;
  }
  EXPECT_THAT(errorOf(strips + "3 0 1 -2\n"), HasSubstr("triangle strip 0 names vertex -2"));
  EXPECT_THAT(errorOf(strips + "3 0 1 4\n"), HasSubstr("vertex 4"));
  EXPECT_THAT(errorOf(replaced(strips, "vertex_indices", "what") + "3 0 1 2\n"),
              HasSubstr("strips have no vertex_indices"));
}

// Whole numbers are decoded by IEC 61966-2-1.
TEST_F(Ply, ColouredVerticesMakeAnOpaqueBody) {
  const Scene scene = load(
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
      "property float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
      "element face 4\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0 255 0 0\n1 0 0 0 188 0\n0 1 0 0 0 255\n0 0 1 255 255 255\n"
      "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
  EXPECT_TRUE(scene.notShown.empty());
  ASSERT_TRUE(scene.objects[0].opaque);
  const Mesh& mesh = scene.objects[0].mesh;
  ASSERT_EQ(mesh.colors.size(), mesh.positionsMm.size());
  EXPECT_NEAR(mesh.colors[1][1], std::pow((188 / 255.0 + 0.055) / 1.055, 2.4), 1e-5);
  EXPECT_EQ(mesh.colors[0][0], 1);
}

TEST_F(Ply, EveryTruncationIsAnErrorAndNothingElse) {
  const std::string whole = binaryCube(false);
  for (std::size_t size = 0; size < whole.size(); size += 7) {
    EXPECT_NE(errorOf(whole.substr(0, size)), "");
  }
}

TEST_F(Ply, NormalsAreUsed) {
  const std::string text =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nproperty float nx\nproperty float ny\nproperty float nz\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0 0 3 4\n1 0 0 0 3 4\n0 1 0 0 3 4\n3 0 1 2\n";
  const Vec3 normal = load(text).objects[0].mesh.normals[0];
  EXPECT_FLOAT_EQ(normal[1], 0.6F);
  EXPECT_FLOAT_EQ(normal[2], 0.8F);
}

TEST_F(Ply, ConcavePolygonsAreCutInside) {
  // An L of area 3 and an arrow head, which a fan from the first corner would leave.
  const std::string text =
      "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
      "2 1 0\n1 1 0\n1 2 0\n0 2 0\n0 0 0\n2 0 0\n6 0 1 2 3 4 5\n";
  const Mesh mesh = load(text, exactly(std::sqrt(8.0F))).objects[0].mesh;
  EXPECT_EQ(mesh.triangles.size(), 4U);
  double area = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3& a = mesh.positionsMm[t[0]];
    const Vec3& b = mesh.positionsMm[t[1]];
    const Vec3& c = mesh.positionsMm[t[2]];
    const double twice =
        double{b[0] - a[0]} * double{c[1] - a[1]} - double{b[1] - a[1]} * double{c[0] - a[0]};
    EXPECT_GT(twice, 0);
    area += twice / 2;
  }
  EXPECT_NEAR(area, 3, 1e-5);
}

TEST_F(Ply, HugePromisesAreRefusedBeforeAnythingIsAllocated) {
  for (const char* format : {"ascii", "binary_little_endian"}) {
    const auto file = [&](const char* vertices, const char* faces, const char* more = "") {
      return fmt::format(
          "ply\nformat {} 1.0\n{}element vertex {}\nproperty float x\nproperty float y\n"
          "property float z\nelement face {}\nproperty list uint int vertex_indices\n"
          "end_header\n0 0 0\n",
          format, more, vertices, faces);
    };
    EXPECT_THAT(errorOf(file("4000000000000", "1")), HasSubstr("4000000000000 vertices"));
    EXPECT_THAT(errorOf(file("99999999999999999999999", "1")), HasSubstr("number"));
    errorOf(file("0", "4000000000000"));
    // An element without properties takes no bytes.
    errorOf(file("0", "0", "element void 18446744073709551615\n"));
  }
  std::string list =
      "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty float x\n"
      "property float y\nproperty float z\nelement face 1\n"
      "property list uint int vertex_indices\nend_header\n";
  list += std::string(12, '\0') + "\xFF\xFF\xFF\xFF" + std::string(8, '\0');
  EXPECT_THAT(errorOf(list), HasSubstr("ends before all of its 1 faces"));
}

TEST_F(Ply, BadContentsAreNamed) {
  EXPECT_THAT(errorOf(""), HasSubstr("empty"));
  EXPECT_THAT(errorOf("plx\nformat ascii 1.0\n"), HasSubstr("not a PLY"));
  EXPECT_THAT(errorOf(replaced(tetrahedronText, "3 1 2 3", "3 1 2 4")), HasSubstr("vertex 4"));
  EXPECT_THAT(errorOf(replaced(tetrahedronText, "3 1 2 3", "3 1 2 -1")), HasSubstr("vertex -1"));
  EXPECT_THAT(errorOf(replaced(tetrahedronText, "3 1 2 3", "-3 1 2 3")), HasSubstr("-3"));
  EXPECT_THAT(errorOf(replaced(tetrahedronText, "1 0 0", "1 nan 0")), HasSubstr("not finite"));
  EXPECT_THAT(errorOf(replaced(tetrahedronText, "1 0 0", "1 inf 0")), HasSubstr("not finite"));
  EXPECT_THAT(errorOf(replaced(tetrahedronText, "1 0 0", "1 1e999 0")), HasSubstr("not finite"));
  EXPECT_THAT(errorOf(replaced(tetrahedronText, "1 0 0", "1 zero 0")), HasSubstr("zero"));
  EXPECT_THAT(errorOf(replaced(tetrahedronText, "ascii", "utf8")), HasSubstr("utf8"));
  EXPECT_THAT(errorOf(replaced(tetrahedronText, "float x", "quad x")), HasSubstr("property"));
  EXPECT_THAT(errorOf(replaced(tetrahedronText, "float x", "float a")), HasSubstr("x, y and z"));
  EXPECT_THAT(errorOf(replaced(tetrahedronText, "element face 4", "element face 0")),
              HasSubstr("no face"));
  EXPECT_THAT(errorOf(replaced(tetrahedronText, "end_header\n", "")), HasSubstr("header"));
  std::string flat = tetrahedronText.substr(0, tetrahedronText.find("3 0 2 1"));
  EXPECT_THAT(errorOf(flat + "3 0 0 1\n3 2 2 2\n3 0 1 0\n2 0 1\n"), HasSubstr("degenerate"));
}

TEST_F(Ply, PathsThatAreNoFilesAreNamed) {
  EXPECT_THAT(test::messageOf([&] { loadScene(folder.path()); }),
              HasSubstr(folder.path().string()));
  EXPECT_THAT(test::messageOf([&] { loadScene(folder / "none.ply"); }), HasSubstr("none.ply"));
  test::writeBytes(folder / "a.stl", "solid");
  EXPECT_THAT(test::messageOf([&] { loadScene(folder / "a.stl"); }), HasSubstr(".glb"));
}

TEST_F(Ply, MagicWinsOverTheExtension) {
  test::writeBytes(folder / "a.obj", tetrahedronText);
  EXPECT_EQ(loadScene(folder / "a.obj").objects[0].mesh.triangles.size(), 4U);
}

TEST_F(Ply, OptionsAreChecked) {
  EXPECT_THROW(load(tetrahedronText, exactly(0)), UsageError);
  EXPECT_THROW(load(tetrahedronText, exactly(NAN)), UsageError);
  LoadOptions options;
  options.medium = Medium{"mine", {1, 1, 1}, {0.1, 0.1, 0.1}, 1.4};
  EXPECT_EQ(load(tetrahedronText, options).objects[0].medium.name, "mine");
  options.medium->eta = 0.5;
  EXPECT_THROW(load(tetrahedronText, options), UsageError);
}

}  // namespace
}  // namespace opaline
