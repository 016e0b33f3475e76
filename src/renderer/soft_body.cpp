#include "opaline/soft_body.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "gpu/command_list.h"
#include "gpu/device.h"
#include "opaline/error.h"
#include "opaline/renderer.h"
#include "opaline/vulkan.h"
#include "passes/soft_body/soft_body_pass.h"
#include "soft_body/cage.h"
#include "soft_body/dynamics.h"

namespace opaline {

namespace {

using Offset = std::array<double, 3>;

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
    const auto [low, high] = std::minmax_element(
        positionsMm.begin(), positionsMm.end(),
        [axis](const Vec3& a, const Vec3& b) { return a[axis] < b[axis]; });
    const double extent =
        static_cast<double>((*high)[axis]) - static_cast<double>((*low)[axis]);
    square += extent * extent;
  }
  return std::sqrt(square);
}

Offset between(const Vec3& from, const Vec3& to) {
  Offset offset{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    offset[axis] = static_cast<double>(to[axis]) - static_cast<double>(from[axis]);
  return offset;
}

double lengthOf(const Offset& offset) {
  return std::hypot(offset[0], offset[1], offset[2]);
}

// One of the steps that may be under way.
struct StepSlot {
  StepSlot(gpu::Device& device, std::size_t bytes)
      : commands(device, "soft body", 2),
        report(device, {.name = "report of a soft body (readback)",
                        .bytes = bytes,
                        .memory = gpu::Memory::Readback}) {}

  gpu::CommandList commands;
  gpu::Buffer report;
  std::uint64_t number = 0;  // of the step that fills it; 0: none does
};

}  // namespace

class SoftBody::Implementation {
 public:
  Implementation(Renderer& renderer, std::size_t object, std::span<const Vec3> restMm,
                 std::span<const Triangle> triangles, const SoftBodyOptions& options)
      : renderer_(renderer),
        device_(renderer.device()),
        scene_(renderer.sceneNumber()),
        object_(object),
        pass_(device_),
        slots_{StepSlot(device_, sizeof(shared::SoftReport)),
               StepSlot(device_, sizeof(shared::SoftReport))} {
    validate(options);
    const std::size_t vertices = renderer.vertexCount(object);
    if (restMm.size() != vertices)
      throw UsageError(fmt::format("object {} has {} vertices, but its soft body {} positions",
                                   object, vertices, restMm.size()));
    for (const Vec3& p : restMm) requireFinite(p, "a position of a soft body");
    const soft_body::Cage cage = soft_body::makeCage(
        restMm, triangles, static_cast<std::uint32_t>(options.cells),
        static_cast<double>(options.heldFraction), shared::maxSoftNodes);
    cellMm_ = cage.cellMm;
    originMm_ = cage.originMm;
    dynamics_ =
        soft_body::makeDynamics(cage, {.swingHz = static_cast<double>(options.swingHz),
                                       .settleSeconds = static_cast<double>(options.settleSeconds)});
    diagonalCells_ = diagonalOf(restMm) / cellMm_;
    reachCells_ = static_cast<double>(options.reach) * diagonalCells_;
    state_ = passes::SoftBodyPass::makeState(device_, cage, restMm);
    renderer_.replacePositions(object_, {.buffer = state_.positions.handle()});
  }

  // Frames that read the positions may still be under way.
  ~Implementation() {
    device_.waitIdle();
    if (renderer_.sceneNumber() == scene_) renderer_.restorePositions(object_);
  }
  Implementation(const Implementation&) = delete;
  Implementation& operator=(const Implementation&) = delete;

  void grab(const Vec3& pointMm, float radiusMm) {
    requireFinite(pointMm, "the place at which a soft body is grabbed");
    if (!std::isfinite(radiusMm) || radiusMm < 0)
      throw UsageError(
          fmt::format("a soft body is grabbed within a radius of 0 mm or more, not {}", radiusMm));
    grabbedMm_ = pointMm;
    radiusCells_ = static_cast<double>(radiusMm) / cellMm_ + leastRadiusCells;
    goal_ = {};
    taking_ = true;
    holds_ = true;
    disturb();
  }

  void pull(const Vec3& toMm) {
    requireFinite(toMm, "the place to which a soft body is pulled");
    if (!holds_) return;
    Offset offset = between(grabbedMm_, toMm);
    // Far beyond the reach it is the direction that counts.
    const double farthest = 100 * reachCells_ * cellMm_;
    const double scale = std::min(1.0, farthest / std::max(lengthOf(offset), farthest)) / cellMm_;
    for (double& value : offset) value *= scale;
    if (offset == goal_) return;
    goal_ = offset;
    disturb();
  }

  void release() {
    if (!holds_) return;
    holds_ = taking_ = false;
    disturb();
  }

  void step(double seconds) {
    if (!std::isfinite(seconds) || seconds < 0)
      throw UsageError(
          fmt::format("a soft body moves on by a time of 0 s or more, not {}", seconds));
    if (renderer_.sceneNumber() != scene_)
      throw UsageError("the scene has been set anew since this soft body was made of its object");
    if (!moves() && !holds_) {
      waiting_ = 0;
      return;
    }
    waiting_ += std::min(seconds, maxStepSeconds);
    const double substeps = std::floor(waiting_ / dynamics_.substepSeconds);
    if (substeps < 1) return;
    waiting_ -= substeps * dynamics_.substepSeconds;
    record(static_cast<std::uint32_t>(substeps));
  }

  bool moves() const { return !still_ || disturbed_ > reported_; }

 private:
  // Every point of the body has nodes within it.
  static constexpr double leastRadiusCells = 1.8;
  // Of the diagonal: nothing that a picture shows.
  static constexpr double stillPart = 1e-4;
  static constexpr double stillPartPerSecond = 1e-3;

  void disturb() { disturbed_ = steps_ + 1; }

  shared::SoftStep makeStep(std::uint32_t substeps) const {
    shared::SoftStep step{};
    if (taking_) {
      for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        step.grab[axis] =
            static_cast<float>((static_cast<double>(grabbedMm_[i]) - originMm_[i]) / cellMm_);
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
    step.stillStep =
        static_cast<float>(stillPartPerSecond * diagonalCells_ * dynamics_.substepSeconds);
    step.stillShift = static_cast<float>(stillPart * diagonalCells_);
    step.substeps = substeps;
    step.holds = holds_ ? 1 : 0;
    return step;
  }

  void record(std::uint32_t substeps) {
    StepSlot& slot = slots_[steps_ % slots_.size()];
    slot.commands.begin();
    readReport(slot);
    pass_.swing(slot.commands, makeStep(substeps), state_);
    pass_.embed(slot.commands, state_);
    slot.commands.copyBuffer(state_.report, slot.report, sizeof(shared::SoftReport));
    slot.commands.use(slot.report, gpu::Access::HostRead);
    slot.commands.submit();
    slot.number = ++steps_;
    taking_ = false;
  }

  // Of the step that the slot was used for last, which is done.
  void readReport(const StepSlot& slot) {
    if (slot.number == 0) return;
    shared::SoftReport report{};
    std::memcpy(&report, slot.report.mappedAs<shared::SoftReport>().data(), sizeof(report));
    reported_ = slot.number;
    still_ = report.still != 0;
  }

  Renderer& renderer_;
  gpu::Device& device_;
  std::uint64_t scene_;
  std::size_t object_;
  passes::SoftBodyPass pass_;
  std::array<StepSlot, 2> slots_;
  passes::SoftBodyState state_;
  soft_body::Dynamics dynamics_;
  double cellMm_ = 1;
  std::array<double, 3> originMm_{};
  double diagonalCells_ = 1;
  double reachCells_ = 1;
  Vec3 grabbedMm_{};
  double radiusCells_ = 1;
  Offset goal_{};       // cells, from where it was grabbed
  bool taking_ = false;  // the next step takes hold
  bool holds_ = false;
  double waiting_ = 0;  // seconds that no substep has gone through
  std::uint64_t steps_ = 0;      // handed to the device
  std::uint64_t disturbed_ = 0;  // the first step that the last grab, pull or release is in
  std::uint64_t reported_ = 0;   // the last step that is known to be done
  bool still_ = true;            // after that one
};

SoftBody::SoftBody(Renderer& renderer, std::size_t object, std::span<const Vec3> restMm,
                   std::span<const Triangle> triangles, const SoftBodyOptions& options)
    : implementation_(
          std::make_unique<Implementation>(renderer, object, restMm, triangles, options)) {}
SoftBody::~SoftBody() = default;
SoftBody::SoftBody(SoftBody&&) noexcept = default;
SoftBody& SoftBody::operator=(SoftBody&&) noexcept = default;

void SoftBody::grab(const Vec3& pointMm, float radiusMm) {
  implementation_->grab(pointMm, radiusMm);
}

void SoftBody::pull(const Vec3& toMm) {
  implementation_->pull(toMm);
}

void SoftBody::release() {
  implementation_->release();
}

void SoftBody::step(double seconds) {
  implementation_->step(seconds);
}

bool SoftBody::moves() const {
  return implementation_->moves();
}

}  // namespace opaline
