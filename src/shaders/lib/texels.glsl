// Tables of four floats that a shader reads while nobody writes them. A software device reads them fastest as
// texels, others as storage: where STORAGE or RAY_QUERIES is defined.
#ifndef OPALINE_LIB_TEXELS
#define OPALINE_LIB_TEXELS

#if defined(STORAGE) || defined(RAY_QUERIES)
#define TEXELS(slot, table) \
  layout(std430, set = 0, binding = slot) readonly buffer TexelsOf_##table { vec4 table[]; }
#define texelOf(table, index) table[index]
#else
#define TEXELS(slot, table) layout(set = 0, binding = slot) uniform samplerBuffer table
#define texelOf(table, index) texelFetch(table, index)
#endif

#endif
