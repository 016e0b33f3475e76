#include "renderer/scene/prepared_scenes.h"

#include <algorithm>
#include <utility>

namespace opaline {

PreparedScenes::PreparedScenes(gpu::Device& device, Passes& passes, LogCallback log)
    : device_(device), passes_(passes), log_(std::move(log)) {}

std::shared_ptr<PreparedScene> PreparedScenes::share(const RenderOptions& options,
                                                     const FramePlan& plan,
                                                     const EditedScene& edited,
                                                     std::shared_ptr<PreparedScene> present) {
  const auto fits = [&](const std::shared_ptr<PreparedScene>& scene) {
    return scene && scene->fits(options, plan, edited);
  };
  if (!fits(present)) {
    std::vector<std::shared_ptr<PreparedScene>> others;
    for (const std::weak_ptr<PreparedScene>& other : shared_) others.push_back(other.lock());
    const auto found = std::find_if(others.begin(), others.end(), fits);
    present = found != others.end() ? *found : nullptr;
  }
  last_ = present;  // frees what nobody needs before memory for the next is allocated
  std::erase_if(shared_, [](const auto& scene) { return scene.expired(); });
  if (!present) {
    present = last_ = std::make_shared<PreparedScene>(device_, passes_, log_);
    shared_.push_back(present);
  }
  return present;
}

void PreparedScenes::clear() {
  for (const std::weak_ptr<PreparedScene>& scene : shared_)
    if (const std::shared_ptr<PreparedScene> present = scene.lock()) present->clear();
}

}  // namespace opaline
