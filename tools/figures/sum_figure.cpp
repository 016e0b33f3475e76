// The paper's sum and the one in object space, each above its difference from the exact integral.

#include <array>
#include <vector>

#include "figures.h"
#include "opaline/compare.h"
#include "reference/integral.h"
#include "reference/picture.h"

namespace opaline::figures {

namespace {

constexpr int panelPixels = 360;

/// The bear has no rig, so it is at rest.
reference::Scene atRest(const Scene& scene) {
  reference::Scene result;
  for (const Object& object : scene.objects) {
    reference::Body body;
    for (const Vec3& p : object.mesh.positionsMm) body.positionsMm.push_back({p[0], p[1], p[2]});
    for (const Vec3& n : object.mesh.normals) body.normals.push_back({n[0], n[1], n[2]});
    body.triangles = object.mesh.triangles;
    body.medium = object.medium;
    result.bodies.push_back(body);
  }
  result.lighting = scene.lighting;
  result.camera = scene.camera;
  return result;
}

Image exactExitance(const Scene& scene) {
  const reference::Scene bodies = atRest(scene);
  const reference::Geometry geometry(bodies);
  const reference::Irradiance irradiance(geometry);
  const reference::Integral integral(geometry, irradiance, {});
  reference::PictureOptions options;
  options.width = options.height = panelPixels;
  options.aov = Aov::Exitance;
  return makePicture(geometry, irradiance,
                     {[&](const reference::SurfacePoint& point) { return integral.at(point); },
                      exitFactors(bodies, Transport::Dipole)},
                     options)
      .image;
}

Image8 heatmap(const Image& found, const Image& truth) {
  constexpr double top = 0.5;
  const compare::Selection selection = compare::commonPixels(found, truth);
  return compare::drawHeatmap(compare::relativeErrors(found, truth, selection), selection, top);
}

void sums(Studio& studio, const char* name) {
  Scene scene = bear("marble", 50);
  scene.lighting = {};
  scene.lighting.directional = {{{0.45F, 0.35F, -0.82F}, {6, 6, 6}}};
  const Image truth = exactExitance(scene);
  studio.renderer.setScene(scene);
  std::vector<Image8> pictures;
  std::vector<Image8> maps;
  for (RenderOptions options : {paperMethod(), objectSpace()}) {
    pictures.push_back(photograph(studio, options, {0, panelPixels, panelPixels}));
    options.width = options.height = panelPixels;
    maps.push_back(heatmap(studio.renderer.render(options, {Aov::Exitance}).images.at(0), truth));
  }
  const int width = maps[0].width;
  publish(studio, name,
          sheet({padded(pictures[0], width, white), padded(pictures[1], width, white), maps[0],
                 maps[1]},
                2, gapPixels, white));
}

}  // namespace

std::span<const Figure> sumFigures() {
  static constexpr std::array all{Figure{"sums", sums}};
  return all;
}

}  // namespace opaline::figures
