#pragma once

#include "viewer/session/session.h"

namespace opaline::app::viewer {

/// Lets a session's animation and turntable run for so long, as far as they do.
void playOn(double seconds, Session& session);

}  // namespace opaline::app::viewer
