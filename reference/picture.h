#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "opaline/image.h"
#include "opaline/renderer.h"
#include "reference/exitance.h"
#include "reference/geometry.h"
#include "reference/irradiance.h"

namespace opaline::reference {

/// A rectangle of pixels, from the upper left corner.
struct Region {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

/// Of paths from the eye.
struct EyePathOptions {
  bool specular = true;     ///< whether what is seen shows what it mirrors
  double roughness = 0.25;  ///< of the surface of media that state none
};

/// Which pixels of which variable; those left out are not covered.
struct PictureOptions {
  int width = 1024;                ///< pixels, in [1, 16384]
  int height = 1024;               ///< pixels, in [1, 16384]
  Aov aov = Aov::Radiance;         ///< but for those of the diffusion source map
  int antialias = 4;               ///< samples a pixel of Aov::Radiance: 1, 2, 4 or 8
  bool environmentBehind = false;  ///< of Aov::Radiance, where no surface is
  std::optional<Region> region;
  int every = 1;          ///< only columns and rows whose number is a multiple of this
  int pathsOfPixel = 64;  ///< of path tracing, from the eye, in [1, 1e6]
  EyePathOptions eye;
};

/// Throws UsageError for options out of range.
void requireSound(const PictureOptions& options);

/// A look at a point of a surface.
struct Look {
  const SurfacePoint& point;
  Vector toEye;
  bool radiance;         ///< else exitance: of what arrives, the share that is given back diffusely
  std::uint64_t number;  ///< of this look among all of a picture
};

/// What leaves the surface, by whatever way light got there. The functions are called from several
/// threads at once.
struct LeavingLight {
  /// Of a medium.
  std::function<Exitance(const SurfacePoint& point)> exitance;
  /// Per body: radiance per exitance without the Fresnel transmittance towards the camera, 1/π for
  /// Eq. 5 of Gong et al. 2008.
  std::vector<double> exitFactor;
  /// Of an opaque body, its mean and one standard error.
  std::function<Exitance(const Look& look)> look;
  /// Whether that knows radiance of media too, with what they mirror.
  bool looksAtMedia = false;
};

/// What opaque bodies give back of the light of lights and sky alone, but for reflections.
Exitance directLightOf(const Scene& scene, const Irradiance& irradiance, const Look& look);

/// 1/π for the classic dipole; with the energy-conserving exit of d'Eon 2012, 1/(π F̄_t).
std::vector<double> exitFactors(const Scene& scene, Transport transport);

/// How far the pixels' values may be off, relative to each channel of each, over those that shine.
struct ErrorSummary {
  double mean = 0;
  double percentile95 = 0;
  double largest = 0;
};

struct Picture {
  Image image;
  std::size_t pixels = 0;  ///< that see a surface
  ErrorSummary error;      ///< nothing for variables that are exact
};

/// Whether the variable needs what leaves the surface.
bool showsExitance(Aov aov);

/// Called now and then, by one thread at a time but not always the same.
using PictureProgress = std::function<void(std::size_t done, std::size_t total)>;

/// Throws UsageError for options out of range. The result does not depend on the number of threads.
Picture makePicture(const Geometry& geometry, const Irradiance& irradiance,
                    const LeavingLight& light, const PictureOptions& options,
                    const PictureProgress& progress = {});

}  // namespace opaline::reference
