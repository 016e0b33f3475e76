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

/// A soft body on a device, without a renderer: what SoftBody says of its functions holds here.
class SoftBodyMotion {
 public:
  SoftBodyMotion(gpu::Device& device, std::span<const Vec3> restMm,
                 std::span<const Triangle> triangles, const SoftBodyOptions& options);

  void grab(const Vec3& pointMm, float radiusMm);
  void pull(const Vec3& toMm);
  void release();
  /// Whether there is something new.
  bool step(double seconds);
  bool moves() const { return stillSeconds_ < neededSeconds_; }

  const soft_body::Cage& cage() const { return cage_; }
  const soft_body::Dynamics& dynamics() const { return dynamics_; }
  passes::SoftBodyState& state() { return state_; }

 private:
  // One of the steps that may be under way.
  struct Slot {
    explicit Slot(gpu::Device& device);

    gpu::CommandList commands;
    gpu::Buffer report;
    std::uint64_t number = 0;  // of the step that fills it; 0: none does
    double seconds = 0;        // that it makes up for
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
  std::array<double, 3> goal_{};  // cells, from where it was grabbed
  bool taking_ = false;           // the next step takes hold
  bool holds_ = false;
  double waiting_ = 0;           // seconds that no substep has gone through
  std::uint64_t steps_ = 0;      // handed to the device
  std::uint64_t disturbed_ = 0;  // the first step that the last grab, pull or release is in
  // How long nothing has moved, as far as is known, and how long it has to be: at the turn of a
  // swing nothing moves either.
  double stillSeconds_ = 0;
  double neededSeconds_ = 0;
};

}  // namespace opaline
