#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "opaline/types.h"

namespace opaline {

class Renderer;

/// What a soft body is like.
struct SoftBodyOptions {
  int cells = 10;  ///< of its cage along the longest side, in [2, 16]; fewer where the cage would
                   ///< have more than 1360 corners
  float swingHz = 2.5F;  ///< as stiff as a column of its height that sways in shear that often,
                         ///< Hz, in [0.25, 8]; slender bodies swing slower
  float settleSeconds = 1.5F;  ///< until a swing has fallen to a twentieth, s, in [0.1, 60]
  float heldFraction = 0.06F;  ///< of its height, from below, that stands still, in [0, 0.9]
  float reach = 0.5F;  ///< farthest that a place is asked to be from where it rests, in diagonals
                       ///< of the body's box, in [0.01, 2]
};

/// A body that gives way like jelly where it is grabbed and pulled, and swings back: extended
/// position-based dynamics (Macklin et al. 2016 and 2019) of a coarse cage of cubes, on the
/// renderer's device. While it lives, the object's vertices are where it puts them
/// (Renderer::replacePositions); up is +y, and its lowest part stands still.
///
/// Time goes on in substeps of one length, whatever the length of the steps: the same places pulled
/// at the same times give the same motion. The renderer stays where it is and outlives it; after
/// Renderer::setScene it may only be destroyed. Not thread-safe, and of the renderer's thread.
class SoftBody {
 public:
  /// The object with that index in the renderer's scene; `restMm`: where its vertices are at rest,
  /// mm, one for each. A mesh that is not closed is a shell as thick as a cell. Throws UsageError
  /// for an object that does not exist, positions that do not fit it, are not finite or are all one
  /// point, triangles that are missing or name vertices that do not exist, and options out of
  /// range; Error when no scene is set or the device fails.
  SoftBody(Renderer& renderer, std::size_t object, std::span<const Vec3> restMm,
           std::span<const Triangle> triangles, const SoftBodyOptions& options = {});
  /// Gives the object back to its mesh or rig. Waits for the device.
  ~SoftBody();
  SoftBody(SoftBody&&) noexcept;
  SoftBody& operator=(SoftBody&&) noexcept;
  SoftBody(const SoftBody&) = delete;
  SoftBody& operator=(const SoftBody&) = delete;

  /// Takes hold of what lies within the radius of a point, mm, as the body is at the next step; at
  /// least of what lies within about two cells, the less the farther away it is. Where something is
  /// held, it is let go. Throws UsageError unless the point is finite and the radius finite and not
  /// negative.
  void grab(const Vec3& pointMm, float radiusMm);

  /// Pulls what is held so that the point it was grabbed at comes to `toMm`, softly and never
  /// farther than the reach. Does nothing where nothing is held. Throws UsageError unless it is
  /// finite.
  void pull(const Vec3& toMm);

  /// Lets go of what is held. The body swings back.
  void release();

  /// Moves on in time and hands the next frame the new positions. Returns while the device works;
  /// allocates nothing, and waits only for the last step but one. Of more than maxStepSeconds the
  /// rest is lost, so that a pause does not hold up the frame after it. Throws UsageError unless
  /// the time is finite and not negative, or when the renderer's scene has been set anew; Error
  /// when the device fails.
  void step(double seconds);

  /// The longest time that one step makes up for.
  static constexpr double maxStepSeconds = 0.2;

  /// Whether steps still change anything, as far as steps that are done have told. False: until the
  /// next grab, pull or release no frame differs from the last.
  bool moves() const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace opaline
