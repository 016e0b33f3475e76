#include "viewer/session/stage.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "opaline/error.h"
#include "opaline/moment.h"

namespace opaline::app::viewer {

Stage::Stage(Renderer& renderer, const VulkanDevice& window, RenderNotes& notes)
    : renderer_(renderer),
      notes_(notes),
      apart_(window.device != renderer.vulkanDevice().device),
      view_(renderer),
      hostPicture_(window),
      hostPaper_(window),
      watch_(renderer.vulkanDevice()) {
  order_.onDevice = !apart_;
  order_.patient = false;
  order_.reuseLight = true;
}

void Stage::setScene(const Scene& scene, const Scene& before) {
  finish();
  const bool hadScene = std::exchange(hasScene_, false);
  picture_ = paperPicture_ = {};
  hostPaper_.clear();
  divided_ = false;
  paperIsPrepared_ = false;
  prepared_.reset();
  coarseView_.reset();
  restMs_ = 0;
  restSurfels_ = 0;
  notes_.clear();
  const auto set = [&](const Scene& shown) {
    renderer_.setScene(shown);
    materialClips_ = MaterialClips(shown);
    hasScene_ = true;
  };
  try {
    set(scene);
  } catch (const Error&) {
    if (hadScene) set(before);
    throw;
  }
}

// Hands the session's edits to the renderer, and returns what changes.
Edits Stage::handOver(Session& session) {
  const Scene& scene = session.scene;
  renderer_.setTime(session.time);
  if (session.edits.camera) {  // back from where the clip moved it
    renderer_.setCamera(scene.camera);
    stopCamera(session.scene);
  } else if (movesCamera(scene, session.time.clip)) {
    const float chosen = scene.camera.verticalFovDegrees;
    session.scene.camera = cameraAt(scene, session.time);
    session.scene.camera.verticalFovDegrees = chosen;
  }
  if (session.edits.lighting) renderer_.setLighting(scene.lighting);
  if (session.edits.deformers) renderer_.setDeformers(scene.deformers);
  for (std::size_t i = 0; i < session.edits.material.size(); ++i) {
    if (!session.edits.material[i]) continue;
    renderer_.setMaterial(i, materialOf(scene.objects[i]));
    materialClips_.follow(i, session.scene);
  }
  session.suns = renderer_.suns();
  Edits handedOver = std::exchange(session.edits, {});
  session.edits.material.assign(scene.objects.size(), false);
  return handedOver;
}

void Stage::collect() {
  const Waiting done = waiting_.front();
  waiting_.erase(waiting_.begin());
  const bool own = !isPaper(*done.view);
  Frame& frame = own ? frame_ : other_;
  done.view->collect(frame);
  if (apart_) (own ? hostPicture_ : hostPaper_).set(frame.images.front());
  if (!own) return;
  ++framesFinished_;
  report_ = done.view->report();
  variable_ = done.variable;
  const auto lights = [](const PassTime& pass) { return pass.name == "shadow"; };
  if (resting_ && done.view == &view_ &&
      std::any_of(frame_.passes.begin(), frame_.passes.end(), lights)) {
    restMs_ = frame_.milliseconds;
    restSurfels_ = report_.sources;
  }
}

void Stage::submit(View& view, Aov variable) {
  while (waiting_.size() >= View::framesInFlight) collect();
  order_.aovs.clear();
  if (apart_) order_.aovs.push_back(Aov::Radiance);
  if (variable != Aov::Radiance) order_.aovs.push_back(variable);
  DeviceImage& image = isPaper(view) ? paperPicture_ : picture_;
  image = {};  // if the next picture cannot be made, this one may be gone
  view.submit(order_);
  if (!apart_) image = view.picture();
  waiting_.push_back({&view, variable});
}

// A changed material makes the renderer divide the surface anew.
View& Stage::viewFor(const RenderOptions& options, const Edits& edits) {
  const bool materialChanges = std::any_of(edits.material.begin(), edits.material.end(),
                                           [](bool changes) { return changes; });
  if (!coarse_ || materialChanges) {
    view_.setOptions(coarse_ ? coarser(options) : options);
    return view_;
  }
  if (!coarseView_) coarseView_.emplace(renderer_);
  coarseView_->setOptions(coarselyDivided(options, restSurfels_));
  return *coarseView_;
}

bool Stage::wouldBlock(const Session& session) const {
  return !apart_ && (session.edits.ground || (session.divided && !paperIsPrepared_));
}

// Submits the pictures of the view and, where the session is divided, of the paper's.
void Stage::make(View& view, Aov variable) {
  if (divided_) submit(*paper_, Aov::Radiance);
  submit(view, variable);
  if (apart_) watch_.begin();
}

void Stage::draw(Session& session, int width, int height, bool moving) {
  constexpr double slowMs = 150;
  Edits edits = handOver(session);
  edits.camera = false;
  RenderOptions options = sized(session.options, width, height);
  options.treeLevel = session.treeLevel;
  resting_ = !moving;
  const bool quick = moving && session.quickWhileMoving && !session.divided && restMs_ > slowMs;
  coarse_ = quick && edits.any() && options.transport == Transport::Boundary;
  if (moving) options.antialias = 1;
  // Light at vertices can be reused while the camera moves.
  if (quick && options.sum != Sum::Pattern) options.site = Site::Vertex;
  busySince_ = std::chrono::steady_clock::now();
  divided_ = session.divided;
  if (divided_) {
    if (!paper_) paper_.emplace(renderer_);
    paper_->setOptions(paperOptions(options));
  }
  View& view = viewFor(options, edits);
  notes_.follow(options, &view != &view_);
  const RenderOptions& wanted = view.options();
  const Needs needs{wanted.transport,   wanted.sum,        wanted.site, wanted.maxSurfels,
                    wanted.maxClusters, wanted.shadowSize, session.aov};
  const bool isPrepared = prepared_ == needs && (paperIsPrepared_ || !divided_);
  prepared_ = needs;
  paperIsPrepared_ = paperIsPrepared_ || divided_;
  if (apart_ && !(moving && isPrepared)) {
    finish();
    making_ = std::async(std::launch::async,
                         [this, &view, variable = session.aov] { make(view, variable); });
    return;
  }
  make(view, session.aov);
  if (apart_) {
    // The device keeps working while the previous picture, which is done, is brought over.
    while (waiting_.size() > (divided_ ? 2 : 1)) collect();
    return;
  }
  // The next picture must be asked for after the previous frame is finished.
  while (waiting_.size() >= View::framesInFlight) collect();
}

bool Stage::hasNews() const {
  if (!making_.valid()) return isUnderWay() && watch_.isDone();
  return making_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

void Stage::takeUp() {
  if (making_.valid() && hasNews()) making_.get();
  if (isUnderWay() && !isBusy()) finish();
}

void Stage::await() const {
  if (making_.valid()) making_.wait();
}

void Stage::finish() {
  if (making_.valid()) making_.get();
  while (!waiting_.empty()) collect();
}

std::optional<DeviceImage> Stage::paper() const {
  const DeviceImage& image = apart_ ? hostPaper_.shown() : paperPicture_;
  if (!divided_ || image.view == VK_NULL_HANDLE) return std::nullopt;
  return image;
}

const Image* Stage::variableImage() const {
  return variable_ == Aov::Radiance ? nullptr : &frame_.images.back();
}

}  // namespace opaline::app::viewer
