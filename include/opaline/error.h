#pragma once

#include <stdexcept>
#include <string>

#include "opaline/export.h"

namespace opaline {

/// Bad input or a failed device. The message is one sentence for the user that names the file or
/// option, the reason and, where possible, the cure.
class OPALINE_API Error : public std::runtime_error {
 public:
  explicit Error(const std::string& message) : std::runtime_error(message) {}
};

/// The caller asked for something that makes no sense: an unknown name, a value out of range, a
/// combination that does not exist. The opaline program then ends with status 2, and with 1 for any
/// other Error.
class OPALINE_API UsageError : public Error {
 public:
  explicit UsageError(const std::string& message) : Error(message) {}
};

}  // namespace opaline
