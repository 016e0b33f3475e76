#pragma once

namespace opaline::app {

/// From now on SIGINT, SIGTERM and SIGHUP still end the program by that signal, but only after
/// half-written files are removed and child processes are killed. To be called before any thread
/// starts.
void leaveOnlyWholeFilesWhenInterrupted();

}  // namespace opaline::app
