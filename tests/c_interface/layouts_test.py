"""The structs and enumerations of the C interface keep the layout that layouts.txt records for OPALINE_C_ABI. A change
requires a larger OPALINE_C_ABI, and `python3 layouts_test.py --record` records the new layout."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
HEADERS = sorted((ROOT / "include" / "opaline" / "c").glob("*.h"))
RECORD = HERE / "layouts.txt"
INCLUDE = os.environ.get("INCLUDE", f"{ROOT}/include:{ROOT}/build/release/include").split(":")


def uncommented():
    return re.sub(r"//[^\n]*", "", re.sub(r"/\*.*?\*/", "", "".join(path.read_text() for path in HEADERS), flags=re.DOTALL))


def layouts():
    """The lines of the record for the current compiler and headers."""
    text = uncommented()
    prints = ['std::printf("abi %d\\n", OPALINE_C_ABI);']
    for name, members in re.findall(r"typedef struct (\w+) \{(.*?)\} \w+;", text, re.DOTALL):
        prints.append(f'std::printf("{name} %zu\\n", sizeof({name}));')
        for member in re.findall(r"(\w+)\)?(?:\[\d+\]|\(void\* context\))?;", members):
            prints.append(f'std::printf("{name}.{member} %zu %zu\\n", offsetof({name}, {member}), sizeof({name}::{member}));')
    for name, values in re.findall(r"typedef enum (\w+) \{(.*?)\} \w+;", text, re.DOTALL):
        prints += [f'std::printf("{name}.{value} %d\\n", static_cast<int>({value}));' for value in re.findall(r"(\w+) =", values)]
    program = ("#include <vulkan/vulkan.h>\n#include <opaline/opaline_c.h>\n#include <cstddef>\n#include <cstdio>\nint main() {\n" + "\n".join(prints)
               + "\n}\n")
    with tempfile.TemporaryDirectory() as folder:
        source = pathlib.Path(folder, "layouts.cpp")
        source.write_text(program)
        subprocess.run([os.environ.get("CXX", "c++"), *(f"-I{path}" for path in INCLUDE), source, "-o", source.with_suffix("")],
                       check=True)
        return subprocess.run([source.with_suffix("")], check=True, capture_output=True, text=True).stdout


class Layouts(unittest.TestCase):
    def test_are_those_of_this_version(self):
        recorded, today = RECORD.read_text().splitlines(), layouts().splitlines()
        self.assertEqual(recorded[0], today[0], "OPALINE_C_ABI is another: record its layouts with --record")
        self.assertEqual(recorded, today, "a layout changed: OPALINE_C_ABI has to grow")

    def test_every_struct_begins_with_its_size(self):
        structs = re.findall(r"typedef struct (\w+) \{\s*(.*?;)", uncommented(), re.DOTALL)
        self.assertGreater(len(structs), 8)
        self.assertEqual({first for _, first in structs}, {"size_t size;"})

    def test_is_c(self):
        for standard, before in (("c11", b""), ("c17", b""), ("c11", b"#include <vulkan/vulkan.h>\n")):
            subprocess.run([os.environ.get("CC", "cc"), f"-std={standard}", "-pedantic", "-Wall", "-Wextra", "-Werror",
                            *(f"-I{path}" for path in INCLUDE), "-fsyntax-only", "-x", "c", "-"], input=before + b"#include <opaline/opaline_c.h>\n",
                           check=True)


if __name__ == "__main__":
    if "--record" in sys.argv:
        RECORD.write_text(layouts())
    else:
        unittest.main()
