#pragma once

#include <memory>

#include "opaline/image.h"

namespace opaline::app::viewer {

/// Draws a texture small, as its file has its colours, with the tooltip on it.
void drawThumbnail(const std::shared_ptr<const TexturePixels>& pixels, const char* about);

}  // namespace opaline::app::viewer
