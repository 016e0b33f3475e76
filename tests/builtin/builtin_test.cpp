#include "builtin/builtin.h"

#include <gtest/gtest.h>
