#!/usr/bin/env bash
# Packs the program with the libraries it needs: build/opaline-<version>-linux-x86_64.tar.gz.
# Usage: package.sh BUILD_FOLDER
#
# lib/ holds libraries that the program always takes from the package. lib/fallback/ holds those that
# the system's Vulkan driver uses too: an older copy of ours would keep a newer driver from loading,
# so they serve only where the system has none that will do.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=$1

# The C library, which every Linux has and which must be the system's own.
glibc='^(linux-vdso|ld-linux-x86-64|libc|libm|libdl|libpthread|librt|libresolv)\.so'
fallback='^(libstdc\+\+|libgcc_s|libz)\.so'
mapfile -t compiled_in < <(grep '^[a-z]' cmake/compiled_in.txt)

if ! command -v dpkg-query >/dev/null; then
  echo "package.sh: licences are collected from Debian's packages; run this on Debian or Ubuntu" >&2
  exit 1
fi

# The package that a library comes from, whether its path is recorded below /usr or not.
owner_of() { { dpkg-query -S "$1" || dpkg-query -S "${1#/usr}"; } 2>/dev/null | head -n 1 | cut -d: -f1; }
licence_of() { cp "/usr/share/doc/$1/copyright" "$stage/licences/$1.txt"; }

version=$("$build/bin/opaline" --version | cut -d' ' -f2)
name=opaline-$version-linux-x86_64
stage=build/package/$name
rm -rf "$stage"
mkdir -p "$stage/lib/fallback" "$stage/licences"
cmake --install "$build" --prefix "$stage" --strip --component program >/dev/null
mv "$stage/bin" "$stage/libexec"
cp scripts/launcher.sh "$stage/opaline"
chmod 755 "$stage/opaline"
cp LICENSE CHANGELOG.md "$stage"

while read -r library _ path _; do
  [[ $library =~ $glibc ]] && continue
  folder=$stage/lib
  [[ $library =~ $fallback ]] && folder=$stage/lib/fallback
  install -m 644 -s "$(readlink -f "$path")" "$folder/$library"
  licence_of "$(owner_of "$(readlink -f "$path")")"
done < <(ldd "$build/bin/opaline" | grep '=> /')
for package in "${compiled_in[@]}"; do licence_of "$package"; done

newest_glibc=$(find "$stage" -type f \( -name '*.so*' -o -path '*/libexec/*' \) -exec objdump -T {} + |
  grep -o 'GLIBC_[0-9.]*' | sort -uV | tail -n 1 | cut -d_ -f2)
cat > "$stage/README.txt" <<END
Opaline $version: renders translucent objects in real time.

Needs an x86-64 Linux with glibc $newest_glibc or newer and a Vulkan 1.3 driver (Mesa's software
driver will do). Nothing is installed: run ./opaline --help, then

    ./opaline render -o bear.png
    ./opaline render YOUR_MODEL.glb --medium wholemilk --diagonal-mm 50 -o picture.png

LICENSE is Opaline's; licences/ holds those of the libraries in this package.
END

tar --sort=name --owner=0 --group=0 --numeric-owner --mtime="@$(git log -1 --format=%ct)" \
  -C build/package -czf "build/$name.tar.gz" "$name"
echo "build/$name.tar.gz"
