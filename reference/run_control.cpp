#include "reference/run_control.h"

#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <algorithm>

namespace opaline::reference {

void onThreads(int threads, const std::function<void()>& work) {
  if (threads <= 0) return work();
  // TBB complains on standard error about more threads than there are.
  tbb::task_arena(std::min(threads, tbb::info::default_concurrency())).execute(work);
}

}  // namespace opaline::reference
