// Parts of clusters, of a few surfels each.
#ifndef OPALINE_LIB_PATCH
#define OPALINE_LIB_PATCH
#include "shared/boundary.h"

// They follow each other from range.firstPatch.
uint patchesOf(ClusterRange range) {
  if (range.kind == opaqueBody) return 0u;
  return (range.endSurfel - range.firstSurfel + surfelsOfPatch - 1u) / surfelsOfPatch;
}

#endif
