#pragma once

#include <new>
#include <string_view>
#include <utility>

#include "opaline/error.h"
#include "opaline/opaline_c.h"

namespace opaline::c {

/// Keeps the message for opalineLastError() and returns the status.
OpalineStatus failed(OpalineStatus status, std::string_view message) noexcept;

/// Does the work of a call and turns exceptions into its status.
template <typename Work>
OpalineStatus guarded(Work&& work) noexcept {
  try {
    std::forward<Work>(work)();
    return OpalineOk;
  } catch (const UsageError& error) {
    return failed(OpalineBadUse, error.what());
  } catch (const Error& error) {
    return failed(OpalineFailed, error.what());
  } catch (const std::bad_alloc&) {
    return failed(OpalineNoMemory, "There is too little memory.");
  } catch (const std::exception& error) {
    return failed(OpalineDefect, error.what());
  } catch (...) {
    return failed(OpalineDefect, "Something unknown was thrown.");
  }
}

}  // namespace opaline::c
