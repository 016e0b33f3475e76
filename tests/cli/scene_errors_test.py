"""Scenes that are wrong get one sentence that names the file, quickly and without much memory. What
each loader refuses is tested beside the loaders; here the whole program is."""

import base64
import resource
import struct
import unittest

from program import CUBE_OBJ, ProgramTest

LARGEST_MEMORY_KB = 500 * 1000

PLY_HEADER = """ply\nformat {format} 1.0\nelement vertex {vertices}
property float x\nproperty float y\nproperty float z\nelement face {faces}
property list uchar int vertex_indices\nend_header\n"""


def ply(vertices, faces, body="", format="ascii"):
    header = PLY_HEADER.format(format=format, vertices=vertices, faces=faces).encode()
    return header + (body if isinstance(body, bytes) else body.encode())


def gltf(accessor="", view=""):
    """One triangle, the points of which are in the file itself."""
    points = base64.b64encode(struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0)).decode()
    return ('{"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],'
            '"meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}], "accessors": [{' + accessor +
            '"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}], "bufferViews": [{' + view +
            '"buffer": 0, "byteLength": 36}], "buffers": [{"byteLength": 36, "uri":'
            f'"data:application/octet-stream;base64,{points}"' + '}]}').encode()


TRIANGLE = "0 0 0\n1 0 0\n0 1 0\n"

WRONG = {
    "empty.ply": b"",
    "empty.obj": b"",
    "empty.glb": b"",
    "empty.gltf": b"",
    "text.glb": b"this is no binary glTF",
    "text.ply": b"this is no PLY",
    "cut.glb": b"glTF" + struct.pack("<II", 2, 1000),
    "long.glb": b"glTF" + struct.pack("<IIII", 2, 0xFFFFFFFF, 0xFFFFFFF0, 0x4E4F534A) + b"{}",
    "cut.gltf": b'{"asset": {"version": "2.0"}, "meshes": [',
    "nothing.gltf": b'{"asset": {"version": "2.0"}}',
    "outside.gltf": b'{"asset": {"version": "2.0"}, "buffers": [{"uri": "../../etc/passwd", "byteLength": 36}],'
                    b'"bufferViews": [{"buffer": 0, "byteLength": 36}], "accessors": [{"bufferView": 0,'
                    b'"componentType": 5126, "count": 3, "type": "VEC3"}], "meshes": [{"primitives":'
                    b'[{"attributes": {"POSITION": 0}}]}], "nodes": [{"mesh": 0}], "scenes": [{"nodes": [0]}]}',
    "promise.ply": ply(4_000_000_000_000, 4_000_000_000_000, TRIANGLE),
    "binary_promise.ply": ply(4_000_000_000, 1, b"\0" * 24, "binary_little_endian"),
    "cut.ply": ply(3, 1, "0 0 0\n1 0 0\n"),
    "index.ply": ply(3, 1, TRIANGLE + "3 0 1 7\n"),
    "negative.ply": ply(3, 1, TRIANGLE + "3 0 1 -1\n"),
    "nan.ply": ply(3, 1, "0 0 0\nnan 0 0\n0 1 0\n3 0 1 2\n"),
    "infinite.ply": ply(3, 1, "0 0 0\ninf 0 0\n0 1 0\n3 0 1 2\n"),
    "negative_offset.gltf": gltf(accessor='"byteOffset": -4, '),
    "negative_view.gltf": gltf(view='"byteOffset": -1, '),
    "sparse.gltf": gltf(accessor='"sparse": {"count": 1099511627776, "indices": {"bufferView": 0,'
                                 '"componentType": 5125}, "values": {"bufferView": 0}}, '),
    "faceless.ply": ply(3, 0, TRIANGLE),
    "flat.ply": ply(3, 1, "0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n"),
    "index.obj": b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n",
    "noise.obj": bytes(range(128, 256)) * 20,
    "unknown.xyz": b"0 0 0",
    "broken.toml": b"model = ",
    "modelless.toml": b"diagonal_mm = 50\n",
    "key.toml": b'model = "cube.obj"\ndiagonal = 50\n',
    "range.toml": b'model = "cube.obj"\ndiagonal_mm = -50\n',
    "lost.toml": b'model = "lost.obj"\n',
    "utf8.toml": b'model = "\xff\xfe"\n',
}


class WrongScenes(ProgramTest):
    def test_each_is_refused_by_name(self):
        self.write("cube.obj", CUBE_OBJ)
        for name, content in WRONG.items():
            self.write(name, content)
        before = self.listing()
        for name in WRONG:
            for command in ("info", "render"):
                with self.subTest(name=name, command=command):
                    says = "lost.obj" if name == "lost.toml" else "" if name == "utf8.toml" else name
                    self.refused(1, command, name, "--quiet", says=says)
        self.assertEqual(self.listing(), before)
        self.assertLess(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss, LARGEST_MEMORY_KB)

    def test_a_right_one_like_the_wrong_ones_is_read(self):
        self.write("right.gltf", gltf())
        self.assertEqual(self.succeed("info", "right.gltf", "--json").json()["triangles"], 1)

    def test_an_unknown_key_names_its_neighbour(self):
        self.write("cube.obj", CUBE_OBJ)
        self.write("key.toml", WRONG["key.toml"])
        self.refused(1, "info", "key.toml", says=("diagonal", "diagonal_mm"))

    def test_what_is_no_file(self):
        (self.folder / "folder.ply").mkdir()
        self.refused(1, "info", "nosuch.ply", says="nosuch.ply")
        self.refused(1, "info", "folder.ply", says="folder.ply")
        self.refused(1, "info", "/dev/zero", says="/dev/zero")
        self.refused(1, "info", "", says="")
        self.refused(1, "info", "line\nbreak.ply", says="line?break.ply")

    def test_an_environment_that_is_wrong(self):
        self.write("empty.hdr", b"")
        self.write("text.exr", b"this is no EXR")
        self.write("promise.hdr", b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 900000000 +X 900000000\n")
        for name in ("empty.hdr", "text.exr", "promise.hdr", "nosuch.hdr"):
            self.refused(1, "render", "--environment", name, "--quiet", says=name)


if __name__ == "__main__":
    unittest.main()
