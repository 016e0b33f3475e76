#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "opaline/error.h"
#include "opaline/image_file.h"
#include "opaline/scene.h"
#include "scene/shapes.h"

namespace opaline {
namespace {

using testing::HasSubstr;

class Obj : public testing::Test {
 protected:
  Scene load(const std::string& text) {
    test::writeBytes(folder / "a.obj", text);
    LoadOptions options;
    options.diagonalMm = std::sqrt(3.0F);
    return loadScene(folder / "a.obj", options);
  }
  std::string errorOf(const std::string& text) {
    std::string message = test::messageOf([&] { load(text); });
    EXPECT_THAT(message, HasSubstr("a.obj"));
    return message;
  }
  std::string notShown(const std::string& text) {
    std::string said;
    for (const NotShown& kind : load(text).notShown) {
      said += kind.what + " " + std::to_string(kind.count);
      for (const std::string& name : kind.names) said += " " + name;
      said += "\n";
    }
    return said;
  }
  test::TemporaryFolder folder;
};

const std::string cubeCorners =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\n";
// Counter-clockwise seen from outside.
const std::string quads = "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";

TEST_F(Obj, PolygonsBecomeTriangles) {
  const Scene scene = load("# a cube\no cube\n" + cubeCorners + "s 1\ng a b\n" + quads);
  test::expectSound(scene);
  const Mesh& mesh = scene.objects[0].mesh;
  EXPECT_EQ(mesh.positionsMm.size(), 8U);
  EXPECT_EQ(mesh.triangles.size(), 12U);
  EXPECT_TRUE(scene.repairs.empty());
  EXPECT_NEAR(test::signedVolume(mesh.positionsMm, mesh.triangles), 1, 1e-6);
}

// Vertices at a corner of a cube: a single one, or one for each normal.
TEST_F(Obj, SmoothingGroupsMakeCreases) {
  const auto meshOf = [&](const std::string& faces) {
    const Scene scene = load(cubeCorners + faces);
    test::expectSound(scene);
    EXPECT_TRUE(scene.repairs.empty()) << faces;
    return scene.objects[0].mesh;
  };
  EXPECT_EQ(meshOf(quads).positionsMm.size(), 8U);
  EXPECT_EQ(meshOf("s 3\n" + quads).positionsMm.size(), 8U);
  for (const char* off : {"s off\n", "s 0\n"}) {
    const Mesh flat = meshOf(off + quads);
    EXPECT_EQ(flat.positionsMm.size(), 24U);
    for (const Vec3& normal : flat.normals) {
      const float largest =
          std::max({std::abs(normal[0]), std::abs(normal[1]), std::abs(normal[2])});
      EXPECT_NEAR(largest, 1, 1e-6) << off;
    }
  }
  // The first face, at z = 0, and the other five are separate groups: its corners have two normals
  // each.
  const std::size_t second = quads.find('\n') + 1;
  const Mesh lid = meshOf("s 1\n" + quads.substr(0, second) + "s 2\n" + quads.substr(second));
  EXPECT_EQ(lid.positionsMm.size(), 12U);
  float bottom = 1;
  for (const Vec3& position : lid.positionsMm) bottom = std::min(bottom, position[2]);
  int ofLid = 0;
  int slanting = 0;
  for (std::size_t v = 0; v < lid.normals.size(); ++v) {
    const Vec3& normal = lid.normals[v];
    if (normal[2] < -0.999F) ++ofLid;
    // Two faces meet at right angles at the lower corners, three at the upper ones.
    const float expected =
        lid.positionsMm[v][2] < bottom + 0.5F ? std::sqrt(0.5F) : std::sqrt(1 / 3.0F);
    if (std::abs(std::abs(normal[0]) - expected) < 1e-6F) ++slanting;
  }
  EXPECT_EQ(ofLid, 4);
  EXPECT_EQ(slanting, 8);
  // Normals in the file take precedence.
  const Scene own = load("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0.6 0.8\ns off\nf 1//1 2//1 3//1\n");
  EXPECT_NEAR(own.objects[0].mesh.normals[0][1], 0.6, 1e-6);
}

TEST_F(Obj, NegativeAndForwardIndicesAndComments) {
  const Mesh forward = load(quads + cubeCorners).objects[0].mesh;
  EXPECT_EQ(forward.triangles.size(), 12U);
  const Mesh mesh = load(cubeCorners +
                         "f -8 -6 -5 -7 # 5 of six\nf -4 -3 -1 -2\nf -8 -7 -3 -4\n"
                         "f -6 -2 -1 -5\nf -8 -4 -2 -6\nf -7 -5 -1 -3\n")
                        .objects[0]
                        .mesh;
  EXPECT_NEAR(test::signedVolume(mesh.positionsMm, mesh.triangles), 1, 1e-6);
}

TEST_F(Obj, NormalsAndTextureCoordinates) {
  const Scene scene = load(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0.5\nvt 0 0\nvn 0 0 2\nvn 0 0.6 0.8\n"
      "f 1/1/1 2//1 3/1/1\nf 2//2 4//2 3//2\n");
  // The two sides of the crease have separate normals.
  EXPECT_EQ(scene.objects[0].mesh.positionsMm.size(), 6U);
  EXPECT_EQ(scene.objects[0].mesh.normals[0], (Vec3{0, 0, 1}));
  EXPECT_FLOAT_EQ(scene.objects[0].mesh.normals[4][1], 0.6F);
}

TEST_F(Obj, MaterialsThatAreMediaMakeObjects) {
  const Scene scene = load(cubeCorners +
                           "usemtl Ketchup\nf 1 3 4 2\nf 5 6 8 7\nusemtl red paint\nf 1 2 6 5\n"
                           "usemtl other\nf 3 7 8 4\nusemtl ketchup\nf 1 5 7 3\nf 2 4 8 6\n");
  ASSERT_EQ(scene.objects.size(), 2U);
  EXPECT_EQ(scene.objects[0].medium.name, "marble");
  EXPECT_EQ(scene.objects[0].mesh.triangles.size(), 4U);
  EXPECT_EQ(scene.objects[1].medium.name, "ketchup");
  EXPECT_EQ(scene.objects[1].mesh.triangles.size(), 8U);
}

// As Maya and 3ds Max name them.
TEST_F(Obj, NamesOfMaterialsMayHaveBlanks) {
  test::writeBytes(
      folder / "a.mtl",
      "newmtl red stone\nKd 1 0 0\nnewmtl Material #25\nKd 0 1 0\nnewmtl red\nKd 0 0 1\n");
  const Scene scene = load("mtllib a.mtl\n" + cubeCorners +
                           "usemtl red stone\nf 1 3 4 2\nusemtl  Material #25 \r\nf 5 6 8 7\n"
                           "usemtl red # the floor\nf 1 2 6 5\nusemtl wax # its lid\nf 3 7 8 4\n"
                           "usemtl red\nf 1 5 7 3\nusemtl red wine\nf 2 4 8 6\n");
  std::map<std::string, std::size_t> triangles;
  for (const Object& object : scene.objects) triangles[object.name] = object.mesh.triangles.size();
  EXPECT_EQ(triangles, (std::map<std::string, std::size_t>{
                           {"Material #25", 2}, {"red", 6}, {"red stone", 2}, {"wax", 2}}));
  EXPECT_EQ(notShown(cubeCorners + "usemtl glaze # thick\n" + quads), "materials 1 glaze\n");
  EXPECT_EQ(notShown(cubeCorners + "usemtl thick glaze\n" + quads), "materials 1 thick glaze\n");
}

TEST_F(Obj, UnusedVerticesAreCounted) {
  EXPECT_EQ(test::countOf(load(cubeCorners + "v 9 9 9\n" + quads).repairs, "unused vertices"), 1U);
}

TEST_F(Obj, BadLinesAreNamed) {
  EXPECT_THAT(errorOf(cubeCorners + "f 1 2 9\n"), HasSubstr("vertex 9"));
  EXPECT_THAT(errorOf(cubeCorners + "f -1 -2 -99\nv 0 0 0\n"),
              HasSubstr("a face names vertex -99, but there are 8 vertices before it"));
  EXPECT_THAT(errorOf(cubeCorners + "f 1//-1 2//-1 3//-1\nvn 1 0 0\n"),
              HasSubstr("normal -1, but there are 0 normals before it"));
  EXPECT_THAT(errorOf(cubeCorners + "f 1 2 0\n"), HasSubstr("line 9"));
  EXPECT_THAT(errorOf(cubeCorners + "f 1 2 4294967297\n"), HasSubstr("4294967297"));
  EXPECT_THAT(errorOf(cubeCorners + "f 1//5 2//5 3//5\n"), HasSubstr("normal 5"));
  EXPECT_THAT(errorOf(cubeCorners + "f 1 2 x\n"), HasSubstr("'x'"));
  EXPECT_THAT(errorOf("v 0 nan 0\n" + cubeCorners + quads), HasSubstr("line 1"));
  EXPECT_THAT(errorOf("v 0 inf 0\n" + cubeCorners + quads), HasSubstr("finite"));
  EXPECT_THAT(errorOf("v 0 1e39 0\n" + cubeCorners + quads), HasSubstr("1e39"));
  EXPECT_THAT(errorOf("v 0 1\n" + cubeCorners + quads),
              HasSubstr("line 1: a vertex needs three coordinates, but has 2"));
  EXPECT_THAT(errorOf("vn 1 # 0 0\n"), HasSubstr("a normal needs three coordinates, but has 1"));
  EXPECT_THAT(errorOf(cubeCorners), HasSubstr("no faces"));
  EXPECT_THAT(errorOf(cubeCorners + "f 1 1 1\nf 1 2\n"), HasSubstr("degenerate"));
  EXPECT_THAT(errorOf("hello"), HasSubstr("no vertices"));
  EXPECT_THAT(errorOf(cubeCorners + std::string("f 1 2 3\0 4\n", 11)), HasSubstr("zero bytes"));
}

TEST_F(Obj, LinesThatAreContinuedAreJoined) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    const std::string next = "\\" + end;
    std::string text = "# kept in C:\\cubes\\\n" + cubeCorners;
    text += "f 1 3 " + next + "\t4 2" + next + "# of six\n";
    text += "f 5 " + next + next + "6 8 7 # from C:\\\n";
    text += "f" + next + " 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6" + next;
    const Mesh mesh = load(text).objects[0].mesh;
    EXPECT_EQ(mesh.triangles.size(), 12U);
    EXPECT_NEAR(test::signedVolume(mesh.positionsMm, mesh.triangles), 1, 1e-6);
  }
  EXPECT_THAT(errorOf(cubeCorners + "f 1 \\\n 2 3\n\nf 1 \\\r\n 2 x"), HasSubstr("line 12: 'x'"));
  EXPECT_THAT(errorOf("v 0 \\\n0 \\\n\nv 1 1 1\n"),
              HasSubstr("line 1: a vertex needs three coordinates, but has 2"));
}

TEST_F(Obj, WhatIsNotShownIsCounted) {
  EXPECT_EQ(notShown(cubeCorners + "o cube\n" + quads), "");
  EXPECT_EQ(notShown(cubeCorners + "o cube\nusemtl wax\n" + quads), "");
  EXPECT_EQ(notShown("mtllib a.mtl\n" + cubeCorners +
                     "v 2 2 2 .5 .5 .5\no lid\nusemtl glaze\nf 1 3 4 2\nf 5 6 8 7\nusemtl wood\n"
                     "g pot\nf 1 2 6 5\nf 3 7 8 4\ng none\no pot\nf 1 5 7 3\nusemtl glaze\n"
                     "f 2 4 8 6\n"),
            "materials 2 glaze wood\nmaterial files 1 a.mtl\n"
            "groups as objects of their own 2 lid pot\nvertex colours 1\n");
  // A group with a material to itself is an object; two that share one are not.
  const std::string faces = cubeCorners + "o pot\nusemtl wax\nf 1 3 4 2\nf 5 6 8 7\no lid\n";
  EXPECT_EQ(notShown(faces + "usemtl marble\nf 1 2 6 5\nf 3 7 8 4\n"), "");
  EXPECT_EQ(notShown(faces + "usemtl marble\nf 1 2 6 5\nf 3 7 8 4\no rim\nf 1 5 7 3\n"),
            "groups as objects of their own 2 lid rim\n");
}

TEST_F(Obj, LinesPointsAndFreeFormsAreNotShown) {
  EXPECT_EQ(notShown(cubeCorners + quads +
                     "l 1 2 3\np 1\nl 4 5\ncstype bezier\ndeg 3\n"
                     "curv 0 1 1 2 3 4\nparm u 0 1\nend\nsurf 0 1 0 1 1 2 3 4\nend\n"),
            "points and lines 3\nfree-form curves and surfaces 2\n");
}

// What Blender, Maya and 3ds Max write for plain surfaces.
TEST_F(Obj, OrdinaryMaterialsAreShownWhole) {
  writePng(folder / "clay.png", {1, 1, {10, 20, 30, 255}});
  for (const char* lines :
       {"Ns 250\nKa 1 1 1\nKd .8 .8 .8\nKs .5 .5 .5\nKe 0 0 0\nNi 1.45\nd 1\nillum 2\n",
        "Pr .5\nPm 0\nPs 0\nPc 0\nPcr .03\naniso 0\nanisor 0\nillum 3\n",
        "illum 4\nKd .5 .5 .5\nKa 0 0 0\nTf 1 1 1\nNi 1\n",
        "Tf +1 1 1\nTr 0\nillum 2\nmap_Ka clay.png\nmap_Kd clay.png\n",
        "map_Kd -s 1 1 1 -o 0 0 0 -mm 0 1 -bm 1 -blendu on -clamp on clay.png\n"}) {
    test::writeBytes(folder / "a.mtl", std::string("# made by hand\nnewmtl glaze\n") + lines);
    EXPECT_EQ(notShown("mtllib a.mtl\nusemtl glaze\n" + cubeCorners + quads), "") << lines;
  }
}

TEST_F(Obj, WhatMaterialsDoNotShowIsNamed) {
  writePng(folder / "clay.png", {1, 1, {10, 20, 30, 255}});
  const auto said = [&](const std::string& lines) {
    test::writeBytes(folder / "a.mtl", "newmtl unused\nrefl x.png\nnewmtl glaze\n" + lines);
    return notShown("mtllib a.mtl\nusemtl glaze\n" + cubeCorners + quads);
  };
  for (const char* key : {"map_Ks", "map_Ns", "map_d", "map_Ka", "refl", "disp", "decal", "bump",
                          "map_Bump", "map_Pr", "hair"})
    EXPECT_EQ(said(std::string(key) + " -bm 2 clay.png\n"), std::string(key) + " 1 glaze\n");
  EXPECT_EQ(said("MAP_BUMP clay.png\nmap_bump clay.png\n"), "map_Bump 1 glaze\n");
  for (const char* option :
       {"-s 2", "-s 1 2 1", "-o 0 .5", "-t 0 0 1", "-mm 0 2", "-bm 3", "-blendu off", "-blendv off",
        "-texres 256", "-imfchan r", "-type sphere", "-boost 2", "-cc on"}) {
    const std::string name = std::string(option).substr(0, std::string(option).find(' '));
    EXPECT_EQ(said("norm -clamp on " + std::string(option) + " -clamp off clay.png\n"),
              name + " of norm 1 glaze\n");
  }
  EXPECT_EQ(said("illum 7\nNi 1.5\n"), "refraction 1 glaze\n");
  EXPECT_EQ(said("Tf 1 .5 1\n"), "Tf 1 glaze\n");
  EXPECT_EQ(said("Tf .5\n"), "Tf 1 glaze\n");
  EXPECT_EQ(said("Pc .5\n"), "Pc 1 glaze\n");
  EXPECT_EQ(said("d .3\nillum 4\n"), "blended alpha 1 glaze\n");
  EXPECT_EQ(said("Kd spectral a.rfl\n"), "Kd spectral 1 glaze\n");
}

TEST_F(Obj, TexturesAreReadWhateverTheirOptionsAndCase) {
  writePng(folder / "brown clay.png", {1, 1, {10, 20, 30, 255}});
  for (const char* line :
       {"map_kd brown clay.png", "MAP_KD\t-s 2 -clamp on brown clay.png ",
        "map_Kd -o 0.5 0 -type sphere -clamp on -mm 0 1 -boost 3 brown clay.png"}) {
    test::writeBytes(folder / "a.mtl", std::string("newmtl glaze\nKD 0.5 0.25 1\n") + line);
    const Scene scene = load("mtllib a.mtl\nusemtl glaze\n" + cubeCorners +
                             "vt 0 0\nvt 1 0\nvt 0 1\nf 1/1 3/2 4/3\nf 1/1 4/2 2/3\n");
    const OpaqueMaterial& glaze = *scene.objects[0].opaque;
    EXPECT_EQ(glaze.baseColor, (Rgb{0.5F, 0.25F, 1}));
    ASSERT_TRUE(glaze.baseColorTexture) << line;
    EXPECT_EQ(glaze.baseColorTexture->pixels->rgba[2], 30 * 257);
    const bool isClamped = std::string_view(line).find("-clamp") != std::string_view::npos;
    EXPECT_EQ(glaze.baseColorTexture->wrapU == TextureWrap::ClampToEdge, isClamped) << line;
  }
}

TEST_F(Obj, MaterialsComeFromTheirFile) {
  writePng(folder / "clay.png", {1, 1, {10, 20, 30, 255}});
  test::writeBytes(folder / "a.mtl",
                   "newmtl glaze\nKd 0.5 0.25 1\nKs 0.04 0.02 0\nNs 6\nKe 0 2 0\n"
                   "map_Kd clay.png\nmap_Ke none.png\nnewmtl unused\nKd 1 0 0\n");
  const Scene scene = load("mtllib a.mtl\n" + cubeCorners +
                           "vt 0 0\nvt 1 0\nvt 1 0.25\nvt 0 1\nusemtl glaze\n"
                           "f 1/1 3/2 4/3 2/4\nf 5/1 6/2 8/3 7/4\nf 1/1 2/2 6/3 5/4\n"
                           "f 3/1 7/2 8/3 4/4\nf 1/1 5/2 7/3 3/4\nf 2/1 4/2 8/3 6/4\n");
  ASSERT_EQ(scene.objects.size(), 1U);
  ASSERT_TRUE(scene.objects[0].opaque);
  const OpaqueMaterial& glaze = *scene.objects[0].opaque;
  EXPECT_EQ(glaze.baseColor, (Rgb{0.5F, 0.25F, 1}));
  EXPECT_NEAR(glaze.roughness, std::sqrt(0.5), 1e-6);  // α = 1/2
  EXPECT_NEAR(glaze.specularColor[1], 0.5, 1e-6);
  EXPECT_EQ(glaze.emission, (Rgb{0, 2, 0}));
  EXPECT_EQ(glaze.baseColorTexture->pixels->rgba[2], 30 * 257);
  EXPECT_FALSE(glaze.emissionTexture);
  ASSERT_EQ(scene.notShown.size(), 1U);
  EXPECT_EQ(scene.notShown[0].what, "textures that cannot be read");
  EXPECT_THAT(scene.notShown[0].names, testing::ElementsAre("none.png"));
  // Seams of the texture part vertices, not the body; rows of a picture go down.
  const Mesh& mesh = scene.objects[0].mesh;
  ASSERT_EQ(mesh.textureCoordinates[0].size(), mesh.positionsMm.size());
  EXPECT_GT(mesh.positionsMm.size(), 8U);
  std::set<float> rows;
  for (const Vec2& place : mesh.textureCoordinates[0]) rows.insert(place[1]);
  EXPECT_EQ(rows, (std::set<float>{0, 0.75F, 1}));
}

TEST_F(Obj, NamesOfMaterialFilesMayHaveBlanks) {
  test::writeBytes(folder / "my  glaze.mtl", "newmtl glaze\nKd 0.5 0.25 1\n");
  test::writeBytes(folder / "wood.mtl", "newmtl wood\nKd 0.25 0 0\n");
  const std::string body = cubeCorners + "usemtl glaze\nf 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\n" +
                           "usemtl wood\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
  const Scene one = load("mtllib \tmy  glaze.mtl \r\nmtllib wood.mtl\n" + body);
  ASSERT_EQ(one.objects.size(), 2U);
  EXPECT_EQ(one.objects[0].opaque->baseColor, (Rgb{0.5F, 0.25F, 1}));
  EXPECT_EQ(one.objects[1].opaque->baseColor, (Rgb{0.25F, 0, 0}));
  EXPECT_TRUE(one.notShown.empty());
  test::writeBytes(folder / "glaze.mtl", "newmtl glaze\nKd 0 1 0\n");
  const Scene several = load("mtllib glaze.mtl\twood.mtl # both\n" + body);
  ASSERT_EQ(several.objects.size(), 2U);
  EXPECT_EQ(several.objects[0].opaque->baseColor, (Rgb{0, 1, 0}));
  EXPECT_EQ(several.objects[1].opaque->baseColor, (Rgb{0.25F, 0, 0}));
  const Scene none = load("mtllib no such file.mtl\n" + body);
  ASSERT_EQ(none.notShown.size(), 2U);
  EXPECT_EQ(none.notShown[1].what, "material files");
  EXPECT_THAT(none.notShown[1].names, testing::ElementsAre("no such file.mtl"));
}

// The mark is U+FEFF in UTF-8.
TEST_F(Obj, ByteOrderMarksAreSkipped) {
  const std::string mark = "\xEF\xBB\xBF";
  const Mesh mesh = load(mark + cubeCorners + quads).objects[0].mesh;
  EXPECT_EQ(mesh.positionsMm.size(), 8U);
  EXPECT_EQ(mesh.triangles.size(), 12U);
  EXPECT_THAT(errorOf(mark + "v 0 nan 0\n"), HasSubstr("line 1: 'nan'"));
  test::writeBytes(folder / "a.mtl", mark + "newmtl glaze\nKd 0.5 0.25 1\n");
  const Scene scene = load(mark + "mtllib a.mtl\nusemtl glaze\n" + cubeCorners + quads);
  ASSERT_TRUE(scene.objects[0].opaque);
  EXPECT_EQ(scene.objects[0].opaque->baseColor, (Rgb{0.5F, 0.25F, 1}));
}

TEST_F(Obj, BadUtf8InNamesIsHarmless) {
  const Scene scene =
      load("mtllib ../\xFF.mtl\no \xC3\x28\n" + cubeCorners + "usemtl \xFF\xFE\n" + quads);
  test::expectSound(scene);
}

TEST_F(Obj, OnePolygonOfManyCornersIsCutInBoundedTime) {
  // A comb, concave at every other corner.
  std::string text;
  std::string face = "f";
  constexpr int teeth = 4000;
  for (int i = 0; i <= 2 * teeth; ++i) {
    text += "v " + std::to_string(i) + " " + (i % 2 == 0 ? "1" : "0.1") + " 0\n";
    face += " " + std::to_string(i + 1);
  }
  text += "v 4000 -10000 0\n";
  face += " " + std::to_string(2 * teeth + 2);
  EXPECT_FALSE(load(text + face + "\n").objects[0].mesh.triangles.empty());
}

}  // namespace
}  // namespace opaline
