"""Blender's data as plain descriptions of what to render."""
