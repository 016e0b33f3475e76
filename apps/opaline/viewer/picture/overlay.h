#pragma once

#include <string>
#include <vector>

#include "viewer/picture/label_layout.h"
#include "viewer/picture/picture_painter.h"
#include "viewer/picture/projection.h"
#include "viewer/session/session.h"

namespace opaline::app::viewer {

// Elements drawn over the picture.

/// A scale in millimetres at the depth of the camera's target. Below it, in red, green and blue,
/// how far light travels in the medium before it is deflected and before it fades.
void drawScaleBar(const Session& session, const Projection& projection, const Area& area,
                  LabelLayout& labels);

/// The divider with the names of the methods on its sides, if there is room for them.
void drawDivider(const Session& session, const Area& area, LabelLayout& labels);

/// A text at the bottom left of a picture.
void drawLegend(const std::string& text, const Area& area, LabelLayout& labels);

/// The scale of a heat map at the right, from no error to `top`, a relative error.
void drawHeatScale(double top, const std::vector<Rgb>& colors, const Area& area,
                   LabelLayout& labels);

/// The list of the window's keys, over everything, until the next key or click.
void drawKeys(const Area& area);

/// A message of the window.
struct Caption {
  std::string text;
  bool isError = false;
};

/// Shows captions at the top left, one below the other; errors have their own colour.
void drawCaptions(const std::vector<Caption>& captions, const Area& area);
/// The area that they cover.
Box boxOf(const std::vector<Caption>& captions, const Area& area);

}  // namespace opaline::app::viewer
