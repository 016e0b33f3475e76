#pragma once

#include <filesystem>

#include "opaline/scene.h"
#include "scene/raw_scene.h"
#include "scene/vector_math.h"

namespace opaline::scene {

/// Repairs every mesh and scales everything to millimetres: by the file's unit, or to a diagonal of
/// 50 mm with a note where there is none. `file` is named in errors. Camera and lights may still be
/// missing.
RawScene inMillimetres(RawScene raw, const std::filesystem::path& file, bool noteUnit,
                       const LogCallback& log, std::vector<Repair>& repairs);

/// Multiplies positions, camera and lights by `factor`, and intensities by its square, so that the
/// picture stays the same.
void scaleBy(RawScene& raw, double factor, const std::string& file);

/// Bounds of the raw scene's vertices, and their diagonal.
Bounds boundsOf(const RawScene& raw);
double diagonalOf(const Bounds& bounds);
Double3 exactMiddleOf(const Bounds& bounds);

/// Limits on a scene's diagonal. A few times beyond them, products of areas leave the range of a
/// float. At a hundredth of the shortest, the picture comes out empty.
constexpr double shortestDiagonalMm = 1e-7;
constexpr double longestDiagonalMm = 1e9;

/// Applies options and defaults to a scene in millimetres.
Scene finished(RawScene raw, const std::filesystem::path& file, std::vector<Repair> repairs,
               const LoadOptions& options);

/// The media that the options name: of all objects that are no metal, then of single ones. Throws
/// UsageError for an object that there is not. Notes what their objects had and do not show.
void setMedia(const LoadOptions& options, Scene& scene);

/// Throws UsageError for options that make no sense.
void requireSensible(const LoadOptions& options);

}  // namespace opaline::scene
