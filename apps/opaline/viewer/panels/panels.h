#pragma once

#include "viewer/files/saver.h"
#include "viewer/panels/timing_history.h"
#include "viewer/picture/projection.h"
#include "viewer/session/session.h"
#include "viewer/session/truth_view.h"

namespace opaline::app::viewer {

// The panels beside the picture, one section each. They draw with Dear ImGui, change the session
// and note in its edits what they changed.

/// For panels of one object: lets the user choose it, where there are several.
void chooseObject(Session& session);

void drawMediumPanel(Session& session);
void drawMaterialPanel(Session& session);
void drawLightPanel(Session& session, const Projection& projection);
void drawMethodPanel(Session& session);
void drawMotionPanel(Session& session);
void drawTruthPanel(Session& session, const TruthView& truth);
void drawViewPanel(Session& session);
void drawTimePanel(const Session& session, const TimingHistory& history);
void drawSavePanel(Session& session, const Saver& saver);

}  // namespace opaline::app::viewer
