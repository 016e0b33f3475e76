// Usage: draw_cpp SCENE SECONDS auto|fragment RADIANCE.exr EXITANCE.exr

#include <opaline/opaline.h>

#include <cstdio>
#include <cstdlib>
#include <string>

int main(int count, char** values) try {
  if (count != 6) return 2;
  opaline::Renderer renderer;
  renderer.setScene(opaline::loadScene(values[1]));
  renderer.setTime({.seconds = std::atof(values[2])});
  opaline::RenderOptions options;
  options.width = 96;
  options.height = 64;
  options.maxSurfels = 8192;
  options.maxClusters = 1024;
  if (std::string(values[3]) == "fragment") options.site = opaline::Site::Fragment;
  const auto images =
      renderer.render(options, {opaline::Aov::Radiance, opaline::Aov::Exitance}).images;
  opaline::writeExr({values[4]}, images[0]);
  opaline::writeExr({values[5]}, images[1]);
} catch (const opaline::Error& error) {
  std::fprintf(stderr, "draw: %s\n", error.what());
  return 1;
}
