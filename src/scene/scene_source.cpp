#include "scene/scene_source.h"

#include <utility>

namespace opaline::scene {

namespace {

void moveApart(Placement& placement, double factor) {
  for (float& component : placement.translationMm) {
    component = static_cast<float>(factor * double{component});
  }
  if (!placement.rows) return;
  for (const std::size_t entry : {3U, 7U, 11U}) (*placement.rows)[entry] *= factor;
}

}  // namespace

SceneSource withAbsolutePaths(SceneSource source) {
  if (source.sceneFile) source.sceneFile = std::filesystem::absolute(*source.sceneFile);
  for (ModelSource& model : source.models) {
    if (!model.isBuiltIn()) model.file = std::filesystem::absolute(model.file);
    if (model.morphTo) model.morphTo = std::filesystem::absolute(*model.morphTo);
  }
  if (source.environment) {
    source.environment->file = std::filesystem::absolute(source.environment->file);
  }
  return source;
}

void rescale(SceneSource& source, double factor, const std::vector<double>& modelDiagonalsMm) {
  for (std::size_t i = 0; i < source.models.size(); ++i) {
    source.models[i].diagonalMm = factor * modelDiagonalsMm.at(i);
    if (source.models[i].placement) moveApart(*source.models[i].placement, factor);
  }
  for (auto& [name, placement] : source.placements) moveApart(placement, factor);
}

}  // namespace opaline::scene

namespace opaline {

SceneSource sourceOf(const std::filesystem::path& model, const LoadOptions& options) {
  SceneSource source;
  source.models.push_back({model, options.diagonalMm, options.morphTo, {}});
  source.colorModel = options.colorModel;
  return scene::withAbsolutePaths(std::move(source));
}

}  // namespace opaline
