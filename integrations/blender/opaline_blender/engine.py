"""The render engine OPALINE."""

import bpy

MODULE_PROBLEM = ""  # why the Python module cannot be used; empty if it can


class OpalineRenderEngine(bpy.types.RenderEngine):
    bl_idname = "OPALINE"
    bl_label = "Opaline"
    bl_use_preview = True
    bl_use_eevee_viewport = True
    bl_use_shading_nodes_custom = False

    _viewport = None
    _said = None

    def update_render_passes(self, scene=None, renderlayer=None):
        self.register_pass(scene, renderlayer, "Combined", 4, "RGBA", "COLOR")
        if renderlayer.use_pass_z:
            self.register_pass(scene, renderlayer, "Depth", 1, "Z", "VALUE")
        if renderlayer.use_pass_normal:
            self.register_pass(scene, renderlayer, "Normal", 3, "XYZ", "VECTOR")
        if renderlayer.opaline.use_pass_exitance:
            self.register_pass(scene, renderlayer, "Exitance", 4, "RGBA", "COLOR")

    def render(self, depsgraph):
        from . import final

        if depsgraph.view_layer.opaline.use_pass_exitance:
            self.add_pass("Exitance", 4, "RGBA", layer=depsgraph.view_layer.name)
        try:
            self._require_module()
            final.FinalRender(self, depsgraph).run()
        except final.Cancelled:
            return
        except (RuntimeError, ValueError, MemoryError) as error:
            self._fail(error)

    def view_update(self, context, depsgraph):
        from . import viewport

        try:
            self._require_module()
            if self._viewport is None:
                self._viewport = viewport.Viewport(self)
            self._viewport.update(self, context, depsgraph)
        except (RuntimeError, ValueError, MemoryError) as error:
            self._fail(error)

    def view_draw(self, context, depsgraph):
        if self._viewport is None:
            return
        try:
            self._viewport.draw(self, context, depsgraph)
        except (RuntimeError, ValueError, MemoryError) as error:
            self._fail(error)

    @staticmethod
    def _require_module():
        if MODULE_PROBLEM:
            raise RuntimeError(MODULE_PROBLEM)

    def _fail(self, error):
        """Reports an error as one sentence, and only once."""
        sentence = f"Opaline: {str(error) or type(error).__name__}"
        if sentence == self._said:
            return
        self._said = sentence
        self.report({"ERROR"}, sentence)
        self.error_set(sentence)


def register():
    from . import final

    bpy.utils.register_class(OpalineRenderEngine)
    for handlers in (bpy.app.handlers.render_complete, bpy.app.handlers.render_cancel, bpy.app.handlers.load_pre):
        handlers.append(final.forget)


def unregister():
    from . import final

    for handlers in (bpy.app.handlers.render_complete, bpy.app.handlers.render_cancel, bpy.app.handlers.load_pre):
        if final.forget in handlers:
            handlers.remove(final.forget)
    final.forget()
    bpy.utils.unregister_class(OpalineRenderEngine)
