#pragma once

/// Messages in C; part of opaline/opaline_c.h.

#include "opaline/c/status.h"

OPALINE_C_BEGIN

/// How much a message matters.
typedef enum OpalineLogLevel {
  OpalineDebug = 0,
  OpalineNote = 1,
  OpalineWarning = 2
} OpalineLogLevel;

/// Receives all messages; the library prints nothing. Called on the thread that called the library.
typedef void (*OpalineLog)(void* context, OpalineLogLevel level, const char* message);

OPALINE_C_END
