"""Scenes that are wrong, name by name: each has to be refused by one sentence."""

import base64
import struct

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
