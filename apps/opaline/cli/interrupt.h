#pragma once

namespace opaline::app {

/// From now on SIGINT, SIGTERM and SIGHUP end the program by that signal as ever, but only after
/// what was half written is removed and the programs that we started are gone. To be called before
/// any thread starts.
void leaveOnlyWholeFilesWhenInterrupted();

}  // namespace opaline::app
