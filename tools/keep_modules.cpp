// Part of programs with sanitizers: shared libraries stay loaded to the end. Otherwise what a
// driver has leaked no longer has its name when leaks are looked for, and tools/lsan.supp cannot
// tell it from ours.
extern "C" [[gnu::visibility("default")]] int dlclose(void*) {
  return 0;
}
