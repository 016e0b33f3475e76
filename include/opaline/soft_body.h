#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "opaline/export.h"
#include "opaline/types.h"

namespace opaline {

class Renderer;

/// The properties of a soft body.
struct SoftBodyOptions {
  int cells = 10;  ///< cells of its cage along the longest side, in [2, 16]; fewer if the cage
                   ///< would have more than 1360 corners
  float swingHz = 2.5F;  ///< stiffness: frequency at which a column of the body's height sways in
                         ///< shear, Hz, in [0.25, 8]; slender bodies swing slower
  float settleSeconds = 1.5F;  ///< time in which a swing decays to a twentieth, s, in [0.1, 60]
  float heldFraction = 0.06F;  ///< part of its height that stands still, from the bottom, in
                               ///< [0, 0.9]
  float reach = 0.5F;          ///< how far a grabbed point can be pulled from its place at rest, in
                               ///< diagonals of the body's box, in [0.01, 2]
};

/// A body that gives way like jelly when it is grabbed and pulled, and swings back: extended
/// position-based dynamics (Macklin et al. 2016 and 2019) of a coarse cage of cubes, on the
/// renderer's device. While it lives, it sets the positions of the object's vertices
/// (Renderer::replacePositions). Up is +y, and the lowest part stands still.
///
/// Time advances in substeps of one length, whatever the length of the steps. So the same pulls at
/// the same times give the same motion. The renderer must outlive the body and must not be moved.
/// After Renderer::setScene the body may only be destroyed. Not thread-safe: use it on the
/// renderer's thread.
class OPALINE_API SoftBody {
 public:
  /// `object` is an index in the renderer's scene. `restMm` are the positions of its vertices at
  /// rest, mm, one for each. A mesh that is not closed is a shell as thick as a cell. Throws
  /// UsageError for an object that does not exist; positions that do not fit it, are not finite or
  /// all coincide; triangles that are missing or name vertices that do not exist; and options out
  /// of range. Throws Error when no scene is set or the device fails.
  SoftBody(Renderer& renderer, std::size_t object, std::span<const Vec3> restMm,
           std::span<const Triangle> triangles, const SoftBodyOptions& options = {});
  /// Returns the object to its mesh or rig.
  ~SoftBody();
  SoftBody(SoftBody&&) noexcept;
  SoftBody& operator=(SoftBody&&) noexcept;
  SoftBody(const SoftBody&) = delete;
  SoftBody& operator=(const SoftBody&) = delete;

  /// Grabs what lies within the radius of a point, mm, and, ever more weakly, about two cells
  /// beyond. The body's shape at the next step counts. Releases what was grabbed before. Throws
  /// UsageError unless the point is finite and the radius finite and not negative.
  void grab(const Vec3& pointMm, float radiusMm);

  /// Pulls the grabbed part so that the grabbed point moves to `toMm`, softly and never farther
  /// than the reach. Does nothing if nothing is grabbed. Throws UsageError unless `toMm` is finite.
  void pull(const Vec3& toMm);

  /// Releases the grabbed part. The body swings back.
  void release();

  /// Advances time and gives the next frame the new positions. Returns while the device works,
  /// allocates nothing, and waits only for the step before the last. Time beyond maxStepSeconds is
  /// dropped, so that a pause does not hold up the next frame. Throws UsageError unless the time is
  /// finite and not negative, or when the renderer's scene has been set again; Error when the
  /// device fails.
  void step(double seconds);

  /// The longest time of one step, s.
  static constexpr double maxStepSeconds = 0.2;

  /// Whether steps still change anything, judged by those that the device has finished. If false,
  /// no frame differs from the last until the next grab, pull or release.
  bool moves() const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace opaline
