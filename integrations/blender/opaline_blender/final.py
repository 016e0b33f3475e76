"""Renders of stills and of frames of an animation."""

import threading

import numpy as np

from .live import LiveRenderer
from .notes import Notes
from .reading import camera, snapshot
from . import pixels, units

# Kept between frames of an animation, by scene: its renderer, and what has been reported.
_live = {}


class Session:
    def __init__(self, device):
        self.live = LiveRenderer(device)
        self.said = set()
        self.device = device


def forget(*_):
    """Drops what renders have kept on the device."""
    _live.clear()


def _session_of(scene):
    session = _live.get(scene.name_full)
    if session is None or session.device != scene.opaline.device:
        session = _live[scene.name_full] = Session(scene.opaline.device)
    return session


def picture_size(scene):
    """Width and height of the whole picture, and the rendered part of it in pixels from the lower left."""
    render = scene.render
    width = max(int(render.resolution_x * render.resolution_percentage / 100), 1)
    height = max(int(render.resolution_y * render.resolution_percentage / 100), 1)
    if not render.use_border:
        return width, height, (0, 0, width, height)
    left, right = int(render.border_min_x * width), int(render.border_max_x * width)
    bottom, top = int(render.border_min_y * height), int(render.border_max_y * height)
    return width, height, (left, bottom, max(right, left + 1), max(top, bottom + 1))


def matrices_of(depsgraph, scene, width, height, part):
    """The camera's transform, and its projection for that part of the picture."""
    view = scene.camera.evaluated_get(depsgraph)
    render = scene.render
    projection = camera.projection_of(view, depsgraph, width, height, render.pixel_aspect_x, render.pixel_aspect_y)
    left, bottom, right, top = part
    return view.matrix_world, camera.cropped(projection, left / width, bottom / height, right / width, top / height)


def premultiplied(picture, transparent):
    """A picture in Blender's form: rows from the bottom, colour times alpha."""
    picture = np.nan_to_num(picture[::-1])
    alpha = picture[..., 3:] if transparent else np.ones_like(picture[..., 3:])
    return np.concatenate([picture[..., :3] * picture[..., 3:], alpha], axis=2)


def _depths(picture, mm_per_unit):
    """Depth in Blender's units. Pixels without surface are as far as in Cycles."""
    picture = picture[::-1]
    return np.where(picture[..., 3] > 0, picture[..., 0] / mm_per_unit, 1e10)[..., None]


def _normals(picture):
    return units.turned_back(picture[::-1, :, :3])


class Cancelled(Exception):
    pass


def _on_a_thread(work, is_cancelled):
    """Renders while Blender's window stays alive. A picture that is no longer wanted finishes in its own time."""
    done = {}

    def run():
        try:
            done["result"] = work()
        except Exception as error:  # raised again below
            done["error"] = error

    thread = threading.Thread(target=run, daemon=True)
    thread.start()
    while thread.is_alive():
        thread.join(0.05)
        if thread.is_alive() and is_cancelled():
            raise Cancelled
    if "error" in done:
        raise done["error"]
    return done["result"]


class FinalRender:
    """One view layer of one frame."""

    def __init__(self, engine, depsgraph):
        self._engine = engine
        self._depsgraph = depsgraph
        self._scene = depsgraph.scene_eval
        self._layer = depsgraph.view_layer_eval

    def run(self):
        if self._scene.camera is None:
            raise ValueError("the scene has no camera")
        session = _session_of(self._scene)
        notes = Notes()
        mm_per_unit = units.mm_per_unit(self._scene)
        if self._scene.render.use_multiview:
            notes.add("of stereo pictures one view is rendered")
        if self._scene.render.use_motion_blur:
            notes.add("motion blur is not shown")
        if self._scene.camera.type == "CAMERA" and self._scene.camera.data.type == "PANO":
            notes.add("panoramic cameras are shown as perspective ones", self._scene.camera.name)
        if self._scene.camera.type == "CAMERA" and self._scene.camera.data.dof.use_dof:
            notes.add("depth of field is not shown", self._scene.camera.name)
        seen = snapshot.Reader(self._depsgraph, mm_per_unit, notes).read()
        if not seen.bodies and seen.world.image is not None:
            notes.add("without a body the world's picture is not shown")
        width, height, part = picture_size(self._scene)
        matrices = matrices_of(self._depsgraph, self._scene, width, height, part)
        view = camera.camera_of(*matrices, mm_per_unit)
        if any(camera.clips(*matrices, mm_per_unit, body.mesh) for body in seen.bodies):
            notes.add("the camera's clip distances cut nothing off", self._scene.camera.name)
        self._say(notes, session)
        size = part[2] - part[0], part[3] - part[1]
        wanted = self._wanted()
        drawn = pixels.square_size(*size, matrices[1])
        frame = _on_a_thread(lambda: self._pictures(session, seen, drawn, wanted, view), self._engine.test_break)
        self._give(frame, size, mm_per_unit)

    def _wanted(self):
        wanted = ["radiance"]
        if self._layer.use_pass_z:
            wanted.append("depth")
        if self._layer.use_pass_normal:
            wanted.append("normal")
        if self._depsgraph.view_layer.opaline.use_pass_exitance:
            wanted.append("exitance")
        return wanted

    def _pictures(self, session, seen, size, wanted, view):
        session.live.show(seen)
        if session.live.is_empty:
            return self._of_nothing(seen, size, wanted)
        chosen = self._scene.opaline
        return session.live.render(*size, wanted, view, not self._scene.render.film_transparent,
                                   antialias=int(chosen.samples), bounces=chosen.bounces)

    def _of_nothing(self, seen, size, wanted):
        """A picture of the world's colour only."""
        empty = {name: np.zeros((size[1], size[0], 4), dtype=np.float32) for name in wanted}
        if not self._scene.render.film_transparent:
            empty["radiance"][:] = (*seen.world.ambient, 1)
        return empty

    def _say(self, notes, session):
        for sentence in notes.sentences():
            if sentence not in session.said:
                session.said.add(sentence)
                self._engine.report({"WARNING"}, f"Opaline: {sentence}")

    def _give(self, frame, size, mm_per_unit):
        result = self._engine.begin_result(0, 0, *size, layer=self._depsgraph.view_layer.name)
        passes = result.layers[0].passes
        transparent = self._scene.render.film_transparent
        pictures = {"Combined": premultiplied(frame["radiance"], transparent)}
        if "depth" in frame:
            pictures["Depth"] = _depths(frame["depth"], mm_per_unit)
        if "normal" in frame:
            pictures["Normal"] = _normals(frame["normal"])
        if "exitance" in frame:
            pictures["Exitance"] = premultiplied(frame["exitance"], True)
        for name, picture in pictures.items():
            into = passes.get(name)
            if into is None:
                continue
            # A mean of two depths or two normals would be wrong.
            fitted = pixels.nearest if name in ("Depth", "Normal") else pixels.averaged
            values = np.ascontiguousarray(fitted(picture, *size), dtype=np.float32)
            if len(passes) == 1:
                passes.foreach_set("rect", values.ravel())
            else:  # foreach_set cannot tell them apart
                into.rect = values.reshape(-1, values.shape[2]).tolist()
        self._engine.end_result(result)
