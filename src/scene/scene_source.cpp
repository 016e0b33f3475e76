#include "scene/scene_source.h"

#include <utility>

namespace opaline::scene {

SceneSource sourceOf(const std::filesystem::path& model, const LoadOptions& options) {
  SceneSource source;
  source.model = model;
  source.diagonalMm = options.diagonalMm;
  source.morphTo = options.morphTo;
  return withAbsolutePaths(std::move(source));
}

SceneSource withAbsolutePaths(SceneSource source) {
  if (source.sceneFile) source.sceneFile = std::filesystem::absolute(*source.sceneFile);
  if (!source.isBuiltIn()) source.model = std::filesystem::absolute(source.model);
  if (source.morphTo) source.morphTo = std::filesystem::absolute(*source.morphTo);
  if (source.environment) {
    source.environment->file = std::filesystem::absolute(source.environment->file);
  }
  return source;
}

void rescale(SceneSource& source, double factor, double modelDiagonalMm) {
  source.diagonalMm = factor * modelDiagonalMm;
  for (auto& [name, placement] : source.placements) {
    for (float& component : placement.translationMm) {
      component = static_cast<float>(factor * double{component});
    }
    if (!placement.rows) continue;
    for (const std::size_t entry : {3U, 7U, 11U}) (*placement.rows)[entry] *= factor;
  }
}

}  // namespace opaline::scene
