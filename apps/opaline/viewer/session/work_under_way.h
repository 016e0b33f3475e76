#pragma once

#include <optional>
#include <string>

#include "viewer/files/saver.h"
#include "viewer/session/truth_view.h"

namespace opaline::app::viewer {

/// What would be lost if it were stopped now, a film or a truth, as sentences; nothing where
/// nothing is under way.
std::optional<std::string> workUnderWay(const Saver& saver, const TruthView& truth);

/// Stops it.
void stopWork(Saver& saver, TruthView& truth);

}  // namespace opaline::app::viewer
