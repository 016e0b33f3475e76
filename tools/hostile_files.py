"""Untrustworthy files for hostile.py: wrong ones, legal but awkward ones, and damaged copies of sound ones. They are
the same every time."""

import json
import math
import os
import pathlib
import random
import re
import struct
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "tests" / "cli"))

from awkward_bodies import BODIES, write_obj
from repository import ROOT
from wrong_scenes import WRONG, gltf

CORPUS = ROOT / "tests" / "fuzz" / "corpus"
SCENES = (".obj", ".ply", ".glb", ".gltf", ".toml")
SKIES = (".hdr", ".exr")
TEXTURES = (".png", ".jpg", ".webp")

NUMBERS = (b"0", b"-1", b"1", b"65535", b"4294967295", b"4294967296", b"-2147483648", b"18446744073709551615", b"1e38", b"-1e39",
           b"1e-45", b"0.5", b"nan", b"null", b"[]", b"9" * 400)


class Hostile:
    """A file and its expected outcome: `must` is "read", "refused" or None."""

    def __init__(self, kind, path, must=None):
        self.kind, self.path, self.must = kind, path, must


def obj(points, faces):
    return "".join("v %.9g %.9g %.9g\n" % tuple(p) for p in points) + "".join(
        "f " + " ".join(str(i + 1) for i in face) + "\n" for face in faces)


CORNERS = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
SIDES = ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3))


def cube(scale=1, offset=0):
    return obj([[scale * c + offset for c in corner] for corner in CORNERS], SIDES)


CUBE = cube()
ONE_SIDE = "f 1 2 4 3\n"
TEXTURED = ("mtllib {}.mtl\nusemtl skin\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
            + re.sub(r"f (\d) (\d) (\d) (\d)", r"f \1/1 \2/2 \3/3 \4/4", CUBE))


def between_few_places(seed, faces, places):
    """Random faces between vertices, many of which coincide."""
    dice = random.Random(seed)
    spots = [[dice.choice((0, 1, 2)) for _ in range(3)] for _ in range(places)]
    return obj([dice.choice(spots) for _ in range(3 * faces)], [[dice.randrange(3 * faces) for _ in range(3)] for _ in range(faces)])


def pyramid(size):
    """Eight coarse triangles without a floor."""
    rim = [(size * math.cos(a), 0, size * math.sin(a)) for a in (math.pi * i / 4 for i in range(8))]
    return obj([(0, size, 0), *rim], [(0, 1 + (i + 1) % 8, 1 + i) for i in range(8)])


def fan(count):
    rim = [(math.cos(a), .1 * (i % 2), math.sin(a)) for i, a in ((i, 2 * math.pi * i / count) for i in range(count))]
    return obj([(0, 1, 0), *rim], [(0, 1 + (i + 1) % count, 1 + i) for i in range(count)])


def comb(count):
    """One polygon."""
    points = [(i, 1 if i % 2 else 100, 0) for i in range(count)] + [(count, 0, 0), (0, 0, 0)]
    return obj(points, [reversed(range(len(points)))])


def needles(count):
    points, faces = [], []
    for i in range(count):
        faces.append(range(3 * i, 3 * i + 3))
        points += [(.001 * i, 0, 0), (.001 * i + .001, 0, 0), (.001 * i, 1, .001 * (i % 7))]
    return obj(points, faces)


def moebius(count):
    points = [((1 + s * math.cos(a / 2)) * math.cos(a), s * math.sin(a / 2), (1 + s * math.cos(a / 2)) * math.sin(a))
              for a in (2 * math.pi * i / count for i in range(count)) for s in (-.3, .3)]
    faces = []
    for i in range(count):
        a, b = 2 * i, 2 * i + 1
        c, d = (a + 2, b + 2) if i + 1 < count else (1, 0)
        faces += [(a, b, d), (a, d, c)]
    return obj(points, faces)


def changed_gltf(**changes):
    document = json.loads(gltf())
    document.update(changes)
    return json.dumps(document).encode()


def chain(count):
    nodes = [{"translation": [0, 0, 0], "children": [i + 1]} for i in range(count - 1)] + [{"mesh": 0}]
    return changed_gltf(nodes=nodes)


def crowd(count):
    nodes = [{"mesh": 0, "translation": [3 * (i % 100), 3 * (i // 100), 0]} for i in range(count)]
    return changed_gltf(nodes=nodes, scenes=[{"nodes": list(range(count))}])


AWKWARD = {
    **{f"coincident_{seed}.obj": (between_few_places(seed, 5, 3), None) for seed in range(12)},
    **{f"coincident_{seed}.obj": (between_few_places(seed, 40, 6), None) for seed in range(12, 20)},
    "pyramid_10.obj": (pyramid(10), "read"),
    "pyramid_1000.obj": (pyramid(1000), "read"),
    "pyramid_100000.obj": (pyramid(100000), "read"),
    "fan.obj": (fan(16384), "read"),
    "comb.obj": (comb(8192), "read"),
    "needles.obj": (needles(8192), "read"),
    "moebius.obj": (moebius(40), "read"),
    "continued.obj": (CUBE.replace("f 1 ", "f 1 \\\n"), "read"),
    "backslashes.obj": ("\\\n" * 200000 + CUBE, None),
    "huge.obj": (cube(1e30), None),
    "tiny.obj": (cube(1e-40), None),
    "far.obj": (cube(1, 1e7), None),
    "repeated.obj": (CUBE + ONE_SIDE * 20000, "read"),
    "negative.obj": (CUBE + "f -1 -2 -3\n", "read"),
    "one_line.obj": (CUBE + "#" + "x" * 20_000_000, None),
    "own_library.obj": ("mtllib own_library.obj\n" + CUBE, None),
    "chain.gltf": (chain(20000), None),
    "crowd.gltf": (crowd(10000), None),
    "nested.gltf": (b'{"asset":{"version":"2.0"},"extras":' + b"[" * 200000 + b"]" * 200000 + b"}", "refused"),
    "required.gltf": (changed_gltf(extensionsRequired=["KHR_of_another_day"], extensionsUsed=["KHR_of_another_day"]), "refused"),
    "pipe.gltf": (changed_gltf(buffers=[{"byteLength": 36, "uri": "pipe"}]), "refused"),
    "absolute.gltf": (changed_gltf(buffers=[{"byteLength": 36, "uri": "/etc/passwd"}]), "refused"),
    "link.gltf": (changed_gltf(buffers=[{"byteLength": 36, "uri": "link"}]), "refused"),
    "remote.gltf": (changed_gltf(buffers=[{"byteLength": 36, "uri": "http://localhost/a.bin"}]), "refused"),
    "own_model.toml": ('model = "own_model.toml"\n', "refused"),
    "nested.toml": ("a = " + "[" * 100000, "refused"),
    "device.toml": ('model = "/dev/zero"\n', "refused"),
    "many.toml": ("[[models]]\nfile = 'plain_cube.obj'\ntranslation_mm = [1, 2, 3]\n" * 2000, None),
}


def changed_number(bytes_, dice):
    """Changes one number of a text, or inserts a word instead."""
    found = list(re.finditer(rb"-?\d[\d.eE+-]*", bytes_))
    if not found:
        return bytes_
    one = dice.choice(found)
    return bytes_[:one.start()] + dice.choice(NUMBERS) + bytes_[one.end():]


def changed_document(bytes_, dice):
    """As changed_number(), in the JSON of a binary glTF; its lengths stay right."""
    if bytes_[:4] != b"glTF" or len(bytes_) < 20:
        return changed_number(bytes_, dice)
    length, = struct.unpack_from("<I", bytes_, 12)
    document = changed_number(bytes_[20:20 + length], dice)
    document += b" " * (-len(document) % 4)
    rest = bytes_[20 + length:]
    return struct.pack("<4sIIII", b"glTF", 2, 20 + len(document) + len(rest), len(document), 0x4E4F534A) + document + rest


def cut(bytes_, dice):
    return bytes_[:dice.randrange(len(bytes_))]


def flipped(bytes_, dice):
    changed = bytearray(bytes_)
    for _ in range(dice.choice((1, 2, 8, 64))):
        changed[dice.randrange(len(changed))] ^= 1 << dice.randrange(8)
    return bytes(changed)


def overwritten(bytes_, dice):
    begin, length = dice.randrange(len(bytes_)), dice.choice((1, 2, 4, 8, 64))
    return (bytes_[:begin] + dice.choice((b"\0", b"\xff", b"\x7f", b"\x80")) * length + bytes_[begin + length:])[:len(bytes_)]


def moved(bytes_, dice):
    """Inserts a copy of one piece elsewhere."""
    begin, length, to = dice.randrange(len(bytes_)), dice.choice((1, 4, 16, 256)), dice.randrange(len(bytes_))
    return bytes_[:to] + bytes_[begin:begin + length] + bytes_[to:]


DAMAGES = (cut, flipped, overwritten, moved, changed_number, changed_document)


def textured(path):
    """Puts the given texture on a cube in a file beside it."""
    stem = path.name.replace(".", "_")
    path.with_name(f"{stem}.mtl").write_text(f"newmtl skin\nmap_Kd {path.name}\n")
    model = path.with_name(f"{stem}.obj")
    model.write_text(TEXTURED.format(stem))
    return model


def corpus(endings):
    """Sound files for every reader: path, name."""
    found = [path for path in sorted(CORPUS.rglob("*")) if path.suffix in endings]
    return [(path, f"{path.parent.name}_{path.name}") for path in found]


def samples(folder, largest):
    """Models and pictures of a folder that are small enough to be damaged many times."""
    if folder is None or not folder.is_dir():
        return []
    return [(path, path.name) for path in sorted(folder.rglob("*"))
            if path.suffix in SCENES + SKIES + TEXTURES and path.stat().st_size <= largest]


def kind_of(path, what):
    noun = "scenes" if path.suffix == ".toml" else "skies" if path.suffix in SKIES else (
        "textures" if path.suffix in TEXTURES else "models")
    return f"{what} {noun}, {path.suffix[1:]}"


def write_all(folder, models, copies):
    """Writes all files into an empty folder and returns them."""
    found = []

    def write(kind, name, content, must=None):
        path = folder / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        found.append(Hostile(kind, textured(path) if path.suffix in TEXTURES else path, must))

    for name, content in (("cube.ply", CORPUS / "ply" / "ascii.ply"), ("cube_1.ply", CORPUS / "ply" / "ascii.ply"),
                          ("cube_2.ply", CORPUS / "ply" / "ascii.ply"), ("texture.png", CORPUS / "png" / "gray.png"),
                          ("sky.hdr", CORPUS / "radiance" / "runs.hdr")):
        (folder / name).write_bytes(content.read_bytes())
    (folder / "plain_cube.obj").write_text(CUBE)
    (folder / "cube.obj").write_text(CUBE)
    os.mkfifo(folder / "pipe")
    (folder / "link").symlink_to("/etc/passwd")
    for name, content in WRONG.items():
        write("wrong", f"wrong_{name}", content, "refused")
    for name, (content, must) in AWKWARD.items():
        write("awkward", name, content, must)
    for name, body in BODIES.items():
        path = folder / f"body_{name}.obj"
        write_obj(path, body)
        found.append(Hostile("awkward", path, "read"))
    for end in SCENES + TEXTURES + SKIES:
        (folder / "pipes").mkdir(exist_ok=True)
        path = folder / "pipes" / f"pipe{end}"
        os.mkfifo(path)
        if end not in TEXTURES:
            found.append(Hostile("pipes", path, "refused"))
    sound = corpus(SCENES + TEXTURES + SKIES)
    for path, name in sound:
        write("the fuzzer's corpus", f"corpus_{name}", path.read_bytes())
    for path, name in sound + samples(models, 250_000):
        whole = path.read_bytes()
        dice = random.Random(name)
        for copy in range(copies):
            damage = DAMAGES[copy % len(DAMAGES)]
            write(kind_of(path, "damaged"), f"damaged_{copy}_{name}", damage(whole, dice))
    return found
