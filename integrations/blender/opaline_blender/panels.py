"""Opaline's panels, and those of Blender that it uses."""

import bpy

from . import settings, units

# Eevee's panels whose settings have a meaning here.
OF_EEVEE = {"EEVEE_MATERIAL_PT_context_material", "EEVEE_MATERIAL_PT_surface", "EEVEE_WORLD_PT_surface", "DATA_PT_EEVEE_light"}
NOT_SHARED = {"RENDER_PT_freestyle", "RENDER_PT_simplify", "VIEWLAYER_PT_filter"}


class _Panel:
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    COMPAT_ENGINES = {"OPALINE"}

    @classmethod
    def poll(cls, context):
        return context.engine in cls.COMPAT_ENGINES


class OPALINE_RENDER_PT_settings(_Panel, bpy.types.Panel):
    bl_label = "Opaline"
    bl_context = "render"

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        chosen = context.scene.opaline
        layout.prop(chosen, "samples")
        layout.prop(chosen, "bounces")
        layout.prop(chosen, "device")


class OPALINE_RENDER_PT_film(_Panel, bpy.types.Panel):
    bl_label = "Film"
    bl_context = "render"

    def draw(self, context):
        self.layout.use_property_split = True
        self.layout.prop(context.scene.render, "film_transparent", text="Transparent")


class OPALINE_VIEWLAYER_PT_passes(_Panel, bpy.types.Panel):
    bl_label = "Passes"
    bl_context = "view_layer"

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        layout.prop(context.view_layer, "use_pass_z", text="Depth")
        layout.prop(context.view_layer, "use_pass_normal", text="Normal")
        layout.prop(context.view_layer.opaline, "use_pass_exitance")


class OPALINE_MATERIAL_PT_medium(_Panel, bpy.types.Panel):
    bl_label = "Medium"
    bl_context = "material"

    @classmethod
    def poll(cls, context):
        return super().poll(context) and context.material is not None

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        layout.prop(context.material.opaline, "medium_item")
        name = context.material.opaline.medium
        if name != "SHADER":
            import opaline

            lengths = settings.mean_free_paths_mm(opaline.media()[name])
            layout.label(text="Mean free path " + ", ".join(f"{length:.2g}" for length in lengths) + " mm")
        if context.object is not None:
            size = [length * units.mm_per_unit(context.scene) for length in context.object.dimensions]
            layout.label(text="The object measures " + " × ".join(f"{length:.3g}" for length in size) + " mm")


CLASSES = (OPALINE_RENDER_PT_settings, OPALINE_RENDER_PT_film, OPALINE_VIEWLAYER_PT_passes, OPALINE_MATERIAL_PT_medium)


def _shared_panels():
    for panel in bpy.types.Panel.__subclasses__():
        engines = getattr(panel, "COMPAT_ENGINES", None)
        if not isinstance(engines, set) or panel.__name__ in NOT_SHARED or panel in CLASSES:
            continue
        if "BLENDER_RENDER" in engines or panel.__name__ in OF_EEVEE:
            yield panel


def register():
    for kind in CLASSES:
        bpy.utils.register_class(kind)
    for panel in _shared_panels():
        panel.COMPAT_ENGINES.add("OPALINE")


def unregister():
    for panel in bpy.types.Panel.__subclasses__():
        engines = getattr(panel, "COMPAT_ENGINES", None)
        if isinstance(engines, set) and panel not in CLASSES:
            engines.discard("OPALINE")
    for kind in reversed(CLASSES):
        bpy.utils.unregister_class(kind)
