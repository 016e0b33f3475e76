"""C++ that does not fit its shader does not compile."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]

SHADER = """#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/texels.glsl"
layout(local_size_x = 64) in;
layout(constant_id = 0) const uint halved = 0u;
layout(std430, set = 0, binding = 3) readonly buffer Lengths { float lengths[]; };
layout(std430, set = 0, binding = 1) buffer Sums { vec4 sums[]; };
TEXELS(2, nodes);
layout(push_constant) uniform Push { %s };
void main() {
  if (halved == 0u) sums[0] = vec4(lengths[count]) + texelOf(nodes, 0) + factor;
}
"""

PUSH = "uint count; float factor;"
BINDINGS = "{.sums = buffer, .nodes = buffer, .lengths = buffer}"

USE = """#include "gpu/buffer.h"
#include "shaders/sum.comp.h"
using opaline::shaders::Sum;
Sum::Bindings bindings(opaline::gpu::Buffer& buffer) { return %s; }
Sum::Push push() { return %s; }
Sum::Constants constants() { return %s; }
"""


class ShaderInterface(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.groups = ROOT / "src/shaders/binding_groups.h"

    def interface(self, push=PUSH, shader=SHADER, variants=("", "storage")):
        """What the tool answers of the shader with these push constants, in these variants."""
        (self.folder / "sum.comp").write_text(shader % push)
        modules = []
        for variant in variants:
            spirv = self.folder / f"sum{variant}.spv"
            defined = [f"-D{variant.upper()}"] if variant else []
            subprocess.run(["glslc", "--target-env=vulkan1.3", "-O0", "-I", ROOT / "src/shaders", *defined, "-o", spirv,
                            self.folder / "sum.comp"], check=True)
            modules.append(f"{variant}=wordsSum{variant}={spirv}")
        return subprocess.run(
            [sys.executable, ROOT / "cmake/shader_interface.py", "--type", "Sum",
             "--shared", f"shaders/shared={ROOT / 'src/shaders/shared'}", "--groups", f"shaders={self.groups}",
             "--header", self.folder / "shaders/sum.comp.h",
             "--layouts", self.folder / "layouts.h", *modules],
            capture_output=True, text=True)

    def compiles(self, bindings=BINDINGS, push="{.count = 1, .factor = 2}", constants="{.halved = 1}"):
        (self.folder / "use.cpp").write_text(USE % (bindings, push, constants))
        return subprocess.run(["c++", "-std=c++20", "-Wall", "-Wconversion", "-Werror", "-fsyntax-only", "-I", ROOT / "src",
                               "-I", ROOT / "include", "-I", self.folder, self.folder / "use.cpp"],
                              capture_output=True).returncode == 0

    def test_what_fits_compiles_and_nothing_else(self):
        self.assertEqual(self.interface().returncode, 0)
        self.assertTrue(self.compiles())
        for bindings in (BINDINGS.replace(".nodes = buffer, ", ""),
                         BINDINGS.replace(".nodes", ".points"),
                         BINDINGS.replace(".nodes = buffer", ".nodes = 1")):
            self.assertFalse(self.compiles(bindings=bindings), bindings)
        for push in ("{.count = 1}", "{.factor = 2}", "{.count = 1, .factor = 2, .more = 3}",
                     "{.count = 1.5F, .factor = 2}"):
            self.assertFalse(self.compiles(push=push), push)
        self.assertFalse(self.compiles(constants="{}"))

    def test_fields_follow_the_shader(self):
        self.interface()
        header = (self.folder / "shaders/sum.comp.h").read_text()
        self.assertIn("gpu::Write sums;\n    gpu::Texels nodes;\n    gpu::Read lengths;", header)
        self.assertIn("sums.at(1), nodes.at(2), lengths.at(3)", header)
        self.interface(PUSH + " uint more;")
        self.assertFalse(self.compiles())

    def test_a_group_stands_for_its_members(self):
        self.groups = self.folder / "shaders/groups.h"
        self.groups.parent.mkdir()
        group = '#pragma once\n#include "gpu/binding.h"\nnamespace opaline::shaders {\n%s}\n'
        small = "struct Ends {\n  gpu::Read lengths;\n};\n"
        large = "struct BothEnds {\n  gpu::Write sums;\n  Ends ends;\n};\n"
        other = "struct Others {\n  gpu::Write sums;\n  gpu::Read widths;\n};\n"
        self.groups.write_text(group % (small + large + other))
        self.assertEqual(self.interface().returncode, 0)
        header = (self.folder / "shaders/sum.comp.h").read_text()
        self.assertIn("    BothEnds bothEnds;\n    gpu::Texels nodes;\n    std::array", header)
        self.assertIn("bothEnds.sums.at(1), nodes.at(2), bothEnds.ends.lengths.at(3)", header)
        self.assertFalse(self.compiles())
        self.assertTrue(self.compiles(bindings="{.bothEnds = {.sums = buffer, .ends = {.lengths = buffer}}, .nodes = buffer}"))

    def test_groups_apart_stand_beside_each_other(self):
        self.groups = self.folder / "shaders/groups.h"
        self.groups.parent.mkdir()
        self.groups.write_text('#pragma once\n#include "gpu/binding.h"\nnamespace opaline::shaders {\n'
                               "struct Ends {\n  gpu::Read lengths;\n};\nstruct Middles {\n  gpu::Texels nodes;\n};\n}\n")
        self.assertEqual(self.interface().returncode, 0)
        header = (self.folder / "shaders/sum.comp.h").read_text()
        self.assertIn("    Middles middles;\n    Ends ends;\n    gpu::Write sums;\n    std::array", header)
        self.assertIn("sums.at(1), middles.nodes.at(2), ends.lengths.at(3)", header)

    def test_a_gap_in_push_constants_does_not_compile(self):
        self.interface("uint count; vec2 place; float factor;")
        self.assertFalse(self.compiles(push="{.count = 1, .place = glm::vec2(0), .factor = 2}"))

    def test_what_cxx_has_no_word_for_is_refused(self):
        answer = self.interface(PUSH + " mat3 turn;")
        self.assertEqual(answer.returncode, 1)
        self.assertEqual(answer.stderr, "shader_interface: push constants are numbers, vectors and structs of "
                                        "shared folders\n")

    def test_more_buffers_than_devices_have_are_refused(self):
        def with_buffers(count):
            declared = "".join(f"layout(std430, set = 0, binding = {i}) buffer B{i} {{ float b{i}[]; }};\n" for i in range(4, 4 + count))
            used = "".join(f"b{i}[0] = 1; " for i in range(4, 4 + count))
            return SHADER.replace("void main() {", declared + "void main() { " + used)

        self.assertEqual(self.interface(shader=with_buffers(14)).returncode, 0)
        self.assertIn("Sum has 17 storage buffers", self.interface(shader=with_buffers(15)).stderr)

    def test_tables_are_texels_or_storage(self):
        self.interface()
        header = (self.folder / "shaders/sum.comp.h").read_text()
        self.assertIn("slots{{{1, gpu::BindingType::StorageBuffer}, {2, gpu::BindingType::TexelBuffer}", header)
        self.assertIn("slotsStorage{{{1, gpu::BindingType::StorageBuffer}, {2, gpu::BindingType::StorageBuffer}", header)
        self.assertIn("Sum reads texels and has no variant that reads storage", self.interface(variants=("",)).stderr)


if __name__ == "__main__":
    unittest.main()
