#pragma once

#include "viewer/session/session.h"

namespace opaline::app::viewer {

/// Advances a session's animation and turntable by that time, if they run.
void playOn(double seconds, Session& session);

}  // namespace opaline::app::viewer
