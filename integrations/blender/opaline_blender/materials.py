"""Turns looks into materials of the Python module."""

import numpy as np

from . import subsurface
from .reading import images


class Materials:
    """Makes the materials of an opaline.Object, and keeps the pictures that it has read."""

    def __init__(self):
        self._textures = {}  # by picture and mapping; with the picture's state when it was read
        self._brightest = {}

    def keywords(self, look):
        """The arguments of opaline.Object besides its mesh."""
        import opaline

        if look.medium:
            return {"medium": look.medium, "surface": self._surface(look)}
        if look.radius_mm is not None:
            return {**self._scattering(look), "surface": self._surface(look)}
        return {"material": opaline.OpaqueMaterial(
            name=look.name, base_color=np.clip(look.color if not look.color_picture else (1, 1, 1), 0, 1),
            base_color_texture=self._texture(look.color_picture, images.colors_of), metallic=min(max(look.metallic, 0), 1),
            roughness=min(max(look.roughness, 0), 1), metallic_roughness_texture=self._metallic_roughness(look),
            ior=min(max(look.ior, 1), 10), specular=look.specular,
            normal_texture=self._texture(look.normal_picture, images.pixels_of), normal_scale=look.normal_scale,
            emission=np.clip(look.emission, 0, 1e30), emission_texture=self._texture(look.emission_picture, images.colors_of),
            alpha=min(max(look.alpha, 0), 1), alpha_cutoff=0.5 if look.is_cut_out else 0, unlit=look.unlit,
            diffuse_transmission=look.through,
            diffuse_transmission_color=np.clip(look.through_color if not look.through_picture else (1, 1, 1), 0, 1),
            diffuse_transmission_color_texture=self._texture(look.through_picture, images.colors_of))}

    def _surface(self, look):
        import opaline

        return opaline.TranslucentSurface(roughness=min(max(look.roughness, 0), 1),
                                          metallic_roughness_texture=self._metallic_roughness(look),
                                          normal_texture=self._texture(look.normal_picture, images.pixels_of),
                                          normal_scale=look.normal_scale)

    def _scattering(self, look):
        import opaline

        color = np.array(look.color)
        paint = None
        texture = self._texture(look.color_picture, images.colors_of)
        if texture is not None:
            # The medium has the brightest colour. Darker ones are paint on it.
            color = self._brightest[look.color_picture.key()]
            paint = opaline.Paint(color_texture=texture)
        medium = subsurface.medium_of(look.radius_mm, color, look.radius_kind, look.subsurface_ior, look.anisotropy,
                                      look.ior if look.specular else 1, look.roughness)
        return {"medium": medium, "paint": paint}

    def _texture(self, picture, read):
        import opaline

        if picture is None:
            return None

        def make():
            pixels = read(picture.image)
            if pixels is None:
                return None
            colors = images.decoded(pixels[..., :3].reshape(-1, 3))
            self._brightest[picture.key()] = np.percentile(colors, 99.5, axis=0)
            return opaline.Texture(np.clip(np.nan_to_num(pixels), 0, 1), wrap=picture.wrap, interpolated=picture.interpolated,
                                   transform=picture.transform, name=picture.image.name)

        return self._kept((read.__name__, *picture.key()), picture.state, make)

    def _kept(self, key, state, make):
        """The value that was made before, unless the pictures have changed since."""
        if self._textures.get(key, (None, None))[0] != state:
            self._textures[key] = state, make()
        return self._textures[key][1]

    def _metallic_roughness(self, look):
        """Both in one picture, as in glTF: green is roughness, blue metallic."""
        import opaline

        picture = look.roughness_picture or look.metallic_picture
        if picture is None:
            return None
        pictures = look.roughness_picture, look.metallic_picture

        def make():
            parts = [images.values_of(part.image, part.channel) if part else None for part in pictures]
            shape = np.max([part.shape for part in parts if part is not None] or [(0, 0)], axis=0)
            if not shape.all():
                return None
            pixels = np.ones((*shape, 3), dtype=np.float32)
            for channel, part in ((1, parts[0]), (2, parts[1])):
                if part is not None:
                    pixels[..., channel] = images.resampled(part, *shape)
            return opaline.Texture(np.clip(pixels, 0, 1), wrap=picture.wrap, interpolated=picture.interpolated,
                                   transform=picture.transform, name=picture.image.name)

        return self._kept(("metallic-roughness", *(each and each.key() for each in pictures)),
                          tuple(each and each.state for each in pictures), make)
