// Powers added up by atomics in whole numbers, whose sum does not depend on the order.
#ifndef OPALINE_LIB_WHOLE_SUMS
#define OPALINE_LIB_WHOLE_SUMS

// What the largest of that many powers becomes, so that all together fit.
float wholeOfMost(uint powers) {
  return 4.0e9 / float(powers);
}

#endif
