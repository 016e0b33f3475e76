// The box around the moved scene, kept as unsigned integers that order like the floats they stand
// for, so that it can be found with atomics in any order. The upper corner is kept inverted: both
// start as all ones and are lowered.
#ifndef OPALINE_LIB_BOUNDS
#define OPALINE_LIB_BOUNDS

uint ordered(float value) {
  uint bits = floatBitsToUint(value);
  return (bits & 0x80000000u) != 0u ? ~bits : bits | 0x80000000u;
}

float unordered(uint key) {
  return uintBitsToFloat((key & 0x80000000u) != 0u ? key & 0x7fffffffu : ~key);
}

#endif
