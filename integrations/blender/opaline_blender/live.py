"""One renderer that follows a changing scene and remakes only what changed."""

import numpy as np

from .materials import Materials


def _scene_of(snapshot, materials):
    import opaline

    return opaline.Scene([
        opaline.Object(body.mesh.positions, body.mesh.triangles, name=body.name, normals=body.mesh.normals,
                       texture_coordinates=body.mesh.coordinates, **materials.keywords(body.look))
        for body in snapshot.bodies])


def _set_lights(scene, snapshot):
    scene.lights = snapshot.lights
    scene.ambient = snapshot.world.ambient


def _set_environment(scene, world):
    scene.set_environment(world.picture() if world.image else None, max(world.strength, 0), world.turn_degrees)


def scene_of(snapshot):
    """opaline.Scene without its camera."""
    scene = _scene_of(snapshot, Materials())
    _set_lights(scene, snapshot)
    _set_environment(scene, snapshot.world)
    return scene


class LiveRenderer:
    def __init__(self, device="", max_clusters=0):
        self._device = device
        self._materials = Materials()
        self._renderer = None
        self._scene = None
        self._shown = None
        self._environment = None

    @property
    def is_empty(self):
        return self._shown is None or not self._shown.bodies

    @property
    def bounds(self):
        """The bounds of the scene shown, which must not be empty."""
        return self._shown.bounds

    def show(self, snapshot):
        """Shows a snapshot from the next picture on."""
        if not snapshot.bodies:
            self._shown = snapshot
            return
        if self._renderer is None or not self._keeps_bodies(snapshot):
            self._make(snapshot)
        else:
            self._follow(snapshot)
        self._shown = snapshot

    def render(self, width, height, aovs, camera, environment_behind, reuse_light=False, **options):
        return self._renderer.render(width, height, aovs, camera=camera, environment_behind=environment_behind,
                                     reuse_light=reuse_light, **options)

    def _keeps_bodies(self, snapshot):
        before = self._shown.bodies
        if len(before) != len(snapshot.bodies):
            return False
        for old, new in zip(before, snapshot.bodies):
            if not old.mesh.is_like(new.mesh):
                return False
            if old.look.is_translucent != new.look.is_translucent:
                return False
        return True

    def _make(self, snapshot):
        import opaline

        self._scene = _scene_of(snapshot, self._materials)
        self._environment = None
        self._set_lights(snapshot)
        if self._renderer is None:
            self._renderer = opaline.Renderer(self._scene, device=self._device)
        else:
            self._renderer.set_scene(self._scene)

    def _follow(self, snapshot):
        for index, (old, new) in enumerate(zip(self._shown.bodies, snapshot.bodies)):
            if not np.array_equal(old.mesh.positions, new.mesh.positions):
                self._renderer.set_positions(index, new.mesh.positions)
            if old.look != new.look:
                self._renderer.set_material(index, **self._materials.keywords(new.look))
        self._set_lights(snapshot)
        self._renderer.set_lights(self._scene)

    def _set_lights(self, snapshot):
        _set_lights(self._scene, snapshot)
        if snapshot.world.key() != self._environment:
            self._environment = snapshot.world.key()
            _set_environment(self._scene, snapshot.world)
