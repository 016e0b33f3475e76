#include "renderer/motion/soft_body_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "opaline/error.h"

namespace opaline {

namespace {

// Large enough that every point of the body has nodes within this radius.
constexpr double leastRadiusCells = 1.8;

// Larger distances are clamped to this.
constexpr double farCells = 1e6;

// Limits below which no motion is visible: diagonals, and diagonals per second.
constexpr double stillShift = 1e-4;
constexpr double stillSpeed = 1e-3;

// A body that stands still this far from its rest pose, in diagonals, for `strayPeriods` of its
// swing is pulled back by a force that grows over `homePeriods`.
constexpr double strayShift = 5e-3;
constexpr double strayPeriods = 1;
constexpr double homePeriods = 4;
constexpr double homeMost = 0.05;

void requireWithin(double value, double least, double most, const char* name) {
  if (!(value >= least && value <= most))
    throw UsageError(
        fmt::format("{} of a soft body is in [{}, {}], not {}", name, least, most, value));
}

void validate(const SoftBodyOptions& options) {
  requireWithin(options.cells, 2, 16, "cells");
  requireWithin(static_cast<double>(options.swingHz), 0.25, 8, "swingHz");
  requireWithin(static_cast<double>(options.settleSeconds), 0.1, 60, "settleSeconds");
  requireWithin(static_cast<double>(options.heldFraction), 0, 0.9, "heldFraction");
  requireWithin(static_cast<double>(options.reach), 0.01, 2, "reach");
}

void requireFinite(const Vec3& p, const char* what) {
  if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
    throw UsageError(fmt::format("{} is not finite", what));
}

double diagonalOf(std::span<const Vec3> positionsMm) {
  double square = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [low, high] =
        std::minmax_element(positionsMm.begin(), positionsMm.end(),
                            [axis](const Vec3& a, const Vec3& b) { return a[axis] < b[axis]; });
    const double extent = static_cast<double>((*high)[axis]) - static_cast<double>((*low)[axis]);
    square += extent * extent;
  }
  return std::sqrt(square);
}

soft_body::Cage cageOf(std::span<const Vec3> restMm, std::span<const Triangle> triangles,
                       const SoftBodyOptions& options) {
  validate(options);
  for (const Vec3& p : restMm) requireFinite(p, "a position of a soft body");
  return soft_body::makeCage(restMm, triangles, static_cast<std::uint32_t>(options.cells),
                             static_cast<double>(options.heldFraction), shared::maxSoftNodes);
}

}  // namespace

SoftBodyMotion::Slot::Slot(gpu::Device& device)
    : commands(device, "soft body", 2),
      report(device, {.name = "report of a soft body (readback)",
                      .bytes = sizeof(shared::SoftReport),
                      .memory = gpu::Memory::Readback}) {}

SoftBodyMotion::SoftBodyMotion(gpu::Device& device, std::span<const Vec3> restMm,
                               std::span<const Triangle> triangles, const SoftBodyOptions& options)
    : pass_(device),
      slots_{Slot(device), Slot(device)},
      cage_(cageOf(restMm, triangles, options)),
      dynamics_(soft_body::makeDynamics(cage_, static_cast<double>(options.swingHz),
                                        static_cast<double>(options.settleSeconds))),
      state_(passes::SoftBodyPass::makeState(device, cage_, restMm)),
      diagonalCells_(diagonalOf(restMm) / cage_.cellMm),
      reachCells_(static_cast<double>(options.reach) * diagonalCells_),
      stillSeconds_(1 / static_cast<double>(options.swingHz)),
      neededSeconds_(stillSeconds_) {}

void SoftBodyMotion::grab(const Vec3& pointMm, float radiusMm) {
  requireFinite(pointMm, "the place at which a soft body is grabbed");
  if (!std::isfinite(radiusMm) || radiusMm < 0)
    throw UsageError(fmt::format(
        "a soft body can only be grabbed within a radius of 0 mm or more, not {}", radiusMm));
  grabbedMm_ = pointMm;
  radiusCells_ =
      std::min(static_cast<double>(radiusMm) / cage_.cellMm, farCells) + leastRadiusCells;
  goal_ = {};
  taking_ = true;
  holds_ = true;
  disturb();
}

void SoftBodyMotion::pull(const Vec3& toMm) {
  requireFinite(toMm, "the place to which a soft body is pulled");
  if (!holds_) return;
  std::array<double, 3> goal{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    goal[axis] =
        (static_cast<double>(toMm[axis]) - static_cast<double>(grabbedMm_[axis])) / cage_.cellMm;
  // Far beyond the reach only the direction counts.
  const double farthest = 100 * reachCells_;
  const double scale = farthest / std::max(std::hypot(goal[0], goal[1], goal[2]), farthest);
  for (double& value : goal) value *= scale;
  if (goal == goal_) return;
  goal_ = goal;
  disturb();
}

void SoftBodyMotion::release() {
  if (!holds_) return;
  holds_ = taking_ = false;
  disturb();
}

void SoftBodyMotion::disturb() {
  disturbed_ = steps_ + 1;
  stillSeconds_ = 0;
}

bool SoftBodyMotion::step(double seconds) {
  if (!std::isfinite(seconds) || seconds < 0)
    throw UsageError(
        fmt::format("a soft body can only move on by a time of 0 s or more, not {}", seconds));
  if (!moves()) {
    waiting_ = 0;
    return false;
  }
  waiting_ += std::min(seconds, SoftBody::maxStepSeconds);
  const double substeps = std::floor(waiting_ / dynamics_.substepSeconds);
  if (substeps < 1) return false;
  waiting_ -= substeps * dynamics_.substepSeconds;
  record(static_cast<std::uint32_t>(substeps));
  return true;
}

shared::SoftStep SoftBodyMotion::makeStep(std::uint32_t substeps) const {
  shared::SoftStep step{};
  if (taking_) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<std::size_t>(axis);
      const double place = (static_cast<double>(grabbedMm_[i]) - cage_.originMm[i]) / cage_.cellMm;
      step.grab[axis] = static_cast<float>(std::clamp(place, -farCells, farCells));
    }
    step.grab.w = static_cast<float>(1 / radiusCells_);
  }
  step.goal = {goal_[0], goal_[1], goal_[2], dynamics_.follow};
  step.shear = static_cast<float>(dynamics_.shear);
  step.compliance = static_cast<float>(dynamics_.compliance);
  step.anchor = static_cast<float>(dynamics_.anchor);
  step.grip = static_cast<float>(dynamics_.grip);
  step.damping = static_cast<float>(dynamics_.damping);
  step.reach = static_cast<float>(reachCells_);
  step.stillStep = static_cast<float>(stillSpeed * diagonalCells_ * dynamics_.substepSeconds);
  step.stillShift = static_cast<float>(stillShift * diagonalCells_);
  const double period = neededSeconds_ / dynamics_.substepSeconds;
  step.strayShift = static_cast<float>(strayShift * diagonalCells_);
  step.strayFrom = static_cast<float>(strayPeriods * period);
  step.homePerSubstep = static_cast<float>(1 / (homePeriods * period));
  step.homeMost = static_cast<float>(homeMost);
  step.substeps = substeps;
  step.holds = holds_ ? 1 : 0;
  return step;
}

void SoftBodyMotion::record(std::uint32_t substeps) {
  Slot& slot = slots_[steps_ % slots_.size()];
  slot.commands.begin();
  readReport(slot);
  pass_.swing(slot.commands, makeStep(substeps), state_);
  pass_.embed(slot.commands, state_);
  slot.commands.copyBuffer(state_.report, slot.report, sizeof(shared::SoftReport));
  slot.commands.use(slot.report, gpu::Access::HostRead);
  slot.commands.submit();
  slot.number = ++steps_;
  slot.seconds = substeps * dynamics_.substepSeconds;
  taking_ = false;
}

// Reads the report of the slot's last step, which has finished.
void SoftBodyMotion::readReport(const Slot& slot) {
  if (slot.number == 0 || slot.number < disturbed_) return;
  shared::SoftReport report{};
  std::memcpy(&report, slot.report.mappedAs<shared::SoftReport>().data(), sizeof(report));
  stillSeconds_ = report.still != 0 ? stillSeconds_ + slot.seconds : 0;
}

}  // namespace opaline
