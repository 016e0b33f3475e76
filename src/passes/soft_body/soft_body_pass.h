#pragma once

#include <array>
#include <cstdint>
#include <glm/vec4.hpp>
#include <span>

#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "opaline/types.h"
#include "passes/products.h"
#include "shaders/shared/soft_body.h"
#include "shaders/soft_body/embed.comp.h"
#include "shaders/soft_body/spread.comp.h"
#include "shaders/soft_body/swing.comp.h"
#include "soft_body/cage.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// A soft body on the device: its cage, the cage's motion, and the body's vertices that follow it.
struct SoftBodyState {
  gpu::Buffer cells;      ///< eight corners each, see shared::softMassShift
  gpu::Buffer nodes;      ///< shared::SoftNode
  gpu::Buffer motions;    ///< shared::SoftMotion, one per node
  gpu::Buffer turns;      ///< vec4 per cell: its rotation as a quaternion
  gpu::Buffer grips;      ///< vec4 per node: its displacement when it was grabbed; w: how firmly
  gpu::Buffer report;     ///< shared::SoftReport
  gpu::Buffer firstPart;  ///< soft_body::Spread
  gpu::Buffer parts;
  gpu::Buffer grid;       ///< vec4 per place: xyz in cells; also read as texels
  gpu::Buffer rest;       ///< three floats per vertex, mm
  gpu::Buffer positions;  ///< three floats per vertex, mm
  glm::vec4 origin{0};    ///< of the grid, mm; w: edge of a cell, mm
  glm::uvec4 size{0};     ///< of the grid; w: number of vertices
  std::array<std::uint32_t, shared::softColours + 1> firstOfColour{};  ///< cell
  std::uint32_t nodeCount = 0;
};

/// Swings a soft body's cage and moves its vertices along.
class SoftBodyPass {
 public:
  explicit SoftBodyPass(gpu::Device& device);

  /// Makes a body at rest. The cage has at most shared::maxSoftNodes nodes, and there is at least
  /// one position.
  static SoftBodyState makeState(gpu::Device& device, const soft_body::Cage& cage,
                                 std::span<const Vec3> restMm);

  /// Advances the cage in time. Fills in the members of `step` that depend on the cage.
  void swing(gpu::CommandList& commands, shared::SoftStep step, SoftBodyState& state) const;

  /// Moves the vertices along with the cage, for shaders to read.
  void embed(gpu::CommandList& commands, SoftBodyState& state) const;

 private:
  gpu::Compute<shaders::SoftBodySwing> swing_;
  gpu::Compute<shaders::SoftBodySpread> spread_;
  gpu::Compute<shaders::SoftBodyEmbed> embed_;
};

}  // namespace opaline::passes
