#include "viewer/picture/picture_view.h"

#include <optional>

#include "viewer/picture/variable_display.h"

namespace opaline::app::viewer {

void PictureView::take(const Stage& stage, const Session& session) {
  const Image* image = stage.variableImage();
  if (image == nullptr) return;
  const Aov variable = stage.variable();
  variable_.set(isLight(variable) ? *image : asColors(*image, variable, session.surfelIndex));
  variableShown_ = variable;
}

void PictureView::drawShown(VkCommandBuffer commands, const Session& session, const Stage& stage,
                            const TruthView& truth, const Area& area) const {
  const ToneOptions plain = plainTone(session.tone);
  const auto draw = [&](const DeviceImage& image, const ToneOptions& tone) {
    const Area place =
        fitted(area, static_cast<int>(image.extent.width), static_cast<int>(image.extent.height));
    painter_.draw(commands, image, place, place, tone);
  };
  if (session.shown != Shown::Picture && truth.hasPicture()) {
    if (session.shown == Shown::Truth) return draw(truth.truth(), session.tone);
    return draw(truth.heatMap(), plain);
  }
  const bool variable = session.aov != Aov::Radiance && variableShown_ == session.aov;
  if (variable && !variable_.empty()) {
    return draw(variable_.shown(), isLight(session.aov) ? session.tone : plain);
  }
  // After a resize, the picture briefly has another size than the window.
  if (stage.picture().view != VK_NULL_HANDLE) draw(stage.picture(), session.tone);
}

void PictureView::draw(VkCommandBuffer commands, const Session& session, const Stage& stage,
                       const TruthView& truth, const Area& area) const {
  drawShown(commands, session, stage, truth, area);
  const std::optional<DeviceImage> paper = stage.paper();
  if (!paper || session.shown != Shown::Picture) return;
  Area left = area;
  left.width = static_cast<int>(session.divider * static_cast<float>(area.width));
  painter_.draw(commands, *paper, area, left, session.tone);
}

}  // namespace opaline::app::viewer
