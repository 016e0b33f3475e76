// A still: the built-in bear of jade, lit from behind, as a picture and as numbers.
//
//     still [picture.png [radiance.exr [exitance.exr]]]
#include <opaline/opaline.h>

#include <cstdio>
#include <string_view>

namespace {

/// A scene is plain data: copy it, change it, keep it as long as you like.
opaline::Scene makeScene() {
  opaline::LoadOptions load;
  load.diagonalMm = 50;                               // the size decides how deep light goes
  load.medium = opaline::findMedium("jade");          // or a Medium of your own
  opaline::Scene scene = opaline::builtInBear(load);  // loadScene("file.glb", load) reads a file

  // Lengths are millimetres, y is up, directions are unit vectors, light is linear RGB.
  scene.lighting = {};
  scene.lighting.directional.push_back({{0.6F, 0, -0.8F}, {6, 6, 5}});
  scene.lighting.directional.push_back({{0, 1, 0}, {0.5F, 0.5F, 0.6F}});
  scene.lighting.ambient = {0.05F, 0.05F, 0.05F};
  return scene;  // its camera sees the bear from the front; scene.camera is yours to place
}

}  // namespace

int main(int count, char** words) try {
  const char* const pictureFile = count > 1 ? words[1] : "still.png";
  const char* const radianceFile = count > 2 ? words[2] : "still.exr";
  const char* const exitanceFile = count > 3 ? words[3] : "still_exitance.exr";

  // The renderer owns the device. It never prints; it passes its messages to a function.
  opaline::RendererOptions device;
  device.log = [](opaline::LogLevel, std::string_view message) {
    std::printf("note: %.*s\n", static_cast<int>(message.size()), message.data());
  };
  opaline::Renderer renderer(device);

  const opaline::Scene scene = makeScene();
  renderer.setScene(scene);  // copies what it needs to the device

  opaline::RenderOptions
      options;  // a default, a range and a unit is beside each in render_options.h
  options.width = 320;
  options.height = 320;
  const opaline::RenderResult result =
      renderer.render(options, {opaline::Aov::Radiance, opaline::Aov::Exitance});

  // Images are linear floats. A picture to look at needs an exposure and a tone curve.
  opaline::ToneOptions tone;
  tone.exposureStops = opaline::automaticExposureStops(scene);
  tone.background = opaline::Rgb{0.02F, 0.02F, 0.02F};
  opaline::writePng({pictureFile}, opaline::toneMap(result.images[0], tone));
  opaline::writeExr({radianceFile}, result.images[0]);
  opaline::writeExr({exitanceFile}, result.images[1]);

  const float* const middle = result.images[1].pixel(options.width / 2, options.height / 2);
  std::printf("exitance in the middle: %g %g %g, on %s, %zu triangles, %.1f ms\n",
              static_cast<double>(middle[0]), static_cast<double>(middle[1]),
              static_cast<double>(middle[2]), result.report.device.name.c_str(),
              result.report.triangles, result.report.frameMilliseconds);
  return 0;
} catch (const opaline::Error& error) {  // bad input or a failing device: one sentence each
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
