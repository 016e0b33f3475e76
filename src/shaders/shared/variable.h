// The sources of variables that are handed out. Included by C++ and GLSL.
#ifndef OPALINE_SHARED_VARIABLE_H
#define OPALINE_SHARED_VARIABLE_H

#ifdef __cplusplus
#include <cstdint>
namespace opaline::shared {
#define OPALINE_VARIABLE_KIND constexpr std::uint32_t
#else
#define OPALINE_VARIABLE_KIND const uint
#endif

OPALINE_VARIABLE_KIND variableValues = 0u;  // xyz of the values
OPALINE_VARIABLE_KIND variableLast = 1u;    // w of the values
OPALINE_VARIABLE_KIND variablePlace = 2u;
OPALINE_VARIABLE_KIND variableDepth = 3u;
OPALINE_VARIABLE_KIND variableObject = 4u;

#undef OPALINE_VARIABLE_KIND

#ifdef __cplusplus
}  // namespace opaline::shared
#endif
#endif
