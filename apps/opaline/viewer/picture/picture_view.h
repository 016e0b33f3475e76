#pragma once

#include <vulkan/vulkan.h>

#include "opaline/renderer.h"
#include "viewer/picture/host_picture.h"
#include "viewer/picture/picture_painter.h"
#include "viewer/session/session.h"
#include "viewer/session/stage.h"
#include "viewer/session/truth_view.h"

namespace opaline::app::viewer {

/// What the picture's area shows: picture, variable, truth or heat map.
class PictureView {
 public:
  PictureView(const VulkanDevice& device, VkRenderPass renderPass)
      : painter_(device, renderPass), variable_(device) {}

  /// Takes over the variable from the stage's last frame, if it has one.
  void take(const Stage& stage, const Session& session);
  void draw(VkCommandBuffer commands, const Session& session, const Stage& stage,
            const TruthView& truth, const Area& area) const;

 private:
  void drawShown(VkCommandBuffer commands, const Session& session, const Stage& stage,
                 const TruthView& truth, const Area& area) const;

  PicturePainter painter_;
  HostPicture variable_;
  Aov variableShown_ = Aov::Radiance;  // the variable in variable_
};

}  // namespace opaline::app::viewer
