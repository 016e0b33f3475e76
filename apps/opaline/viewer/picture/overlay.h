#pragma once

#include <string>
#include <vector>

#include "viewer/picture/label_layout.h"
#include "viewer/picture/picture_painter.h"
#include "viewer/picture/projection.h"
#include "viewer/session/session.h"

namespace opaline::app::viewer {

// What stands over the picture.

/// Millimetres at the depth of the camera's target, and beneath, in red, green and blue, how far
/// light travels in the medium before it is deflected and before it fades.
void drawScaleBar(const Session& session, const Projection& projection, const Area& area,
                  LabelLayout& labels);

/// The divider with the names of the methods on its sides, where there is room for them.
void drawDivider(const Session& session, const Area& area, LabelLayout& labels);

/// At the bottom left of a picture.
void drawLegend(const std::string& text, const Area& area, LabelLayout& labels);

/// The window's keys, over everything, until the next key or click.
void drawKeys(const Area& area);

/// What the window has to say.
struct Caption {
  std::string text;
  bool isError = false;
};

/// At the top left, one below the other; an error in a colour of its own.
void drawCaptions(const std::vector<Caption>& captions, const Area& area);
/// What they take of the picture.
Box boxOf(const std::vector<Caption>& captions, const Area& area);

}  // namespace opaline::app::viewer
