"""The module says what it has: stubs, texts of help, errors, and a wheel that can be installed."""

import ast
import inspect
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import opaline

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(os.environ.get("BUILD", ROOT / "build" / "release"))
HAS_PIP = subprocess.run([sys.executable, "-m", "pip", "--version"], capture_output=True, check=False).returncode == 0


def public(names):
    return {name for name in names if not name.startswith("_")}


class Module(unittest.TestCase):
    def test_stubs_name_all_there_is(self):
        tree = ast.parse((ROOT / "python" / "opaline" / "__init__.pyi").read_text())
        found = {node.name: node for node in tree.body if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
        self.assertEqual(public(found), set(opaline.__all__))
        for name in opaline.__all__:
            kind = getattr(opaline, name)
            if not inspect.isclass(kind) or issubclass(kind, Exception):
                continue
            members = {node.name for node in found[name].body if isinstance(node, ast.FunctionDef)}
            members |= {node.target.id for node in found[name].body if isinstance(node, ast.AnnAssign)}
            there = {member for base in kind.__mro__ if base.__module__ == "opaline" for member in vars(base)}
            there |= {"facts", "exposure_stops"} if name == "Frame" else set()
            self.assertEqual(public(members), public(there), name)

    def test_stubs_have_the_options_of_render(self):
        tree = ast.parse((ROOT / "python" / "opaline" / "__init__.pyi").read_text())
        renderer = next(node for node in tree.body if isinstance(node, ast.ClassDef) and node.name == "Renderer")
        render = next(node for node in renderer.body if isinstance(node, ast.FunctionDef) and node.name == "render")
        stub = {argument.arg for argument in render.args.kwonlyargs} - {"camera", "environment_behind", "reuse_light"}
        told = {line.split(":")[0].strip() for line in opaline.Renderer.render.__doc__.splitlines() if line.startswith("    ")}
        self.assertEqual(stub, told)

    def test_everything_is_explained(self):
        for name in opaline.__all__:
            thing = getattr(opaline, name)
            self.assertGreater(len(thing.__doc__ or ""), 20, name)
            if inspect.isclass(thing) and not issubclass(thing, Exception):
                for member, value in vars(thing).items():
                    if not member.startswith("_"):
                        self.assertGreater(len(inspect.getdoc(value) or ""), 2, f"{name}.{member}")
        self.assertIn("set_positions", opaline.__doc__)

    def test_errors(self):
        self.assertTrue(issubclass(opaline.Error, RuntimeError))
        self.assertTrue(issubclass(opaline.UsageError, ValueError))
        self.assertTrue(issubclass(opaline.UsageError, opaline.Error))
        with self.assertRaisesRegex(opaline.UsageError, '"no such device"'):
            opaline.Renderer(opaline.teapot(), device="no such device")

    def test_version(self):
        self.assertRegex(opaline.__version__, r"^0\.\d+\.\d+$")

    @unittest.skipUnless(HAS_PIP, "this Python has no pip")
    def test_the_wheel(self):
        with tempfile.TemporaryDirectory() as folder:
            wheel = subprocess.run([sys.executable, ROOT / "python" / "make_wheel.py", BUILD / "python" / "opaline",
                                    opaline.__version__, ROOT / "LICENSE", folder], check=True, capture_output=True,
                                   text=True).stdout.strip()
            target = pathlib.Path(folder, "installed")
            subprocess.run([sys.executable, "-m", "pip", "install", "-q", "--no-index", "--no-deps", "--target", target, wheel],
                           check=True, capture_output=True)
            here = subprocess.run([sys.executable, "-c", "import opaline; print(opaline.__file__)"], cwd=folder, check=True,
                                  env=os.environ | {"PYTHONPATH": str(target)}, capture_output=True, text=True).stdout
            self.assertTrue(here.startswith(str(target)), here)


if __name__ == "__main__":
    unittest.main()
