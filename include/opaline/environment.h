#pragma once

#include <filesystem>
#include <memory>

#include "opaline/export.h"
#include "opaline/image.h"

namespace opaline {

/// A latitude-longitude picture that lights a scene.
struct EnvironmentFile {
  std::filesystem::path file;
  float intensity = 1;         ///< factor of its radiance, in [0, 1e6]
  double rotationDegrees = 0;  ///< about +y, counter-clockwise seen from above; in [-1e6, 1e6]
};

/// The picture as it lights the scene. Throws Error when it cannot be read or its intensity
/// makes a pixel infinite.
OPALINE_API std::shared_ptr<const Image> readEnvironment(const EnvironmentFile& from);

/// A latitude-longitude picture turned about +y, counter-clockwise seen from above: what shone from
/// +z shines from +x after 90 degrees. Every row moves left by degrees/360 of its width. If that is
/// not a whole number of columns, each pixel becomes the linear mixture of the two that it falls
/// between, so that no light is lost.
OPALINE_API Image turned(const Image& environment, double degrees);

}  // namespace opaline
