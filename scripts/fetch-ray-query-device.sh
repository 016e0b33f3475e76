#!/usr/bin/env bash
# fetch-ray-query-device.sh FOLDER: where the system's Mesa is too old for ray queries and the system's
# package archive has a newer one among its backports, unpacks that into FOLDER for tests, beside the
# system's own, which stays as it is. FOLDER/device.json is then its Vulkan driver. Says in one line
# why not where it cannot; tests that need it are left out then.
set -euo pipefail
export LC_ALL=C

folder=$(realpath -m "${1:?usage: fetch-ray-query-device.sh FOLDER}")
[ -e "$folder/device.json" ] && exit 0

give_up() {
  echo "fetch-ray-query-device: $1; tests of ray queries on it are left out" >&2
  exit 0
}

command -v apt-get >/dev/null && command -v dpkg-deb >/dev/null || give_up "not a system with apt"
codename=$(. /etc/os-release && echo "${VERSION_CODENAME:-}")
[ -n "$codename" ] || give_up "the system's release has no code name"
archive=$(apt-get indextargets --format '$(CODENAME) $(REPO_URI)' 'Created-By: Packages' |
  awk -v codename="$codename" '$1 == codename && !found { print $2; found = 1 }') || archive=
[ -n "$archive" ] || give_up "the package archive of $codename is not among apt's sources"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$work/lists/partial" "$work/cache/archives/partial" "$work/packages" "$work/root"
echo "deb $archive $codename-backports main" > "$work/sources.list"
apt() {
  apt-get -qq -o Dir::Etc::SourceList="$work/sources.list" -o Dir::Etc::SourceParts=- \
    -o Dir::State::Lists="$work/lists" -o Dir::Cache="$work/cache" -o APT::Sandbox::User=root \
    -o Acquire::Retries=1 -o Acquire::http::Timeout=20 -o Acquire::https::Timeout=20 "$@"
}
apt update 2>/dev/null || give_up "the backports of $codename cannot be read"
(cd "$work/packages" && apt download mesa-vulkan-drivers libdrm2 libdrm-amdgpu1 2>/dev/null) ||
  give_up "the backports of $codename have no newer Mesa"
for package in "$work"/packages/*.deb; do
  dpkg-deb -x "$package" "$work/root" || give_up "$package cannot be unpacked"
done
driver=$(find "$work/root" -name libvulkan_lvp.so | head -n 1)
[ -n "$driver" ] || give_up "the newer Mesa has no software device"
if LD_LIBRARY_PATH=$(dirname "$driver") ldd "$driver" 2>&1 | grep -q 'not found'; then
  give_up "the newer Mesa wants libraries that are not there"
fi

rm -rf "$folder"
mkdir -p "$folder"
cp -P "$(dirname "$driver")"/{libvulkan_lvp,libdrm}*.so* "$folder"
cat > "$folder/device.json" <<END
{
  "ICD": { "api_version": "1.3.0", "library_path": "$folder/libvulkan_lvp.so" },
  "file_format_version": "1.0.0"
}
END
