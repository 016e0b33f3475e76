#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "compose.h"
#include "opaline/image_file.h"
#include "opaline/renderer.h"
#include "opaline/scene.h"
#include "opaline/tone.h"

namespace opaline::figures {

inline constexpr Paper white{255, 255, 255};
inline constexpr Paper dark{28, 28, 33};
inline constexpr int gapPixels = 8;

/// What all pictures share.
struct Studio {
  std::filesystem::path models;
  std::filesystem::path output;
  Renderer renderer;
  int shrunk = 1;  ///< divisor of the edges of photographs and of the number of unknowns
};

/// The size and brightness of a panel.
struct Exposure {
  float stops = 0;
  int width = 512;
  int height = 512;
};

/// Loads a model of the paper's, or a glTF character, scaled to that diagonal.
Scene load(const Studio& studio, const std::string& file, std::string_view medium, float diagonalMm,
           const std::string& morphTo = "");

/// The built-in bear or teapot.
Scene bear(std::string_view medium, float diagonalMm);
Scene teapot(std::string_view medium, float diagonalMm);

/// A key light from behind on one side, a rim light from behind on the other, a weak fill from the
/// front.
Lighting stageLight();

/// The options of `opaline render --method paper`: dipole, pattern, fragments.
RenderOptions paperMethod();

/// Options for the dipole summed in object space.
RenderOptions objectSpace();

/// The default options, with finer shadow maps.
RenderOptions usual();

/// Maps positions to [0,1]³ over the surface's box.
Image overBox(Image map, const Bounds& bounds);

/// Maps directions from [-1,1] to [0,1].
Image asColour(Image map);

/// Renders the renderer's scene at twice the size shown, over dark paper.
Image8 photograph(Studio& studio, RenderOptions options, const Exposure& exposure);

Image8 develop(const Image& radiance, float stops, const Paper& paper = dark);

/// Writes a JPEG and prints its name.
void publish(const Studio& studio, const std::string& name, const Image8& picture);

}  // namespace opaline::figures
