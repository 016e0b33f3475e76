// What the steps of the solver share.
#ifndef OPALINE_LIB_SOLVER
#define OPALINE_LIB_SOLVER

// Which of SolverState::done says whether a step has anything to do. Steps write the other one: what
// some invocations write while others read it, is not defined.
uint doneBefore(uint step) {
  return (step + 1u) & 1u;
}

#endif
