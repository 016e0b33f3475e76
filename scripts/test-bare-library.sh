#!/usr/bin/env bash
# test-bare-library.sh FOLDER: in a Debian root that holds nothing but what `install-dependencies.sh --library` installs, builds
# the preset `library`, static and shared, installs it, and builds and runs other projects with it, as tests/package does.
# The root is made in FOLDER and kept there. Needs root and debootstrap.
set -euo pipefail
export LC_ALL=C

[ $# -ge 1 ] || { echo "usage: test-bare-library.sh FOLDER" >&2; exit 2; }
[ "${2:-}" = --mounts ] || exec unshare --mount "$0" "$1" --mounts  # which go with this process
cd "$(dirname "${BASH_SOURCE[0]}")/.."
root=$(realpath -m "$1")

[ -x "$root/usr/bin/apt-get" ] || debootstrap --variant=minbase --include=ca-certificates bookworm "$root"
mount --bind /proc "$root/proc"
mount --bind /dev "$root/dev"
mkdir -p "$root/opaline_tree"
git ls-files -z | tar --null -T - -c | tar -x -C "$root/opaline_tree"
exec chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/ bash -euc '
cd /opaline_tree
scripts/install-dependencies.sh --library
for package in libglfw3-dev libimgui-dev libembree-dev libtbb-dev libcli11-dev libgtest-dev pybind11-dev xvfb ffmpeg; do
  ! dpkg-query -W "$package" 2>/dev/null || { echo "test-bare-library: $package is there" >&2; exit 1; }
done
for shared in OFF ON; do  # the same objects make both
  cmake --preset library -DBUILD_SHARED_LIBS=$shared
  cmake --build --preset library
  (cd tests/package && BUILD=/opaline_tree/build/library python3 -m unittest -v package_test same_pictures_test)
done
'
