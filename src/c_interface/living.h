#pragma once

#include <type_traits>

#include "opaline/opaline_c.h"

namespace opaline::c {

/// The name that messages use for a kind of handle; null for types that are not handles.
template <typename T>
inline constexpr const char* kindOf = nullptr;
template <>
inline constexpr const char* kindOf<OpalineImage> = "image";
template <>
inline constexpr const char* kindOf<OpalinePixels> = "pixels";
template <>
inline constexpr const char* kindOf<OpalineRenderer> = "renderer";
template <>
inline constexpr const char* kindOf<OpalineScene> = "scene";
template <>
inline constexpr const char* kindOf<OpalineSequence> = "sequence";
template <>
inline constexpr const char* kindOf<OpalineSoftBody> = "soft body";
template <>
inline constexpr const char* kindOf<OpalineView> = "view";

void addLiving(const void* handle, const char* kind);
void removeLiving(const void* handle) noexcept;
/// Whether a handle was made as one of that kind and has not been destroyed. May be called from any
/// thread with any pointer; what it points to is not read.
bool isLiving(const void* handle, const char* kind) noexcept;

/// The base of all that handles point to. It registers them, so that a call with any other pointer
/// can be refused.
template <typename T>
struct Handle {
  Handle() { addLiving(this, kindOf<T>); }
  ~Handle() { removeLiving(this); }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
};

template <typename T>
bool isLiving(T* handle) noexcept {
  using Made = std::remove_const_t<T>;
  return isLiving(static_cast<const Handle<Made>*>(handle), kindOf<Made>);
}

/// Does nothing for null or for a handle that has been destroyed.
template <typename T>
void destroy(T* handle) noexcept {
  if (isLiving(handle)) delete handle;
}

}  // namespace opaline::c
