"""What an artist sets for a scene, a view layer or a material."""

import bpy

_items = []  # Blender keeps no reference to the texts of an enumeration


def _media(self, context):
    del self, context
    if not _items:
        _items.append(("SHADER", "By the shader", "Subsurface, or none, as the shader says"))
        try:
            import opaline

            media = opaline.media()
        except ImportError:
            media = {}
        for name, medium in media.items():
            lengths = ", ".join(f"{length:.2g}" for length in mean_free_paths_mm(medium))
            _items.append((name, name, f"Mean free path {lengths} mm for red, green and blue"))
    return _items


def mean_free_paths_mm(medium):
    return 1 / (medium.sigma_s_prime_per_mm + medium.sigma_a_per_mm)


def _tag(self, context):
    """Makes the viewport follow: Blender itself ignores changes of properties that add-ons define."""
    del context
    self.id_data.update_tag()


class OpalineMaterial(bpy.types.PropertyGroup):
    medium_item: bpy.props.EnumProperty(name="Medium", items=_media, update=_tag, description="What the body is made of")

    @property
    def medium(self):
        return self.medium_item or "SHADER"


class OpalineScene(bpy.types.PropertyGroup):
    device: bpy.props.StringProperty(name="Device", description="Number or part of a name of a Vulkan device; empty: the best")
    samples: bpy.props.EnumProperty(
        name="Samples", description="Samples a pixel of a render", default="4",
        items=[(number, number, "") for number in ("1", "2", "4", "8")])
    bounces: bpy.props.IntProperty(name="Bounces", default=2, min=0, max=8, update=_tag,
                                   description="How often light that has left may enter again")


class OpalineViewLayer(bpy.types.PropertyGroup):
    use_pass_exitance: bpy.props.BoolProperty(name="Exitance", description="Light that leaves translucent bodies, by their area")


CLASSES = (OpalineMaterial, OpalineScene, OpalineViewLayer)


def register():
    for kind in CLASSES:
        bpy.utils.register_class(kind)
    bpy.types.Material.opaline = bpy.props.PointerProperty(type=OpalineMaterial)
    bpy.types.Scene.opaline = bpy.props.PointerProperty(type=OpalineScene)
    bpy.types.ViewLayer.opaline = bpy.props.PointerProperty(type=OpalineViewLayer)


def unregister():
    del bpy.types.ViewLayer.opaline, bpy.types.Scene.opaline, bpy.types.Material.opaline
    for kind in reversed(CLASSES):
        bpy.utils.unregister_class(kind)
    _items.clear()
