#include "viewer/stage.h"

namespace opaline::app::viewer {

void Stage::setScene(const Scene& scene) {
  finish();
  hasScene_ = false;
  picture_ = {};
  paper_.reset();
  renderer_.setScene(scene);
  hasScene_ = true;
}

void Stage::handOver(Session& session) {
  const Scene& scene = session.scene;
  if (session.edits.camera) renderer_.setCamera(scene.camera);
  if (session.edits.lighting) renderer_.setLighting(scene.lighting);
  if (session.edits.deformers) renderer_.setDeformers(scene.deformers);
  for (std::size_t i = 0; i < session.edits.medium.size(); ++i) {
    if (session.edits.medium[i]) renderer_.setMedium(i, scene.objects[i].medium);
  }
  session.edits = {};
  session.edits.medium.assign(scene.objects.size(), false);
}

void Stage::collect() {
  const bool own = waiting_.front();
  waiting_.erase(waiting_.begin());
  renderer_.collect(own ? frame_ : other_);
  if (own) ++framesFinished_;
}

void Stage::submit(const RenderOptions& options, const std::vector<Aov>& aovs, DeviceImage& to,
                   bool own) {
  while (waiting_.size() >= Renderer::framesInFlight) collect();
  to = renderer_.submitOnDevice(options, aovs);
  waiting_.push_back(own);
}

void Stage::draw(Session& session, int width, int height) {
  handOver(session);
  RenderOptions options = session.options;
  options.width = width;
  options.height = height;
  options.reuseLight = true;
  options.patient = false;
  aovs_.clear();
  if (session.aov != Aov::Radiance) aovs_.push_back(session.aov);
  if (session.divided) {
    if (!paper_) paper_.emplace();
    submit(paperOptions(options), {}, *paper_, false);
  } else {
    paper_.reset();
  }
  submit(options, aovs_, picture_, true);
  // What is drawn next was asked for after the frame before this one was finished.
  while (waiting_.size() >= Renderer::framesInFlight) collect();
}

void Stage::finish() {
  while (!waiting_.empty()) collect();
}

}  // namespace opaline::app::viewer
