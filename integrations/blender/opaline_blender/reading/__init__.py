"""Blender's data as plain descriptions of what is rendered."""
