"""Opaline in Blender: wax, jade, marble, milk and skin, in the viewport and in renders."""

bl_info = {
    "name": "Opaline",
    "author": "The authors of Opaline",
    "version": (0, 2, 0),
    "blender": (3, 4, 0),
    "category": "Render",
    "location": "Render properties, Render Engine",
    "description": "Renders deformable translucent objects",
}

import os
import shutil
import sys

import bpy

# The Python module for Blender's Python, beside this file.
_LIBRARY = os.path.join(os.path.dirname(__file__), "library")


def _module_problem():
    """Why the Python module cannot be used; empty if it can."""
    if "opaline" not in sys.modules and os.path.isdir(_LIBRARY):
        # Installing another version overwrites the files here, so copies are loaded instead.
        loaded = os.path.join(bpy.app.tempdir, "opaline_library")
        shutil.copytree(_LIBRARY, loaded, dirs_exist_ok=True)
        sys.path.insert(0, loaded)
    try:
        import opaline  # noqa: F401
    except ImportError as error:
        version = "%d.%d" % sys.version_info[:2]
        return f"Opaline's module cannot be loaded by this Blender's Python {version}: {error}"
    return ""


def register():
    from . import engine, panels, settings

    engine.MODULE_PROBLEM = _module_problem()
    settings.register()
    engine.register()
    panels.register()


def unregister():
    from . import engine, panels, settings

    panels.unregister()
    engine.unregister()
    settings.unregister()
