// Invocations of CommandList::dispatchTiles: tiles of 8×8 pixels, within which they follow Morton's
// order, so that a subgroup of any size is a compact piece of the picture.
#ifndef OPALINE_LIB_TILE
#define OPALINE_LIB_TILE

layout(local_size_x = 64) in;

ivec2 pixelOfInvocation() {
  uint i = gl_LocalInvocationIndex;
  uvec2 inTile = uvec2(bitfieldExtract(i, 0, 1) | bitfieldExtract(i, 2, 1) << 1 | bitfieldExtract(i, 4, 1) << 2,
                       bitfieldExtract(i, 1, 1) | bitfieldExtract(i, 3, 1) << 1 | bitfieldExtract(i, 5, 1) << 2);
  return ivec2(gl_WorkGroupID.xy * 8u + inTile);
}

#endif
