// Linked into programs with sanitizers: shared libraries stay loaded to the end. Otherwise the
// leaks of an unloaded driver have no name when they are reported, and tools/lsan.supp cannot tell
// them from ours.
extern "C" [[gnu::visibility("default")]] int dlclose(void*) {
  return 0;
}
