#!/usr/bin/env python3
"""make_addon.py ADDON PACKAGE LICENCE ZIP: packs the add-on and the built Python module as Blender installs it."""

import pathlib
import sys
import zipfile


def main():
    addon, package, licence, packed = map(pathlib.Path, sys.argv[1:])
    files = {f"{addon.name}/{path.relative_to(addon)}": path for path in sorted(addon.rglob("*.py"))}
    files |= {f"{addon.name}/library/{package.name}/{path.name}": path for path in sorted(package.iterdir()) if path.is_file()}
    files[f"{addon.name}/LICENSE"] = licence
    for old in packed.parent.glob(f"{addon.name}-*.zip"):
        old.unlink()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, path in files.items():
            archive.write(path, name)
    print(packed)


if __name__ == "__main__":
    main()
