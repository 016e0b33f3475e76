#pragma once

#include <optional>
#include <string>

#include "viewer/files/saver.h"
#include "viewer/session/truth_view.h"

namespace opaline::app::viewer {

/// Sentences on a film or a truth that would be lost if stopped now. None where nothing is under
/// way.
std::optional<std::string> workUnderWay(const Saver& saver, const TruthView& truth);

/// Stops that work.
void stopWork(Saver& saver, TruthView& truth);

}  // namespace opaline::app::viewer
