"""Pictures of Blender as arrays."""

import os
import zlib

import numpy as np


def encoded(linear):
    """IEC 61966-2-1."""
    linear = np.clip(linear, 0, 1)
    return np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)


def decoded(values):
    return np.where(values <= 0.04045, values / 12.92, ((values + 0.055) / 1.055) ** 2.4)


def pixels_of(image):
    """Array (height, width, 4), float32, row 0 at the top, with the values that the picture stores; None if there are
    none."""
    width, height = image.size
    if width == 0 or height == 0 or image.channels == 0 or not image.has_data and not _loads(image):
        return None
    values = np.empty(width * height * image.channels, dtype=np.float32)
    image.pixels.foreach_get(values)
    values = values.reshape(height, width, image.channels)[::-1]
    if image.channels == 1:
        values = np.repeat(values, 3, axis=2)
    if values.shape[2] < 4:
        values = np.concatenate([values[..., :3], np.ones((height, width, 1), dtype=np.float32)], axis=2)
    return np.ascontiguousarray(values)


def _loads(image):
    len(image.pixels)  # reads the file
    return image.has_data


def state_of(image):
    """A value that changes with the picture's pixels: when it is painted, packed, made again or loaded from another
    file."""
    if image.is_dirty:
        values = np.empty(len(image.pixels), dtype=np.float32)
        image.pixels.foreach_get(values)
        return "painted", zlib.crc32(values)
    if image.packed_file is not None:
        return "packed", zlib.crc32(image.packed_file.data)
    if image.source == "GENERATED":
        return image.generated_type, *image.size, *image.generated_color
    path = image.filepath_from_user()
    try:
        return path, os.stat(path).st_mtime_ns
    except OSError:
        return (path,)


def stored_as_colors(image):
    """Whether the picture stores sRGB-encoded colours."""
    return not image.is_float and image.colorspace_settings.name in ("sRGB", "Filmic sRGB", "AgX Base sRGB")


def colors_of(image):
    """sRGB-encoded pixels, whatever the picture stores."""
    pixels = pixels_of(image)
    if pixels is not None and not stored_as_colors(image):
        pixels[..., :3] = encoded(pixels[..., :3])
    return pixels


def values_of(image, channel):
    """One channel, or the luminance by Rec. 709, as Blender turns a color into a number: array (height, width)."""
    pixels = radiance_of(image)
    if pixels is None:
        return None
    return pixels[..., channel] if channel is not None else pixels[..., :3] @ np.array((0.2126, 0.7152, 0.0722), dtype=np.float32)


def resampled(values, height, width):
    """The values at another size, by the nearest texel."""
    rows = (np.arange(height) * values.shape[0]) // height
    columns = (np.arange(width) * values.shape[1]) // width
    return values[rows[:, None], columns]


def radiance_of(image):
    """Linear pixels."""
    pixels = pixels_of(image)
    if pixels is not None and stored_as_colors(image):
        pixels[..., :3] = decoded(pixels[..., :3])
    return pixels
