#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "gpu/buffer.h"
#include "gpu/command_list.h"
#include "gpu/device.h"
#include "opaline/soft_body.h"
#include "opaline/types.h"
#include "passes/soft_body/soft_body_pass.h"
#include "soft_body/cage.h"
#include "soft_body/dynamics.h"

namespace opaline {

/// A soft body on a device, without a renderer. SoftBody documents its functions.
class SoftBodyMotion {
 public:
  SoftBodyMotion(gpu::Device& device, std::span<const Vec3> restMm,
                 std::span<const Triangle> triangles, const SoftBodyOptions& options);

  void grab(const Vec3& pointMm, float radiusMm);
  void pull(const Vec3& toMm);
  void release();
  /// Returns whether there are new positions.
  bool step(double seconds);
  bool moves() const { return stillSeconds_ < neededSeconds_; }

  const soft_body::Cage& cage() const { return cage_; }
  const soft_body::Dynamics& dynamics() const { return dynamics_; }
  passes::SoftBodyState& state() { return state_; }

 private:
  // One of the steps in flight.
  struct Slot {
    explicit Slot(gpu::Device& device);

    gpu::CommandList commands;
    gpu::Buffer report;
    std::uint64_t number = 0;  // of the step that uses the slot; 0: none
    double seconds = 0;        // by which the step advances time
  };

  void disturb();
  shared::SoftStep makeStep(std::uint32_t substeps) const;
  void record(std::uint32_t substeps);
  void readReport(const Slot& slot);

  passes::SoftBodyPass pass_;
  std::array<Slot, 2> slots_;
  soft_body::Cage cage_;
  soft_body::Dynamics dynamics_;
  passes::SoftBodyState state_;
  double diagonalCells_ = 1;
  double reachCells_ = 1;
  Vec3 grabbedMm_{};
  double radiusCells_ = 1;
  std::array<double, 3> goal_{};  // cells, relative to where the body was grabbed
  bool taking_ = false;           // the next step grabs
  bool holds_ = false;
  double waiting_ = 0;           // seconds that no substep has covered yet
  std::uint64_t steps_ = 0;      // submitted
  std::uint64_t disturbed_ = 0;  // the first step that includes the last grab, pull or release
  // How long nothing is known to have moved, and how long that has to last: at the turning point of
  // a swing nothing moves either.
  double stillSeconds_ = 0;
  double neededSeconds_ = 0;
};

}  // namespace opaline
