#pragma once

/// What the calls of the C interface return, and its version; part of opaline/opaline_c.h.

#include <stddef.h>
#include <stdint.h>

#include "opaline/export.h"
#include "opaline/version.h"

/// Grows when the layout of a struct or the meaning of a call changes. Structs that only gained
/// members at their end still accept those of programs that were compiled before.
#define OPALINE_C_ABI 6

#ifdef __cplusplus
#define OPALINE_C_BEGIN extern "C" {
#define OPALINE_C_END }
#else
#define OPALINE_C_BEGIN
#define OPALINE_C_END
#endif

OPALINE_C_BEGIN

/// How a call ended.
typedef enum OpalineStatus {
  OpalineOk = 0,
  OpalineFailed = 1,    ///< bad input, a file that cannot be read or written, a failed device
  OpalineBadUse = 2,    ///< an unknown name, a value out of range, a null pointer, a wrong size
  OpalineNoMemory = 3,  ///< the host has too little memory
  OpalineDefect = 4     ///< an error in the library itself
} OpalineStatus;

/// Why this thread's last failed call failed: one sentence for the user, empty before the first
/// failure. Lives until the thread's next failure.
OPALINE_API const char* opalineLastError(void);

/// The version of the library in use, which may be newer than these headers. `abi` is its
/// OPALINE_C_ABI. Any pointer may be NULL.
OPALINE_API void opalineVersion(int32_t* major, int32_t* minor, int32_t* patch, int32_t* abi);

OPALINE_C_END
