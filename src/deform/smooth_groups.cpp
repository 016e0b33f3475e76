#include "deform/smooth_groups.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace opaline::deform {

std::vector<std::uint32_t> smoothGroups(const Mesh& mesh) {
  std::vector<std::uint32_t> group(mesh.positionsMm.size());
  std::iota(group.begin(), group.end(), std::uint32_t{0});
  if (mesh.facetted) return group;
  const auto key = [&](std::uint32_t v) { return std::tie(mesh.positionsMm[v], mesh.normals[v]); };
  std::vector<std::uint32_t> order = group;
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return key(a) != key(b) ? key(a) < key(b) : a < b;
  });
  for (std::size_t i = 1; i < order.size(); ++i)
    if (key(order[i]) == key(order[i - 1])) group[order[i]] = group[order[i - 1]];
  return group;
}

}  // namespace opaline::deform
