#include "viewer/session/stage.h"

#include <algorithm>

namespace opaline::app::viewer {

Stage::Stage(Renderer& renderer, const VulkanDevice& window)
    : renderer_(renderer),
      apart_(window.device != renderer.vulkanDevice().device),
      hostPicture_(window),
      hostPaper_(window),
      watch_(renderer.vulkanDevice()) {}

void Stage::setScene(const Scene& scene) {
  finish();
  hasScene_ = false;
  picture_ = paper_ = {};
  hostPicture_.clear();
  hostPaper_.clear();
  divided_ = false;
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
  const Waiting done = waiting_.front();
  waiting_.erase(waiting_.begin());
  Frame& frame = done.own ? frame_ : other_;
  renderer_.collect(frame);
  if (apart_) (done.own ? hostPicture_ : hostPaper_).set(frame.images.front());
  if (!done.own) return;
  ++framesFinished_;
  variable_ = done.variable;
  const auto lights = [](const PassTime& pass) { return pass.name == "shadow"; };
  if (resting_ && std::any_of(frame_.passes.begin(), frame_.passes.end(), lights)) {
    restMs_ = frame_.milliseconds;
  }
}

void Stage::submit(const RenderOptions& options, Aov variable, bool own) {
  while (waiting_.size() >= Renderer::framesInFlight) collect();
  aovs_.clear();
  if (apart_) aovs_.push_back(Aov::Radiance);
  if (variable != Aov::Radiance) aovs_.push_back(variable);
  if (apart_) {
    renderer_.submit(options, aovs_);
  } else {
    DeviceImage& image = own ? picture_ : paper_;
    image = {};  // where the next cannot be made, this one may be gone
    image = renderer_.submitOnDevice(options, aovs_);
  }
  waiting_.push_back({own, variable});
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
  coarse_ = quick && lightChanges && options.transport == Transport::Boundary;
  if (moving) options.antialias = 1;
  // Light at vertices stays while the camera moves.
  if (quick && options.sum != Sum::Pattern) options.site = Site::Vertex;
  if (coarse_) options = coarser(options);
  busySince_ = std::chrono::steady_clock::now();
  divided_ = session.divided;
  if (divided_) submit(paperOptions(options), Aov::Radiance, false);
  submit(options, session.aov, true);
  if (apart_) {
    watch_.begin();
    // The device works on while the picture before, which is done, is brought over.
    while (waiting_.size() > (divided_ ? 2 : 1)) collect();
    return;
  }
  // What is drawn next was asked for after the frame before this one was finished.
  while (waiting_.size() >= Renderer::framesInFlight) collect();
}

void Stage::takeUp() {
  if (isUnderWay() && !isBusy()) finish();
}

void Stage::finish() {
  while (!waiting_.empty()) collect();
}

std::optional<DeviceImage> Stage::paper() const {
  if (!divided_ || (apart_ && hostPaper_.empty())) return std::nullopt;
  return apart_ ? hostPaper_.shown() : paper_;
}

const Image* Stage::variableImage() const {
  return variable_ == Aov::Radiance ? nullptr : &frame_.images.back();
}

}  // namespace opaline::app::viewer
