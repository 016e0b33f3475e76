#include "passes/shade/specular_albedo.h"

#include "bssrdf/fresnel.h"
#include "passes/shade/ggx_lobe.h"

namespace opaline::passes {

std::vector<float> specularAlbedo(double eta, double roughness) {
  constexpr std::uint32_t samples = 1024;
  const auto reflectance = [&](double cosine) { return bssrdf::fresnelReflectance(eta, cosine); };
  std::vector<float> entries;
  entries.reserve(specularAlbedoEntries);
  for (int i = 0; i < specularAlbedoEntries; ++i)
    entries.push_back(static_cast<float>(mirroredOfAll(
        roughness * roughness, (i + 0.5) / specularAlbedoEntries, samples, reflectance)));
  return entries;
}

}  // namespace opaline::passes
