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

/// What all pictures are made with.
struct Studio {
  std::filesystem::path models;
  std::filesystem::path output;
  Renderer renderer;
  int shrunk = 1;  ///< by which photographs are smaller than usual, each way, and unknowns fewer
};

/// What one panel shows, and how bright.
struct Exposure {
  float stops = 0;
  int width = 512;
  int height = 512;
};

/// A model of the paper's, or a glTF character, scaled to that diagonal.
Scene load(const Studio& studio, const std::string& file, std::string_view medium, float diagonalMm,
           const std::string& morphTo = "");

/// The built-in bear or teapot.
Scene bear(std::string_view medium, float diagonalMm);
Scene teapot(std::string_view medium, float diagonalMm);

/// A key from behind at the side, a rim from behind at the other, a weak fill from the front.
Lighting stageLight();

/// What `opaline render --method paper` stands for: dipole, pattern, fragments.
RenderOptions paperMethod();

/// The dipole summed in object space.
RenderOptions objectSpace();

/// What is rendered where nothing else is asked for, in the light of finer shadow maps.
RenderOptions usual();

/// Positions to [0,1]³ over the box of the surface.
Image overBox(Image map, const Bounds& bounds);

/// Directions from [-1,1] to [0,1].
Image asColour(Image map);

/// The scene that the renderer has been given, rendered twice as large as it is shown, over dark
/// paper.
Image8 photograph(Studio& studio, RenderOptions options, const Exposure& exposure);

Image8 develop(const Image& radiance, float stops, const Paper& paper = dark);

/// Writes a JPEG and says so.
void publish(const Studio& studio, const std::string& name, const Image8& picture);

}  // namespace opaline::figures
