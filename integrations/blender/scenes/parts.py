"""Parts of the scenes in this folder. Lengths are in metres, like Blender's units."""

import bpy
from mathutils import Vector


def empty_scene(frames=1):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.frame_end = frames
    scene.view_settings.view_transform = "Standard"
    scene.world = bpy.data.worlds.new("World")
    scene.world.use_nodes = True
    set_world((0, 0, 0))
    return scene


def set_world(color):
    bpy.context.scene.world.node_tree.nodes["Background"].inputs["Color"].default_value = (*color, 1)


def add(name, data):
    thing = bpy.data.objects.new(name, data)
    bpy.context.collection.objects.link(thing)
    return thing


def aim(thing, target):
    thing.rotation_euler = (Vector(target) - thing.location).to_track_quat("-Z", "Y").to_euler()


def camera(place, target, lens):
    view = add("Camera", bpy.data.cameras.new("Camera"))
    view.location = place
    view.data.lens = lens
    aim(view, target)
    bpy.context.scene.camera = view
    return view


def area_light(name, place, target, size, power, color=(1, 1, 1)):
    lamp = bpy.data.lights.new(name, "AREA")
    lamp.shape = "RECTANGLE"
    lamp.size, lamp.size_y = size
    lamp.energy = power
    lamp.color = color
    light = add(name, lamp)
    light.location = place
    aim(light, target)
    return light


def set_input(node, value, *names):
    """The node's input with the first of these names that exists."""
    for name in names:
        if name in node.inputs:
            node.inputs[name].default_value = value
            return


def material(name, color, radius=None, roughness=0.5, specular=0.5):
    """A Principled BSDF. With a radius for red, green and blue, it has subsurface scattering."""
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    shader = made.node_tree.nodes["Principled BSDF"]
    set_input(shader, (*color, 1), "Base Color")
    set_input(shader, roughness, "Roughness")
    set_input(shader, specular, "Specular", "Specular IOR Level")
    if radius is not None:
        shader.subsurface_method = "RANDOM_WALK_SKIN" if bpy.app.version >= (4, 0, 0) else "RANDOM_WALK"
        set_input(shader, 1, "Subsurface Weight", "Subsurface")
        set_input(shader, (*color, 1), "Subsurface Color")
        set_input(shader, radius, "Subsurface Radius")
        set_input(shader, 1, "Subsurface Scale")
    return made


def plane(name, place, normal, size, made):
    half = size / 2
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata([(-half, -half, 0), (half, -half, 0), (half, half, 0), (-half, half, 0)], [], [(0, 1, 2, 3)])
    thing = add(name, mesh)
    thing.location = place
    thing.rotation_euler = Vector(normal).to_track_quat("Z", "Y").to_euler()
    thing.data.materials.append(made)
    return thing


def smooth(thing, levels=1):
    if thing.type == "MESH":
        thing.data.polygons.foreach_set("use_smooth", [True] * len(thing.data.polygons))
    if levels:
        thing.modifiers.new("Smoother", "SUBSURF")
        thing.modifiers["Smoother"].levels = thing.modifiers["Smoother"].render_levels = levels


def joined(pieces, name):
    """Joins several overlapping objects."""
    for piece in pieces:
        piece.select_set(True)
    bpy.context.view_layer.objects.active = pieces[0]
    bpy.ops.object.join()
    whole = bpy.context.object
    whole.name = name
    bpy.ops.object.transform_apply(location=True, rotation=True, scale=True)
    return whole


def cast(thing, voxel, iterations):
    """Makes overlapping parts one smooth surface."""
    remesh = thing.modifiers.new("Remesh", "REMESH")
    remesh.mode, remesh.voxel_size, remesh.use_smooth_shade = "VOXEL", voxel, True
    thing.modifiers.new("Smooth", "SMOOTH").iterations = iterations
