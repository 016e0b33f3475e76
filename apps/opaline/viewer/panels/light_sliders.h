#pragma once

#include "viewer/session/light_list.h"
#include "viewer/session/session.h"

namespace opaline::app::viewer {

/// Draws the controls of one light. True if they changed it.
bool drawSliders(const LightEntry& entry, Session& session);

}  // namespace opaline::app::viewer
