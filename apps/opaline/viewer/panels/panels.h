#pragma once

#include "viewer/session.h"
#include "viewer/timing_history.h"

namespace opaline::app::viewer {

// What can be seen and changed beside the picture, one section each. They draw with Dear ImGui's
// functions, change the session and note in its edits what they changed.

void drawMediumPanel(Session& session);
void drawLightPanel(Session& session);
void drawMethodPanel(Session& session);
void drawMotionPanel(Session& session);
void drawViewPanel(Session& session);
void drawTimePanel(const Session& session, const TimingHistory& history);

}  // namespace opaline::app::viewer
