// Work groups of a dispatch over a list.
#ifndef OPALINE_LIB_GROUPS
#define OPALINE_LIB_GROUPS

const uint groupSize = 64u;

uint groupsFor(uint entries) {
  return (entries + groupSize - 1u) / groupSize;
}

#endif
