#include "reference/run_control.h"

#include <tbb/task_arena.h>

namespace opaline::reference {

void onThreads(int threads, const std::function<void()>& work) {
  if (threads <= 0) return work();
  tbb::task_arena(threads).execute(work);
}

}  // namespace opaline::reference
