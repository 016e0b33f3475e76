// Where each invocation of a work group puts its entries in a list: after those of the invocations before it.
#ifndef OPALINE_LIB_GROUP_PLACE
#define OPALINE_LIB_GROUP_PLACE

shared uint countOfSubgroup[64];

// Every invocation of the group calls it; `all` is the sum. Counts may be halves of a word.
uint groupPlaceFor(uint count, out uint all) {
  uint before = subgroupExclusiveAdd(count);
  uint ours = subgroupAdd(count);
  if (subgroupElect()) countOfSubgroup[gl_SubgroupID] = ours;
  barrier();
  all = 0u;
  for (uint g = 0u; g < gl_NumSubgroups; ++g) {
    if (g == gl_SubgroupID) before += all;
    all += countOfSubgroup[g];
  }
  return before;
}

#endif
