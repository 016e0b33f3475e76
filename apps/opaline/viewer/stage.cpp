#include "viewer/stage.h"

#include <algorithm>

namespace opaline::app::viewer {

void Stage::setScene(const Scene& scene) {
  finish();
  hasScene_ = false;
  picture_ = {};
  paper_.reset();
  renderer_.setScene(scene);
  hasScene_ = true;
}

// Whether light changes, not only the camera.
bool Stage::handOver(Session& session) {
  Edits others = session.edits;
  others.camera = false;
  const Scene& scene = session.scene;
  if (session.edits.camera) renderer_.setCamera(scene.camera);
  if (session.edits.lighting) renderer_.setLighting(scene.lighting);
  if (session.edits.deformers) renderer_.setDeformers(scene.deformers);
  for (std::size_t i = 0; i < session.edits.medium.size(); ++i) {
    if (session.edits.medium[i]) renderer_.setMedium(i, scene.objects[i].medium);
  }
  session.edits = {};
  session.edits.medium.assign(scene.objects.size(), false);
  return others.any();
}

void Stage::collect() {
  const bool own = waiting_.front();
  waiting_.erase(waiting_.begin());
  renderer_.collect(own ? frame_ : other_);
  if (!own) return;
  ++framesFinished_;
  const auto lights = [](const PassTime& pass) { return pass.name == "shadow"; };
  if (resting_ && std::any_of(frame_.passes.begin(), frame_.passes.end(), lights)) {
    restMs_ = frame_.milliseconds;
  }
}

void Stage::submit(const RenderOptions& options, const std::vector<Aov>& aovs, DeviceImage& to,
                   bool own) {
  while (waiting_.size() >= Renderer::framesInFlight) collect();
  to = renderer_.submitOnDevice(options, aovs);
  waiting_.push_back(own);
}

void Stage::draw(Session& session, int width, int height, bool moving) {
  constexpr double slowMs = 150;
  const bool lightChanges = handOver(session);
  RenderOptions options = sized(session.options, width, height);
  options.reuseLight = true;
  options.patient = false;
  options.treeLevel = session.treeLevel;
  resting_ = !moving;
  const bool quick = moving && session.quickWhileMoving && !session.divided && restMs_ > slowMs;
  preview_ = quick && lightChanges && options.transport == Transport::Boundary;
  if (moving) options.antialias = 1;
  // Light at vertices stays while the camera moves.
  if (quick && options.sum != Sum::Pattern) options.site = Site::Vertex;
  if (preview_) options.transport = Transport::BetterDipole;
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
