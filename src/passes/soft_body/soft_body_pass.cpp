#include "passes/soft_body/soft_body_pass.h"

#include <algorithm>
#include <cassert>
#include <cstring>
#include <vector>

#include "gpu/device.h"
#include "gpu/transfer.h"
#include "soft_body/spread.h"

namespace opaline::passes {

namespace {

template <typename T>
gpu::Buffer makeTable(gpu::Device& device, const char* name, const std::vector<T>& data) {
  return gpu::makeBuffer(device, name, data, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
}

std::vector<shared::SoftNode> nodesOf(const soft_body::Cage& cage) {
  std::vector<shared::SoftNode> nodes;
  for (std::size_t n = 0; n < cage.nodes.size(); ++n)
    nodes.push_back({static_cast<float>(cage.nodes[n][0]), static_cast<float>(cage.nodes[n][1]),
                     static_cast<float>(cage.nodes[n][2]), cage.held[n] ? 1U : 0U});
  return nodes;
}

std::vector<std::uint32_t> cornersOf(const soft_body::Cage& cage) {
  std::vector<std::uint32_t> masses(cage.nodes.size(), 0);
  for (const auto& cell : cage.cells)
    for (const std::uint32_t n : cell)
      if (!cage.held[n]) ++masses[n];
  std::vector<std::uint32_t> corners;
  for (const auto& cell : cage.cells)
    for (const std::uint32_t n : cell) corners.push_back(n | masses[n] << shared::softMassShift);
  return corners;
}

}  // namespace

SoftBodyPass::SoftBodyPass(gpu::Device& device)
    : swing_(device, "swing of a soft body"),
      spread_(device, "grid of a soft body"),
      embed_(device, "vertices of a soft body") {}

SoftBodyState SoftBodyPass::makeState(gpu::Device& device, const soft_body::Cage& cage,
                                      std::span<const Vec3> restMm) {
  assert(cage.nodes.size() <= shared::maxSoftNodes && !restMm.empty());
  SoftBodyState state;
  state.firstOfColour = cage.firstOfColour;
  state.nodeCount = static_cast<std::uint32_t>(cage.nodes.size());
  const std::size_t cells = cage.cells.size();
  const std::size_t nodes = state.nodeCount;
  state.cells = makeTable(device, "cells of a soft body", cornersOf(cage));
  state.nodes = makeTable(device, "nodes of a soft body", nodesOf(cage));
  state.motions =
      makeTable(device, "motion of a soft body", std::vector<shared::SoftMotion>(nodes));
  state.turns =
      makeTable(device, "turns of a soft body", std::vector<shared::vec4>(cells, {0, 0, 0, 1}));
  state.grips = makeTable(device, "grips of a soft body", std::vector<shared::vec4>(nodes));
  state.report = makeTable(device, "report of a soft body", std::vector<shared::SoftReport>(1));
  const soft_body::Spread spread = soft_body::makeSpread(cage);
  const std::size_t places = spread.firstPart.size() - 1;
  state.firstPart = makeTable(device, "first parts of a soft body", spread.firstPart);
  state.parts = makeTable(device, "parts of a soft body", spread.parts);
  state.grid = gpu::Buffer(device, {.name = "grid of a soft body",
                                    .bytes = places * sizeof(shared::vec4),
                                    .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT |
                                             VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT});
  state.rest = gpu::makeBuffer(device, "soft body at rest", std::as_bytes(restMm),
                               VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
  state.positions = gpu::makeBuffer(device, "soft body", std::as_bytes(restMm),
                                    VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
  const auto originOf = [&](std::size_t axis) {
    return static_cast<float>(cage.originMm[axis] - cage.cellMm);
  };
  state.origin = {originOf(0), originOf(1), originOf(2), static_cast<float>(cage.cellMm)};
  state.size = {spread.size[0], spread.size[1], spread.size[2],
                static_cast<std::uint32_t>(restMm.size())};
  return state;
}

void SoftBodyPass::swing(gpu::CommandList& commands, shared::SoftStep step,
                         SoftBodyState& state) const {
  step.nodeCount = state.nodeCount;
  std::copy(state.firstOfColour.begin(), state.firstOfColour.end(), step.firstOfColour);
  commands.beginPass("swing");
  commands.bind(swing_,
                {.corners = state.cells,
                 .nodes = state.nodes,
                 .motions = state.motions,
                 .turns = state.turns,
                 .grips = state.grips,
                 .report = state.report},
                {.now = step});
  commands.dispatch(1);
  commands.endPass();
}

void SoftBodyPass::embed(gpu::CommandList& commands, SoftBodyState& state) const {
  commands.beginPass("embed");
  const std::uint32_t places = state.size[0] * state.size[1] * state.size[2];
  commands.bind(spread_,
                {.motions = state.motions,
                 .firstPart = state.firstPart,
                 .parts = state.parts,
                 .grid = state.grid},
                {.count = places});
  commands.dispatchLinear(places);
  commands.bind(embed_, {.rest = state.rest, .grid = state.grid, .positions = state.positions},
                {.origin = state.origin, .size = state.size});
  commands.dispatchLinear(state.size[3]);
  commands.use(state.positions, gpu::Access::StorageRead);
  commands.endPass();
}

}  // namespace opaline::passes
