// When preloaded, imitates a driver that crashes at the end of a program.

#include <csignal>

__attribute__((destructor)) void crash() {
  std::raise(SIGSEGV);
}
