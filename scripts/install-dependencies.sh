#!/usr/bin/env bash
# Installs what is needed to build, test and run Opaline and is not there yet, with the system's own
# package manager. Does nothing, quickly, when nothing is missing. With --library it installs what the
# preset `library` needs and a software device, and nothing else.
set -euo pipefail
export LC_ALL=C

apt_library=(
  g++ cmake ninja-build python3
  libvulkan-dev mesa-vulkan-drivers glslc
  libeigen3-dev libglm-dev libtinygltf-dev libmeshoptimizer-dev libdraco-dev libtinyobjloader-dev
  libtomlplusplus-dev nlohmann-json3-dev
  libopenexr-dev libstb-dev libwebp-dev libfmt-dev
)
apt_packages=(
  "${apt_library[@]}"
  make git pkg-config vulkan-validationlayers
  libglfw3-dev libimgui-dev libfontconfig-dev libcli11-dev libembree-dev libtbb-dev libgtest-dev libgmock-dev ffmpeg
  pybind11-dev python3-dev python3-numpy python3-scipy python3-matplotlib
  xvfb xauth xdotool imagemagick x11-utils
)
# The checks of `make test` are written for version 14; see tools/clang_tools.py.
apt_checkers=(clang-format clang-tidy)

dnf_library=(
  gcc-c++ cmake ninja-build python3
  vulkan-headers vulkan-loader-devel mesa-vulkan-drivers glslc
  eigen3-devel glm-devel tinygltf-devel meshoptimizer-devel draco-devel tinyobjloader-devel tomlplusplus-devel json-devel
  openexr-devel stb-devel libwebp-devel fmt-devel
)
dnf_packages=(
  "${dnf_library[@]}"
  make git pkgconf vulkan-validation-layers
  glfw-devel imgui-devel fontconfig-devel cli11-devel embree3-devel tbb-devel gtest-devel gmock-devel clang-tools-extra ffmpeg-free
  pybind11-devel python3-devel python3-numpy python3-scipy python3-matplotlib
  xorg-x11-server-Xvfb xauth xdotool xprop ImageMagick
)

case ${1:-} in
  --library)
    apt_packages=("${apt_library[@]}") apt_checkers=()
    dnf_packages=("${dnf_library[@]}")
    ;;
  "") ;;
  *)
    echo "install-dependencies: '$1' is unknown; there is --library" >&2
    exit 2
    ;;
esac

as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  elif command -v sudo >/dev/null; then
    sudo "$@"
  else
    echo "install-dependencies: missing packages and neither root nor sudo; as root, run: $*" >&2
    exit 1
  fi
}

apt_missing() {
  # dpkg-query fails where it has never heard of one of them: that is the answer, not an error.
  { dpkg-query -W -f='${db:Status-Abbrev}${Package}\n' "$@" 2>/dev/null || true; } |
    sed -n 's/^ii //p' | sort -u > "$have"
  printf '%s\n' "$@" | sort -u | comm -23 - "$have"
}

install_with_apt() {
  have=$(mktemp)
  trap 'rm -f "$have"' EXIT
  local wanted=("${apt_packages[@]}") checker missing
  for checker in "${apt_checkers[@]}"; do
    command -v "$checker-14" >/dev/null || wanted+=("$checker")
  done
  mapfile -t missing < <(apt_missing "${wanted[@]}")
  [ "${#missing[@]}" -eq 0 ] && return
  echo "Installing ${missing[*]}" >&2
  as_root env DEBIAN_FRONTEND=noninteractive apt-get update -q
  local package chosen=()
  for package in "${missing[@]}"; do
    if [[ " ${apt_checkers[*]} " == *" $package "* ]] && apt-cache show "$package-14" >/dev/null 2>&1; then
      package=$package-14
    fi
    chosen+=("$package")
  done
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "${chosen[@]}"
}

install_with_dnf() {
  local missing
  mapfile -t missing < <(comm -23 <(printf '%s\n' "${dnf_packages[@]}" | sort -u) \
    <({ rpm -q --qf '%{NAME}\n' "${dnf_packages[@]}" 2>/dev/null || true; } | sort -u))
  [ "${#missing[@]}" -eq 0 ] && return
  echo "Installing ${missing[*]}" >&2
  as_root dnf install -y --setopt=install_weak_deps=False "${missing[@]}"
}

on_unknown_system() {
  local tool missing=()
  for tool in c++ cmake ninja git python3 glslc; do
    command -v "$tool" >/dev/null || missing+=("$tool")
  done
  cat >&2 <<END
install-dependencies: this system has neither apt nor dnf. Opaline needs a C++20 compiler, CMake 3.22,
Ninja, git, Python 3, glslc, a Vulkan 1.3 driver with loader and validation layers, and the headers of
Vulkan, GLFW, Dear ImGui, fontconfig, Eigen, glm, tinygltf, meshoptimizer, Draco, tinyobjloader, toml++, nlohmann-json, OpenEXR, stb, libwebp, fmt, CLI11, Embree 3 or 4, TBB, pybind11, GoogleTest; NumPy, SciPy, Matplotlib.
END
  if [ "${#missing[@]}" -gt 0 ]; then
    echo "install-dependencies: not found here: ${missing[*]}" >&2
    exit 1
  fi
}

if command -v apt-get >/dev/null && command -v dpkg-query >/dev/null; then
  install_with_apt
elif command -v dnf >/dev/null && command -v rpm >/dev/null; then
  install_with_dnf
else
  on_unknown_system
fi
