#!/usr/bin/env python3
"""Makes docs/images/view*.jpg: opens the window on a virtual display and captures its panels, into the current folder
or that of --into. OPALINE names the program, SCENE a file with textures. Needs Xvfb, xdotool and ImageMagick."""

import argparse
import pathlib
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path[:0] = [str(ROOT / "tests" / "viewer"), str(ROOT / "tests" / "cli")]

PANEL = (360, 520)


def pictures_into(folder, textured):
    from driver import WindowTest

    def shoot(window, name, width, height, left=0):
        window.move((5, 5))  # so that no tooltip shows
        window.settle()
        subprocess.run(["import", "-window", "root", "-crop", f"{width}x{height}+{left}+0", "+repage", "-quality", "88",
                        str(folder / name)], env=window.environment, check=True)

    class WindowPictures(WindowTest):
        def test_pictures(self):
            window = self.view("--medium", "gummy-red", "--size", "1280x800")
            left = window.state()["picture"][2]

            def panel(name):
                shoot(window, f"view_{name.lower()}.jpg", *PANEL, left)

            window.only("Medium")
            shoot(window, "view.jpg", 1280, 800)
            panel("Medium")
            window.only("Light")
            window.click("Light/directional 1")
            panel("Light")
            for name in ("Method", "View"):
                window.only(name)
                panel(name)
            window.only("Motion")
            window.click("Motion/add a deformation")
            panel("Motion")
            window.click("Motion/remove")
            window.only("Time")
            x, y = window.middle()
            window.drag((x, y), (x + 60, y), steps=12)
            panel("Time")
            window.only("Truth")
            window.press("Truth/path tracing")
            window.wait_for(lambda: window.state()["truth"] > 0 and "Truth/shown" in window.state()["controls"], "no truth")
            panel("Truth")
            window.press("Truth/cancel")
            window.settle()
            window.close()
            window = self.view(textured, "--size", "1280x800")
            window.only("Material")
            panel("Material")
            window.close()

    return WindowPictures


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--into", type=pathlib.Path, default=pathlib.Path("."))
    parser.add_argument("textured", type=pathlib.Path, metavar="SCENE", help="for the material panel, with textures")
    arguments = parser.parse_args()
    made = pictures_into(arguments.into.resolve(), arguments.textured.resolve())
    result = unittest.TextTestRunner().run(made("test_pictures"))
    sys.exit(not result.wasSuccessful())


if __name__ == "__main__":
    main()
