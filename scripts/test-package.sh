#!/usr/bin/env bash
# Unpacks the package into an empty folder and runs it there: on this system with a cleared
# environment, and in a bare root that holds nothing but the C library and a shell.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

fail() { echo "test-package: $*" >&2; exit 1; }

shopt -s nullglob
archives=(build/opaline-*-linux-x86_64.tar.gz)
[ "${#archives[@]}" -eq 1 ] || fail "expected one archive in build/, found ${#archives[@]}"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
tar -C "$folder" -xzf "${archives[0]}"
package=$folder/$(basename "${archives[0]}" .tar.gz)

# Closed under what the loader looks for: all but the C library is inside.
glibc='^(ld-linux-x86-64|libc|libm|libdl|libpthread|librt|libresolv)\.so'
while read -r file; do
  while read -r needed; do
    [[ $needed =~ $glibc ]] || [ -e "$package/lib/$needed" ] || [ -e "$package/lib/fallback/$needed" ] ||
      fail "$(basename "$file") needs $needed, which is not in the package"
  done < <(readelf -d "$file" | sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p')
done < <(find "$package/libexec" "$package/lib" -type f)
for file in LICENSE README.txt licences; do [ -e "$package/$file" ] || fail "no $file inside"; done

clean() { (cd "$folder" && env -i PATH=/usr/bin:/bin "$@"); }
[[ $(clean "$package/opaline" --version) == "opaline "[0-9]* ]] || fail "--version"
[[ $(clean "$package/opaline" media --json) == *'"marble"'* ]] || fail "media"
taken=$(clean ldd "$package/libexec/opaline" | grep -c "=> $package/libexec/../lib/") || fail "no library comes from the package"
echo "test-package: runs with a cleared environment, $taken libraries from the package"
clean "$package/opaline" render --size 96x96 --quiet -o picture.png
[ "$(head -c 4 "$folder/picture.png" | tail -c 3)" = PNG ] || fail "render wrote no PNG"

# A bare root: what a program may count on is the C library alone.
root=$folder/root
mkdir -p "$root"/{bin,lib64,lib/x86_64-linux-gnu,dev}
copy() { install -D "$(readlink -f "$1")" "$root$2"; }
for tool in sh readlink dirname; do
  copy "$(command -v "$tool")" "/bin/$tool"
  while read -r library _ path _; do
    copy "$path" "/lib/x86_64-linux-gnu/$library"
  done < <(ldd "$(command -v "$tool")" | grep '=> /')
done
copy /lib64/ld-linux-x86-64.so.2 /lib64/ld-linux-x86-64.so.2
for library in libm.so.6 libdl.so.2 libpthread.so.0 librt.so.1; do
  path=$(ldconfig -p | awk -v l="$library" '$1 == l && /x86-64/ {print $NF; exit}')
  [ -z "$path" ] || copy "$path" "/lib/x86_64-linux-gnu/$library"
done
: > "$root/dev/null"
cp -r "$package" "$root/opaline"
if [ "$(id -u)" -eq 0 ]; then
  bare=(chroot "$root")
elif unshare -r true 2>/dev/null; then
  bare=(unshare -r "$(command -v chroot)" "$root")
else
  echo "test-package: no bare root here, as this system allows no user namespaces"
  exit 0
fi
bare=(env -i PATH=/bin "$(command -v "${bare[0]}")" "${bare[@]:1}")
[[ $("${bare[@]}" /opaline/opaline media --json) == *'"marble"'* ]] || fail "does not run in a bare root"
status=0
message=$("${bare[@]}" /opaline/opaline render --quiet -o /a.png 2>&1) || status=$?
[ "$status" -eq 1 ] && [[ $message == *Vulkan* ]] || fail "without a driver, render says: $message ($status)"
echo "test-package: runs in a bare root, and says there that no Vulkan driver is to be found"
