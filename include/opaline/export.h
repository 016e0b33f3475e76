#pragma once

/// Marks what a shared library of Opaline gives to programs. All else in it is hidden.
#if defined(__GNUC__)
#define OPALINE_API __attribute__((visibility("default")))
#else
#define OPALINE_API
#endif
