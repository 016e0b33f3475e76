#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "opaline/types.h"
#include "passes/products.h"
#include "shaders/shared/soft_body.h"
#include "soft_body/cage.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// A soft body on the device: its cage, how that moves, and where it takes the body's vertices.
struct SoftBodyState {
  gpu::Buffer cells;      ///< eight nodes each
  gpu::Buffer nodes;      ///< shared::SoftNode
  gpu::Buffer motions;    ///< shared::SoftMotion, one a node
  gpu::Buffer turns;      ///< vec4 a cell: its rotation as a quaternion
  gpu::Buffer grips;      ///< vec4 a node: how it was shifted when it was taken hold of; how firmly
  gpu::Buffer moves;      ///< three floats for each corner of each cell
  gpu::Buffer report;     ///< shared::SoftReport
  gpu::Buffer firstPart;  ///< soft_body::Spread
  gpu::Buffer parts;
  gpu::Buffer grid;       ///< three floats a place, cells
  gpu::Buffer rest;       ///< three floats a vertex, mm
  gpu::Buffer positions;  ///< three floats a vertex, mm
  std::array<float, 4> origin{};         ///< of the grid, mm; edge of a cell, mm
  std::array<std::uint32_t, 4> size{};  ///< of the grid; number of vertices
  std::uint32_t cellCount = 0;
  std::uint32_t nodeCount = 0;
};

/// Swings a soft body's cage and moves its vertices along.
class SoftBodyPass {
 public:
  explicit SoftBodyPass(gpu::Device& device);

  /// At rest. There are at most shared::maxSoftNodes nodes, and positions.
  static SoftBodyState makeState(gpu::Device& device, const soft_body::Cage& cage,
                                 std::span<const Vec3> restMm);

  /// Moves the cage on in time. Numbers of cells and nodes are filled in.
  void swing(gpu::CommandList& commands, shared::SoftStep step, SoftBodyState& state) const;

  /// Moves the vertices to where the cage is, for shaders to read.
  void embed(gpu::CommandList& commands, SoftBodyState& state) const;

 private:
  gpu::Pipeline swing_;
  gpu::Pipeline spread_;
  gpu::Pipeline embed_;
};

}  // namespace opaline::passes
