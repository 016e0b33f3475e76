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

/// Positions, camera and lights times `factor`; intensities times its square, so that the picture
/// stays.
void scaleBy(RawScene& raw, double factor, const std::string& file);

/// Bounds of the raw scene's vertices, and their diagonal.
Bounds boundsOf(const RawScene& raw);
double diagonalOf(const Bounds& bounds);
Double3 exactMiddleOf(const Bounds& bounds);

/// Of a scene. Beyond a few times that, products of areas leave the range of a float, and a
/// hundredth of the shortest comes out empty.
constexpr double shortestDiagonalMm = 1e-7;
constexpr double longestDiagonalMm = 1e9;

/// Applies options and defaults to a scene in millimetres.
Scene finished(RawScene raw, const std::filesystem::path& file, std::vector<Repair> repairs,
               const LoadOptions& options);

/// The media that the options name: of all objects that are no metal, then of single ones. Throws
/// UsageError for an object that there is not.
void setMedia(const LoadOptions& options, Scene& scene);

/// Throws UsageError for options that make no sense.
void requireSensible(const LoadOptions& options);

}  // namespace opaline::scene
