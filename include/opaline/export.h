#pragma once

/// Marks what the shared library of Opaline exports. All else in it is hidden.
#if defined(__GNUC__)
#define OPALINE_API __attribute__((visibility("default")))
#else
#define OPALINE_API
#endif
