#pragma once

#include <memory>

#include "opaline/image.h"

namespace opaline::app::viewer {

/// Draws a small version of a texture in its file's colours, with a tooltip.
void drawThumbnail(const std::shared_ptr<const TexturePixels>& pixels, const char* about);

}  // namespace opaline::app::viewer
