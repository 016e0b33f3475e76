// A moving mesh of your own: a waving ball of wax, with sixty sets of positions per second from
// your program.
//
//     moving_mesh [frames [picture.png]]
#include <opaline/opaline.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <utility>
#include <vector>

namespace {

constexpr int rings = 48;
constexpr int sides = 96;
constexpr float radiusMm = 20;

/// Computes the positions at a time: rings from pole to pole.
void moveTo(double seconds, std::vector<opaline::Vec3>& positionsMm) {
  positionsMm.clear();
  for (int ring = 0; ring <= rings; ++ring) {
    const double latitude = std::numbers::pi * ring / rings;
    for (int side = 0; side < (ring == 0 || ring == rings ? 1 : sides); ++side) {
      const double longitude = 2 * std::numbers::pi * side / sides;
      const double wave = 1 + 0.12 * std::sin(latitude) * std::sin(3 * longitude + 4 * seconds);
      positionsMm.push_back(
          {static_cast<float>(radiusMm * wave * std::sin(latitude) * std::cos(longitude)),
           static_cast<float>(radiusMm * std::cos(latitude)),
           static_cast<float>(-radiusMm * wave * std::sin(latitude) * std::sin(longitude))});
    }
  }
}

/// Triangles are counter-clockwise seen from outside. The mesh is closed, so it has an inside.
std::vector<opaline::Triangle> makeTriangles() {
  const auto at = [](int ring, int side) -> std::uint32_t {
    if (ring == 0) return 0;
    if (ring == rings) return static_cast<std::uint32_t>(1 + (rings - 1) * sides);
    return static_cast<std::uint32_t>(1 + (ring - 1) * sides + side % sides);
  };
  std::vector<opaline::Triangle> triangles;
  for (int ring = 0; ring < rings; ++ring) {
    for (int side = 0; side < sides; ++side) {
      if (ring > 0) triangles.push_back({at(ring, side), at(ring + 1, side), at(ring, side + 1)});
      if (ring + 1 < rings)
        triangles.push_back({at(ring, side + 1), at(ring + 1, side), at(ring + 1, side + 1)});
    }
  }
  return triangles;
}

opaline::Scene makeScene() {
  std::vector<opaline::Vec3> positionsMm;
  moveTo(0, positionsMm);
  opaline::Object ball;
  ball.name = "ball";
  ball.medium = opaline::findMedium("wax").value();
  ball.mesh = opaline::makeMesh(positionsMm, makeTriangles());  // finds the normals
  opaline::Scene scene;
  scene.objects.push_back(std::move(ball));
  scene.camera = opaline::defaultCamera(scene, {0, 0.4F, 1});
  scene.lighting = opaline::defaultLighting();
  return scene;
}

}  // namespace

int main(int count, char** words) try {
  const int frames = count > 1 ? std::atoi(words[1]) : 60;
  const opaline::Scene scene = makeScene();
  opaline::Renderer renderer;
  renderer.setScene(scene);

  // A view renders one picture again and again. It keeps its images, so frames allocate nothing.
  opaline::RenderOptions options;
  options.width = options.height = 256;
  opaline::View view(renderer, options);

  std::vector<opaline::Vec3> positionsMm;
  opaline::Frame frame;
  double milliseconds = 0;
  for (int i = 0; i < frames; ++i) {
    moveTo(i / 60.0, positionsMm);
    renderer.replacePositions(0, positionsMm);  // copied: change them again at once
    view.submit();                              // returns while the device works
    if (i == 0) continue;  // so one frame is rendered while the next is prepared
    view.collect(frame);   // the previous one
    milliseconds += frame.milliseconds;
  }
  if (frames > 0) view.collect(frame);
  milliseconds += frame.milliseconds;

  if (frames > 0)
    opaline::writePng({count > 2 ? words[2] : "moving_mesh.png"},
                      opaline::toneMap(frame.images[0], {opaline::automaticExposureStops(scene)}));
  std::printf("%d frames, %.2f ms each on the device\n", frames,
              milliseconds / std::max(frames, 1));
  return 0;
} catch (const opaline::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
