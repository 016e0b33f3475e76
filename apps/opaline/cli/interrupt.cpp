#include "cli/interrupt.h"

#include <csignal>
#include <system_error>
#include <thread>

#include "cli/child_process.h"
#include "cli/output.h"
#include "opaline/file.h"

namespace opaline::app {

namespace {

void dieBy(int signal) {
  std::signal(signal, SIG_DFL);
  sigset_t only;
  sigemptyset(&only);
  sigaddset(&only, signal);
  pthread_sigmask(SIG_UNBLOCK, &only, nullptr);
  std::raise(signal);
}

void awaitInterrupt(sigset_t signals) {
  int signal = 0;
  while (sigwait(&signals, &signal) != 0) {
  }
  // The child goes first, as it writes into one of the files.
  abandonChildProcesses();
  abandonTemporaryFiles();
  clearStatus();
  dieBy(signal);
}

bool isIgnored(int signal) {
  struct sigaction action {};
  return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

}  // namespace

// A thread that waits for signals may do what a signal handler may not: take locks, so that no file
// and no child is missed while it cleans up.
void leaveOnlyWholeFilesWhenInterrupted() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    // As after nohup: whoever started us wants the signal ignored.
    if (!isIgnored(signal)) sigaddset(&signals, signal);
  }
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  try {
    std::thread(awaitInterrupt, signals).detach();
  } catch (const std::system_error&) {
    pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
  }
}

}  // namespace opaline::app
