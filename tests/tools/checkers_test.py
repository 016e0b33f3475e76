"""The checkers find what they are there to find, and only that."""

import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools"))

import check_documented
import check_layers
import check_links
import check_names


def includes(path, *headers):
    return check_layers.check(path, "".join(f"#include {header}\n" for header in headers))


class Documented(unittest.TestCase):
    def names(self, text):
        return [finding.split(": ")[1].split()[0] for finding in check_documented.undocumented("a.h", text)]

    def test_types_and_functions_without_a_comment_are_found(self):
        self.assertEqual(self.names("""#pragma once
namespace opaline {

struct Bare {
  int member = 0;
};

/// What it is.
class OPALINE_API Told {
 public:
  Told();
  Told(const Told&) = delete;
  ~Told();

  /// Does this.
  void does(int x) const;
  void doesToo();

  void alone() const { return works({1, 2}); }

 private:
  void hidden();
};

OPALINE_API void loose(const Told& told,
                       int more);
int behind();  ///< like this

enum class Kind { One, Two };

/// Told.
struct Outer {
  struct Inner {
    int member = 0;
  };
};

class Elsewhere;
}
"""), ["Bare", "alone", "loose", "Kind", "Inner"])

    def test_c_is_read_too(self):
        self.assertEqual(self.names("""
/// Told.
typedef struct A {
  size_t size;
  void (*call)(void* context);
} A;

OPALINE_API Status opalineMake(A* a);
"""), ["opalineMake"])


class Layers(unittest.TestCase):
    def test_what_is_allowed_passes(self):
        for path, header in [
            ("include/opaline/scene.h", '"opaline/types.h"'),
            ("include/opaline/vulkan.h", "<vulkan/vulkan.h>"),
            ("src/bssrdf/profile.cpp", '"opaline/medium.h"'),
            ("src/bssrdf/profile.cpp", "<cmath>"),
            ("src/gpu/device.cpp", "<vulkan/vulkan.h>"),
            ("src/passes/scatter/pattern.cpp", '"passes/scatter/pattern.h"'),
            ("src/passes/scatter/pattern.cpp", '"passes/products.h"'),
            ("src/renderer/renderer.cpp", '"passes/scatter/pattern.h"'),
            ("src/renderer/frame/frame.h", '"paper/technique.h"'),
            ("apps/opaline/cli/main.cpp", "<CLI/CLI.hpp>"),
            ("apps/opaline/film/render.cpp", '"cli/output.h"'),
            ("tests/core/file_test.cpp", '"core/file.h"'),
        ]:
            self.assertEqual(includes(path, header), [], (path, header))

    def test_every_forbidden_arrow_is_found(self):
        for path, header in [
            ("include/opaline/scene.h", "<vulkan/vulkan.h>"),
            ("include/opaline/scene.h", "<glm/glm.hpp>"),
            ("include/opaline/scene.h", '"core/file.h"'),
            ("src/bssrdf/profile.cpp", '"core/file.h"'),
            ("src/bssrdf/profile.cpp", '"opaline/scene.h"'),
            ("src/bssrdf/profile.cpp", "<fmt/format.h>"),
            ("src/core/file.cpp", '"opaline/scene.h"'),
            ("src/gpu/device.cpp", '"opaline/scene.h"'),
            ("src/gpu/device.cpp", '"bssrdf/media.h"'),
            ("src/gpu/device.cpp", '"passes/products.h"'),
            ("src/scene/gltf/load.cpp", '"paper/atlas/atlas.h"'),
            ("src/paper/atlas/pack.cpp", '"paper/pattern_pass.h"'),
            ("src/renderer/frame/frame.h", '"paper/pattern_pass.h"'),
            ("src/paper/pattern_pass.h", '"renderer/frame/frame.h"'),
            ("src/passes/shade/shade_pass.cpp", '"paper/pattern_pass.h"'),
            ("src/scene/gltf/load.cpp", "<vulkan/vulkan.h>"),
            ("src/passes/scatter/pattern.cpp", '"passes/gather/dsm.h"'),
            ("src/passes/scatter/pattern.cpp", '"renderer/frame.h"'),
            ("src/core/file.cpp", "<CLI/CLI.hpp>"),
            ("src/renderer/renderer.cpp", "<GLFW/glfw3.h>"),
            ("src/renderer/renderer.cpp", "<imgui.h>"),
            ("src/renderer/renderer.cpp", "<Python.h>"),
            ("src/renderer/renderer.cpp", "<embree3/rtcore.h>"),
            ("apps/opaline/cli/main.cpp", '"film/film.h"'),
            ("apps/opaline/film/film.cpp", '"viewer/viewer.h"'),
            ("apps/opaline/film/film.cpp", '"core/stb_memory.h"'),
            ("apps/opaline/film/framing.cpp", '"scene/pose.h"'),
            ("apps/opaline/cli/media.cpp", '"bssrdf/profile.h"'),
            ("apps/opaline/viewer/viewer.cpp", '"renderer/frame/frame.h"'),
            ("src/core/file.cpp", '"tests/helpers.h"'),
            ("reference/path.cpp", '"gpu/device.h"'),
            ("src/renderer/renderer.cpp", '"reference/path.h"'),
            ("src/core/file.cpp", "<gtest/gtest.h>"),
        ]:
            self.assertEqual(len(includes(path, header)), 1, (path, header))

    def test_the_finding_names_file_and_line(self):
        finding, = includes("src/core/file.cpp", "<vector>", "<CLI/CLI.hpp>")
        self.assertTrue(finding.startswith("src/core/file.cpp:2: includes CLI/CLI.hpp"), finding)


class Names(unittest.TestCase):
    def test_file_names(self):
        self.assertEqual(check_names.check_name("src/core/image_file.h"), [])
        self.assertEqual(check_names.check_name("src/paper/shaders/dsm.frag.glsl"), [])
        self.assertEqual(check_names.check_name("scripts/install-dependencies.sh"), [])
        self.assertEqual(len(check_names.check_name("src/core/ImageFile.h")), 1)
        self.assertEqual(len(check_names.check_name("src/Core/image-file.cpp")), 2)

    def test_machine_paths_and_promises(self):
        for line in ["/ho" "me/ann/x", '"/wo' 'rk/data"', "/tm" "p/out.png", "// TO" "DO later", "FIX" "ME"]:
            self.assertEqual(len(check_names.check_text("a.cpp", line)), 1, line)
        for line in ["a/work/b", "frame_work/x", "/dev/full", "homework", "https://x.org/home/a"]:
            self.assertEqual(check_names.check_text("a.cpp", line), [], line)

    def test_the_library_names_no_option_of_the_command_line(self):
        line = 'throw UsageError("--morph-to is for one model");'
        self.assertEqual(len(check_names.check_text("src/scene/load.cpp", line)), 1)
        self.assertEqual(check_names.check_text("apps/opaline/cli/scene_options.cpp", line), [])
        for line in ['"LoadOptions::morphTo is for one model"', '"a" + std::to_string(--count) + "b"', "// --morph-to"]:
            self.assertEqual(check_names.check_text("src/scene/load.cpp", line), [], line)


class Links(unittest.TestCase):
    def test_a_link_must_lead_somewhere(self):
        sizes = {"README.md": 1, "docs/a.md": 1, "docs/bear.png": 1}
        good = {"README.md": "[a](docs/a.md#top) ![b](docs/bear.png) [c](https://x.org) [d](docs) [e](#here)\n## Here",
                "docs/a.md": '# Top\n<img src="bear.png">\n```\n[x](nowhere.md)\n```\n'}
        self.assertEqual(check_links.check(good, sizes), [])
        bad = {**good, "docs/a.md": "# Top\n[a](b.md) ![](pictures/x.png)"}
        self.assertEqual(len(check_links.check(bad, sizes)), 2)

    def test_an_anchor_must_be_a_heading(self):
        text = ("# How *exact* the `sum` is\n## Path tracing: `--path`\n### Längen [in mm](x.md)\n## Limits\n## Limits ##\n"
                "```\n# a comment\n```\n#no heading\n<a id=\"by-hand\"></a>\n")
        # What github.com makes of these headings.
        self.assertEqual(check_links.anchors(text), {"how-exact-the-sum-is", "path-tracing---path", "längen-in-mm", "limits",
                                                     "limits-1", "by-hand"})
        documents = {"README.md": "[a](docs/a.md#limits) [b](#b)\n# B", "docs/a.md": text.replace("(x.md)", "(#limits)")}
        sizes = {"README.md": 1, "docs/a.md": 1, "a.h": 1}
        self.assertEqual(check_links.check(documents, sizes), [])
        for broken in ("[a](docs/a.md#how)", "[a](#c)\n# B", "[a](docs/a.md#Limits)"):
            finding, = check_links.check({**documents, "README.md": broken}, sizes)
            self.assertIn("no such heading", finding)
        self.assertEqual(check_links.check({"README.md": "[a](a.h#L3)"}, sizes), [])

    def test_pictures_are_small_and_used(self):
        documents = {"README.md": "![](docs/bear.png)"}
        self.assertEqual(check_links.check(documents, {"README.md": 1, "docs/bear.png": 300 * 1024}), [])
        self.assertEqual(len(check_links.check(documents, {"README.md": 1, "docs/bear.png": 300 * 1024 + 1})), 1)
        self.assertEqual(
            len(check_links.check(documents, {"README.md": 1, "docs/bear.png": 1, "docs/old.jpg": 1})), 1)


if __name__ == "__main__":
    unittest.main()
