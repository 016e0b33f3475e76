#!/usr/bin/env python3
"""make_wheel.py PACKAGE VERSION LICENCE FOLDER: packs the built package as a wheel for this Python and this system."""

import base64
import hashlib
import pathlib
import sys
import sysconfig
import zipfile


def main():
    package, version, licence, folder = pathlib.Path(sys.argv[1]), sys.argv[2], pathlib.Path(sys.argv[3]), pathlib.Path(sys.argv[4])
    tag = "cp%d%d" % sys.version_info[:2]
    tag = f"{tag}-{tag}-{sysconfig.get_platform().replace('-', '_').replace('.', '_')}"
    information = f"opaline-{version}.dist-info"
    files = {f"opaline/{path.name}": path.read_bytes() for path in sorted(package.iterdir()) if path.is_file()}
    files[f"{information}/METADATA"] = (
        f"Metadata-Version: 2.1\nName: opaline\nVersion: {version}\nSummary: Renders moving translucent objects\n"
        "License: Apache-2.0\nRequires-Python: >=3.9\nRequires-Dist: numpy\n").encode()
    files[f"{information}/WHEEL"] = f"Wheel-Version: 1.0\nGenerator: opaline\nRoot-Is-Purelib: false\nTag: {tag}\n".encode()
    files[f"{information}/LICENSE"] = licence.read_bytes()
    record = "".join(f"{name},sha256={base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b'=').decode()},{len(data)}\n"
                     for name, data in files.items()) + f"{information}/RECORD,,\n"
    files[f"{information}/RECORD"] = record.encode()
    for old in folder.glob("opaline-*.whl"):
        old.unlink()
    wheel = folder / f"opaline-{version}-{tag}.whl"
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in files.items():
            entry = zipfile.ZipInfo(name)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = (0o755 if name.endswith(".so") else 0o644) << 16
            archive.writestr(entry, data)
    print(wheel)


if __name__ == "__main__":
    main()
