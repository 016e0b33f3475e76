// Where each invocation of a work group puts what it has into a list: after what those before it
// have.
#ifndef OPALINE_LIB_GROUP_PLACE
#define OPALINE_LIB_GROUP_PLACE

shared uint countOfSubgroup[64];

// Every invocation of the group calls it; `all` is the sum. Sums may be of halves of a word.
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
