"""The viewport's rendered mode: first a small picture, then larger ones while nothing changes."""

import threading
import weakref

import numpy as np

from . import units
from .final import premultiplied
from .live import LiveRenderer
from .notes import Notes
from .reading import camera, snapshot

SHARES = (8, 4, 2, 1)  # divisors of width and height, in order
SMALLEST = 48  # pixels of the first picture


class Viewport:
    """Takes scenes on Blender's own thread and shows the pictures that a worker makes of them. The worker ends with
    it."""

    def __init__(self, engine):
        self._worker = Worker(engine)
        self._said = set()
        self._seen = None
        self._texture = None
        self._drawn = None

    def __del__(self):
        self._worker.end()

    def update(self, engine, context, depsgraph):
        """To be called when the scene has changed."""
        notes = Notes()
        seen = snapshot.Reader(depsgraph, units.mm_per_unit(depsgraph.scene), notes).read()
        for sentence in notes.sentences():
            if sentence not in self._said:
                self._said.add(sentence)
                engine.report({"WARNING"}, f"Opaline: {sentence}")
        # A scene that looks as before is not started again, so that its picture keeps getting finer.
        if self._seen is not None and self._seen.is_same(seen):
            seen = None
        else:
            self._seen = seen
        self._worker.take(Wish(context, depsgraph), seen)

    def draw(self, engine, context, depsgraph):
        """Shows the best picture so far, and asks for another where the view has changed."""
        picture = self._worker.take(Wish(context, depsgraph))
        if picture is not None:
            self._show(engine, context, depsgraph, picture)

    def _show(self, engine, context, depsgraph, picture):
        import gpu
        from gpu_extras.presets import draw_texture_2d

        if self._drawn is not picture:
            height, width = picture.shape[:2]
            values = gpu.types.Buffer("FLOAT", width * height * 4, np.ascontiguousarray(picture, dtype=np.float32).ravel())
            self._texture = gpu.types.GPUTexture((width, height), format="RGBA16F", data=values)
            self._drawn = picture
        gpu.state.blend_set("ALPHA_PREMULT")
        engine.bind_display_space_shader(depsgraph.scene)
        draw_texture_2d(self._texture, (0, 0), context.region.width, context.region.height)
        engine.unbind_display_space_shader()
        gpu.state.blend_set("NONE")


class Worker:
    """A thread that renders the newest scene and view: first a small picture, then larger ones."""

    def __init__(self, engine):
        self._engine = weakref.ref(engine)
        self._changed = threading.Condition()
        self._scene = None  # not shown yet
        self._wish = None
        self._picture = None
        self._failure = None
        self._ends = False
        threading.Thread(target=self._work, daemon=True).start()

    def end(self):
        with self._changed:
            self._ends = True
            self._changed.notify()

    def take(self, wish, scene=None):
        """The newest picture, or None. Raises the worker's exception."""
        with self._changed:
            if scene is not None:
                self._scene, self._failure = scene, None
            if scene is not None or self._wish is None or wish != self._wish:
                self._wish = wish
                self._changed.notify()
            if self._failure is not None:
                raise RuntimeError(str(self._failure))
            return self._picture

    def _work(self):
        live = None
        done, share = None, 1  # the wish of the last picture, and its divisor
        while True:
            with self._changed:
                while not self._ends and self._scene is None and (self._wish is done and share == 1):
                    self._changed.wait()
                if self._ends:
                    return
                scene, wish = self._scene, self._wish
                self._scene = None
            if scene is None and wish is done:
                share = next(smaller for smaller in SHARES if smaller < share)
            else:
                share = next(share for share in SHARES if share == 1 or min(wish.size) // share >= SMALLEST)
            done = wish
            try:
                if live is None:
                    live = LiveRenderer(wish.device)
                if scene is not None:
                    live.show(scene)
                picture = self._picture_of(live, wish, share, scene is None)
                with self._changed:
                    self._picture = picture
            except Exception as error:  # raised again by take(), on Blender's thread
                with self._changed:
                    self._failure = error
                share = 1
            if not self._redraw():
                return

    def _redraw(self):
        engine = self._engine()
        try:
            engine.tag_redraw()
        except (AttributeError, ReferenceError):  # the viewport no longer exists
            return False
        return True

    @staticmethod
    def _picture_of(live, wish, share, same_scene):
        if live.is_empty:
            return np.zeros((1, 1, 4), dtype=np.float32)
        width, height = (max(length // share, 1) for length in wish.size)
        frame = live.render(width, height, ["radiance"], wish.camera(live.bounds), not wish.transparent, reuse_light=same_scene,
                            antialias=4 if share == 1 else 1, bounces=wish.bounces)
        return premultiplied(frame["radiance"], wish.transparent)


class Wish:
    """What a picture of the viewport must show."""

    def __init__(self, context, depsgraph):
        view, scene = context.region_data, depsgraph.scene
        self.matrix = np.array(view.view_matrix.inverted())
        self.projection = np.array(view.window_matrix)
        self.size = context.region.width, context.region.height
        self.transparent = scene.render.film_transparent
        self.mm_per_unit = units.mm_per_unit(scene)
        self.bounces = scene.opaline.bounces
        self.device = scene.opaline.device

    def __eq__(self, other):
        return (np.array_equal(self.matrix, other.matrix) and np.array_equal(self.projection, other.projection) and
                (self.size, self.transparent, self.mm_per_unit, self.bounces) ==
                (other.size, other.transparent, other.mm_per_unit, other.bounces))

    __hash__ = None

    def camera(self, bounds):
        return camera.camera_of(self.matrix, self.projection, self.mm_per_unit, bounds)
