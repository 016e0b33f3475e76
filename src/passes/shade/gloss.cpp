#include "passes/shade/gloss.h"

#include <cmath>
#include <cstdint>

#include "passes/shade/ggx_lobe.h"
#include "shaders/shared/opaque.h"

namespace opaline::passes {

std::vector<std::array<float, 2>> glossTable() {
  constexpr std::uint32_t samples = 256;
  constexpr double entries = shared::glossEntries;
  const auto grazing = [](double cosine) { return std::pow(1 - cosine, 5); };
  std::vector<std::array<float, 2>> table;
  for (std::uint32_t i = 0; i < shared::glossEntries; ++i) {
    const double roughness = (i + 0.5) / entries;
    const double alpha = roughness * roughness;
    for (std::uint32_t j = 0; j < shared::glossEntries; ++j) {
      const double cosine = (j + 0.5) / entries;
      const double all = mirroredOfAll(alpha, cosine, samples, [](double) { return 1.0; });
      const double edge = mirroredOfAll(alpha, cosine, samples, grazing);
      table.push_back({static_cast<float>(all - edge), static_cast<float>(edge)});
    }
  }
  return table;
}

}  // namespace opaline::passes
