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

/// A rectangle of pixels, given by its upper left corner and size.
struct Region {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

/// Options of paths from the eye.
struct EyePathOptions {
  bool specular = true;     ///< shows what visible surfaces mirror
  double roughness = 0.25;  ///< of media that have none of their own
};

/// Which pixels of which variable. Pixels left out count as not covered.
struct PictureOptions {
  int width = 1024;                ///< pixels, in [1, 16384]
  int height = 1024;               ///< pixels, in [1, 16384]
  Aov aov = Aov::Radiance;         ///< any but those of the diffusion source map
  int antialias = 4;               ///< samples per pixel of Aov::Radiance: 1, 2, 4 or 8
  bool environmentBehind = false;  ///< for Aov::Radiance, where there is no surface
  std::optional<Region> region;
  int every = 1;          ///< render only columns and rows that are multiples of this
  int pathsOfPixel = 64;  ///< in path tracing, from the eye, in [1, 1e6]
  EyePathOptions eye;
};

/// Throws UsageError for options out of range.
void requireSound(const PictureOptions& options);

/// A point of a surface as the eye sees it.
struct Look {
  const SurfacePoint& point;
  Vector toEye;
  bool radiance;         ///< else exitance: the share of arriving light that is reflected diffusely
  std::uint64_t number;  ///< of this look among all of a picture
};

/// The light that leaves the surface, however it got there. The functions are called from several
/// threads at once.
struct LeavingLight {
  /// The exitance of a medium.
  std::function<Exitance(const SurfacePoint& point)> exitance;
  /// Per body: radiance per exitance, without the Fresnel transmittance towards the camera. It is
  /// 1/π for Eq. 5 of Gong et al. 2008.
  std::vector<double> exitFactor;
  /// The light of an opaque body: its mean and one standard error.
  std::function<Exitance(const Look& look)> look;
  /// Whether `look` also gives the radiance of media, with what they mirror.
  bool looksAtMedia = false;
};

/// What opaque bodies reflect diffusely of light that comes straight from lights and sky.
Exitance directLightOf(const Scene& scene, const Irradiance& irradiance, const Look& look);

/// 1/π for the classic dipole; 1/(π F̄_t) with the energy-conserving exit of d'Eon 2012.
std::vector<double> exitFactors(const Scene& scene, Transport transport);

/// Errors of the pixels' values, relative to each channel, over the pixels that are lit.
struct ErrorSummary {
  double mean = 0;
  double percentile95 = 0;
  double largest = 0;
};

struct Picture {
  Image image;
  std::size_t pixels = 0;  ///< that see a surface
  ErrorSummary error;      ///< empty for variables that are exact
};

/// Whether the variable depends on the light that leaves the surface.
bool showsExitance(Aov aov);

/// Whether a chosen pixel shows a translucent body. Throws UsageError for options out of range.
bool seesMedia(const Geometry& geometry, const PictureOptions& options);

/// Called now and then, by one thread at a time but not always the same one.
using PictureProgress = std::function<void(std::size_t done, std::size_t total)>;

/// Throws UsageError for options out of range. The result does not depend on the number of threads.
Picture makePicture(const Geometry& geometry, const Irradiance& irradiance,
                    const LeavingLight& light, const PictureOptions& options,
                    const PictureProgress& progress = {});

}  // namespace opaline::reference
