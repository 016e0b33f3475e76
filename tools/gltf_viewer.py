#!/usr/bin/env python3
"""Compares opaque balls under one directional light with two viewers of glTF in a browser, the sample renderer of
Khronos and three.js, and writes a table in Markdown.

  npm install --prefix FOLDER @khronosgroup/gltf-viewer three
  tools/gltf_viewer.py FOLDER build/release/bin/opaline [--browser chromium] [--keep FOLDER]

Renders the same files with all, without shadows, sky or bounces, one sample a pixel, and compares blocks of
8×8 pixels that the ball covers wholly and that are lit in full: largest and root mean square difference. The
renderer of Khronos keeps to appendix B of the specification, so it is also compared with what Opaline does beyond that
set aside: what facets send on to each other (Turquin 2019, in three.js too), and diffuse light that is less by all
that the surface mirrors towards the eye, instead of by what the facet halfway between eye and light mirrors. Both are
closed forms, evaluated here anew.
"""

import argparse
import contextlib
import http.server
import json
import math
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import threading

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "tests" / "cli"))

import images

EDGE = 8
SIZE = 96
COLOR = (0.8, 0.5, 0.3)
ROUGHNESSES = (0.2, 0.35, 0.5, 0.7, 1.0)
METALNESSES = (0.0, 0.5, 1.0)
IRRADIANCE = 2.0
TO_LIGHT = tuple(x / math.sqrt(1.5 ** 2 + 1 + 2 ** 2) for x in (1.5, 1.0, 2.0))
DISTANCE, HALF_ANGLE = 8.0, 0.15
HEAD_ON = 0.04  # F0 for an index of refraction of 1.5
EXPOSURES = (1 / 512, 1 / 32, 1 / 4, 1, 8)
LEAST_COSINE = 0.05  # of light that counts
SECONDS = 300

FRAME = """<!DOCTYPE html>
<canvas id="canvas" width="{size}" height="{size}"></canvas>
<script type="importmap">{{"imports": {{"three": "/three/build/three.module.js"}}}}</script>
<script>
const post = (path, body) => fetch(path, {{method: "POST", body}});
window.onerror = (message) => post("/failed", String(message));
window.onunhandledrejection = (event) => post("/failed", String(event.reason && event.reason.stack || event.reason));
const canvas = document.getElementById("canvas"), size = {size}, files = {files}, exposures = {exposures};
</script>
<script type="module">{script}
await post("/done", "");
</script>
"""

KHRONOS = """
// Decoders of what the files do not have, without which it does not start.
window.LIBKTX = async () => ({GL: {makeContextCurrent() {}, createContext() {}}});
window.DracoDecoderModule = async () => ({});
const {GltfState, GltfView} = await import("/@khronosgroup/gltf-viewer/dist/gltf-viewer.module.js");
const context = canvas.getContext("webgl2", {alpha: true, antialias: false});
const view = new GltfView(context);
view.renderer.applyEnvironmentMap = (state, slot) => slot;  // there is none
const loader = view.createResourceLoader(undefined, undefined, "/@khronosgroup/gltf-viewer/dist/libs/");
for (let file = 0; file < files; ++file) {
  const state = view.createState();
  state.gltf = await loader.loadGltf("/ball" + file + ".glb");
  state.sceneIndex = 0;
  state.cameraIndex = 0;
  Object.assign(state.renderingParameters, {useIBL: false, usePunctual: true, renderEnvironmentMap: false,
    clearColor: [0, 0, 0, 0], toneMap: GltfState.ToneMaps.NONE, internalMSAA: 1});
  for (const [which, exposure] of exposures.entries()) {
    state.renderingParameters.exposure = exposure;
    view.renderFrame(state, size, size);
    view.renderFrame(state, size, size);
    const pixels = new Uint8Array(4 * size * size);
    context.readPixels(0, 0, size, size, context.RGBA, context.UNSIGNED_BYTE, pixels);
    await post("/picture/" + file + "/" + which, pixels);
  }
}
"""

THREE = """
const THREE = await import("three");
const {GLTFLoader} = await import("/three/examples/jsm/loaders/GLTFLoader.js");
// It makes surfaces rougher that are curved within a pixel.
const chunk = THREE.ShaderChunk.lights_physical_fragment;
const widening = "material.roughness += geometryRoughness;";
if (!chunk.includes(widening)) throw Error("three.js says roughness in other words");
THREE.ShaderChunk.lights_physical_fragment = chunk.replace(widening, "");
const renderer = new THREE.WebGLRenderer({canvas, antialias: false});
const target = new THREE.WebGLRenderTarget(size, size, {type: THREE.FloatType});
renderer.setClearColor(0, 0);
renderer.setRenderTarget(target);
for (let file = 0; file < files; ++file) {
  const {scene, cameras} = await new GLTFLoader().loadAsync("/ball" + file + ".glb");
  renderer.render(scene, cameras[0]);
  const pixels = new Float32Array(4 * size * size);
  renderer.readRenderTargetPixels(target, 0, 0, size, size, pixels);
  await post("/picture/" + file + "/0", pixels);
}
"""


def ball_mesh(rows=96, columns=192):
    """Positions, which are the normals too, and triangles of a ball of radius 1."""
    places = [(math.sin(math.pi * r / rows) * math.sin(2 * math.pi * c / columns), math.cos(math.pi * r / rows),
               math.sin(math.pi * r / rows) * math.cos(2 * math.pi * c / columns))
              for r in range(rows + 1) for c in range(columns + 1)]
    corners = []
    for r in range(rows):
        for c in range(columns):
            a, b = r * (columns + 1) + c, (r + 1) * (columns + 1) + c
            corners += [a, b, a + 1] if r < rows - 1 else []
            corners += [b, b + 1, a + 1] if r < rows - 1 else [a, b, a + 1]
    return places, corners


def ball_file(metallic, roughness):
    places, corners = ball_mesh()
    corner_bytes = struct.pack(f"<{len(corners)}I", *corners)
    place_bytes = b"".join(struct.pack("<3f", *place) for place in places)
    x, y, z = TO_LIGHT
    # Rotates the light's direction -z away from TO_LIGHT, about the axis z × TO_LIGHT.
    half = math.acos(z) / 2
    across = math.hypot(x, y)
    turn = [-y / across * math.sin(half), x / across * math.sin(half), 0, math.cos(half)]
    content = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1, 2]}],
        "extensionsUsed": ["KHR_lights_punctual"],
        "extensions": {"KHR_lights_punctual": {"lights": [{"type": "directional", "intensity": IRRADIANCE}]}},
        "nodes": [{"mesh": 0}, {"camera": 0, "translation": [0, 0, DISTANCE]},
                  {"rotation": turn, "extensions": {"KHR_lights_punctual": {"light": 0}}}],
        "cameras": [{"type": "perspective",
                     "perspective": {"yfov": 2 * HALF_ANGLE, "aspectRatio": 1, "znear": 1, "zfar": 20}}],
        "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [*COLOR, 1], "metallicFactor": metallic,
                                                "roughnessFactor": roughness}}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 0}, "indices": 1, "material": 0}]}],
        "buffers": [{"byteLength": len(place_bytes) + len(corner_bytes)}],
        "bufferViews": [{"buffer": 0, "byteLength": len(place_bytes)},
                        {"buffer": 0, "byteOffset": len(place_bytes), "byteLength": len(corner_bytes)}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": len(places), "type": "VEC3",
                       "min": [min(place[k] for place in places) for k in range(3)],
                       "max": [max(place[k] for place in places) for k in range(3)]},
                      {"bufferView": 1, "componentType": 5125, "count": len(corners), "type": "SCALAR"}],
    }
    text = json.dumps(content).encode()
    text += b" " * (-len(text) % 4)
    body = place_bytes + corner_bytes
    return (struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(body)) + struct.pack("<I4s", len(text), b"JSON") +
            text + struct.pack("<I4s", len(body), b"BIN\0") + body)


@contextlib.contextmanager
def served(packages, folder, page, pictures, ended):
    """An HTTP server for the page and its files. It receives the viewer's pixels by file and exposure."""
    class Handler(http.server.BaseHTTPRequestHandler):
        def answer(self, code, body=b"", kind="text/plain"):
            self.send_response(code)
            self.send_header("Content-Type", kind)
            self.send_header("Content-Length", str(len(body)))
            self.end_headers()
            self.wfile.write(body)

        def do_GET(self):
            if self.path == "/":
                return self.answer(200, page.encode(), "text/html")
            base = folder if self.path.startswith("/ball") else packages
            path = (base / self.path.lstrip("/")).resolve()
            if not path.is_relative_to(base.resolve()) or not path.is_file():
                return self.answer(404)
            kinds = {".js": "text/javascript", ".wasm": "application/wasm"}
            return self.answer(200, path.read_bytes(), kinds.get(path.suffix, "application/octet-stream"))

        def do_POST(self):
            body = self.rfile.read(int(self.headers["Content-Length"]))
            _, what, *rest = self.path.split("/")
            if what == "picture":
                pictures[int(rest[0]), int(rest[1])] = body
            else:
                ended.append(body.decode() if what == "failed" else "")
            self.answer(200)
            if what != "picture":
                finished.set()

        def log_message(self, *_):
            pass

    finished = threading.Event()
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    yield f"http://127.0.0.1:{server.server_address[1]}/", finished
    server.shutdown()


def viewer_pictures(script, packages, browser, folder, count):
    """What a viewer's page sends, by file and exposure."""
    page = FRAME.format(size=SIZE, files=count, exposures=list(EXPOSURES), script=script)
    pictures, ended = {}, []
    with served(packages, folder, page, pictures, ended) as (address, finished), tempfile.TemporaryDirectory() as user:
        command = [browser, "--headless=new", "--no-sandbox", "--disable-gpu", "--use-angle=swiftshader",
                   "--enable-unsafe-swiftshader", "--disable-quic", "--no-first-run", "--disable-sync",
                   "--disable-background-networking", "--disable-component-update", f"--user-data-dir={user}", address]
        with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as process:
            finished.wait(SECONDS)
            process.terminate()
    if not ended or ended[0]:
        sys.exit(f"gltf_viewer.py: the viewer did not finish: {ended[0] if ended else 'out of time'}")
    return pictures


def khronos_pictures(*where):
    """Linear radiance by file and pixel, with rows from the top; alpha is coverage."""
    shown = viewer_pictures(KHRONOS, *where)
    return [merged({exposure: shown[i, which] for which, exposure in enumerate(EXPOSURES)}) for i in range(where[-1])]


def three_pictures(*where):
    shown = viewer_pictures(THREE, *where)
    return [images.Picture([list(struct.iter_unpack("<4f", shown[i, 0][16 * SIZE * y:16 * SIZE * (y + 1)]))
                            for y in reversed(range(SIZE))]) for i in range(where[-1])]


def merged(by_exposure):
    """Each pixel from the longest exposure in which it is not clipped, decoded with the power 2.2."""
    rows = []
    for y in reversed(range(SIZE)):
        row = []
        for x in range(SIZE):
            at = 4 * (y * SIZE + x)
            exposure = max((e for e in EXPOSURES if max(by_exposure[e][at:at + 3]) < 250), default=EXPOSURES[0])
            pixel = by_exposure[exposure][at:at + 4]
            row.append((*((value / 255) ** 2.2 / exposure for value in pixel[:3]), pixel[3] / 255))
        rows.append(row)
    return images.Picture(rows)


def our_picture(program, file):
    target = file.with_suffix(".exr")
    subprocess.run([program, "render", file, "-o", target, "--size", f"{SIZE}x{SIZE}", "--antialias", "1",
                    "--bounces", "0", "--quiet"], check=True)
    return images.read_exr(target.read_bytes())


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def unit(a):
    length = math.sqrt(dot(a, a))
    return tuple(x / length for x in a)


def ggx(alpha, half, out, to_light):
    """Distribution times visibility, sections B.3.2 and B.3.3 of the specification."""
    a2 = alpha * alpha
    distribution = a2 / (math.pi * (half * half * (a2 - 1) + 1) ** 2)
    return distribution * 0.5 / (to_light * math.sqrt(out * out * (1 - a2) + a2) +
                                 out * math.sqrt(to_light * to_light * (1 - a2) + a2))


def schlick(head_on, cosine):
    return head_on + (1 - head_on) * (1 - cosine) ** 5


def mirrored_parts(alpha, out, steps=48):
    """For even light, the parts of F₀ and F₉₀ by Schlick 1994 that facets mirror. Averages over the facets that the eye
    sees (Heitz 2018), at the midpoints of a square of `steps` by `steps` numbers."""
    side = math.sqrt(1 - out * out)
    eye = (side, 0.0, out)
    stretched = unit((alpha * side, 0.0, out))
    across = unit((-stretched[1], stretched[0], 0.0)) if stretched[2] < 0.9999999 else (1.0, 0.0, 0.0)
    second = (stretched[1] * across[2] - stretched[2] * across[1], stretched[2] * across[0] - stretched[0] * across[2],
              stretched[0] * across[1] - stretched[1] * across[0])
    base = grazing = 0.0
    for i in range(steps):
        for k in range(steps):
            radius, angle = math.sqrt((i + 0.5) / steps), 2 * math.pi * (k + 0.5) / steps
            t1, t2 = radius * math.cos(angle), radius * math.sin(angle)
            part = 0.5 * (1 + stretched[2])
            t2 = (1 - part) * math.sqrt(1 - t1 * t1) + part * t2
            t3 = math.sqrt(max(0.0, 1 - t1 * t1 - t2 * t2))
            found = tuple(t1 * a + t2 * b + t3 * c for a, b, c in zip(across, second, stretched))
            facet = unit((alpha * found[0], alpha * found[1], max(found[2], 1e-6)))
            cosine = dot(eye, facet)
            to_light = 2 * cosine * facet[2] - eye[2]
            if to_light <= 0:
                continue
            a2 = alpha * alpha
            hidden_out = (math.sqrt(1 + a2 * (1 / (out * out) - 1)) - 1) / 2
            hidden_in = (math.sqrt(1 + a2 * (1 / (to_light * to_light) - 1)) - 1) / 2
            weight = (1 + hidden_out) / (1 + hidden_out + hidden_in) / steps ** 2
            rest = (1 - cosine) ** 5
            base += weight * (1 - rest)
            grazing += weight * rest
    return base, grazing


class Shares:
    """mirrored_parts for one roughness, interpolated."""

    ENTRIES = 40

    def __init__(self, alpha):
        self.table = [mirrored_parts(alpha, (i + 0.5) / self.ENTRIES) for i in range(self.ENTRIES)]

    def __call__(self, out):
        place = min(max(out * self.ENTRIES - 0.5, 0.0), self.ENTRIES - 1.001)
        low = int(place)
        return tuple(a + (b - a) * (place - low) for a, b in zip(self.table[low], self.table[low + 1]))


def radiance(metallic, roughness, shares, normal, eye):
    """The reflectance by the specification alone, and with Opaline's additions, per channel."""
    alpha = roughness ** 2
    out, to_light = max(dot(normal, eye), 1e-3), dot(normal, TO_LIGHT)
    half = unit(tuple(a + b for a, b in zip(eye, TO_LIGHT)))
    cosine = dot(half, eye)
    lobe = ggx(alpha, dot(half, normal), out, to_light)
    base, grazing = shares(out)
    mirrored = base + grazing

    def sent_on(head_on):
        return 1 + head_on * (1 / mirrored - 1)

    plain, whole = [], []
    for color in COLOR:
        dielectric, metal = schlick(HEAD_ON, cosine), schlick(color, cosine)
        taken = sent_on(HEAD_ON) * (HEAD_ON * base + grazing)
        plain.append(IRRADIANCE * to_light * ((1 - metallic) * (color / math.pi * (1 - dielectric) + dielectric * lobe) +
                                              metallic * metal * lobe))
        whole.append(IRRADIANCE * to_light * ((1 - metallic) * (color / math.pi * (1 - taken) +
                                                                sent_on(HEAD_ON) * dielectric * lobe) +
                                              metallic * sent_on(color) * metal * lobe))
    return plain, whole


def geometry(x, y):
    """Normal and direction to the eye where the middle of a pixel sees the ball, or None."""
    reach = math.tan(HALF_ANGLE)
    way = unit((reach * (2 * (x + 0.5) / SIZE - 1), -reach * (2 * (y + 0.5) / SIZE - 1), -1.0))
    eye = (0.0, 0.0, DISTANCE)
    b = dot(eye, way)
    under = b * b - (DISTANCE * DISTANCE - 1)
    if under <= 0:
        return None
    t = -b - math.sqrt(under)
    return tuple(e + t * w for e, w in zip(eye, way)), tuple(-w for w in way)


def block_means(pixels):
    """Means of the blocks that have all their pixels."""
    found = {}
    for by in range(SIZE // EDGE):
        for bx in range(SIZE // EDGE):
            block = [pixels.get((bx * EDGE + i, by * EDGE + k)) for k in range(EDGE) for i in range(EDGE)]
            if None not in block:
                found[bx, by] = [sum(pixel[c] for pixel in block) / len(block) for c in range(3)]
    return found


def compared(metallic, roughness, shares, ours, khronos, three):
    """The number of blocks, and the largest and root mean square relative difference between them: from both viewers,
    and from the one of Khronos without the additions."""
    pixels = {name: {} for name in ("ours", "without", "khronos", "three")}
    for y in range(SIZE):
        for x in range(SIZE):
            place = geometry(x, y)
            if place is None or dot(place[0], TO_LIGHT) < LEAST_COSINE:
                continue
            shown = {"ours": ours.at(x, y), "khronos": khronos.at(x, y), "three": three.at(x, y)}
            if min(pixel[3] for pixel in shown.values()) < 1:
                continue
            plain, whole = radiance(metallic, roughness, shares, *place)
            shown["without"] = [value * a / b for value, a, b in zip(shown["ours"], plain, whole)]
            for name, pixel in shown.items():
                pixels[name][x, y] = pixel
    blocks = {name: block_means(of) for name, of in pixels.items()}

    def differences(name, truth):
        values = [blocks[name][at][c] / blocks[truth][at][c] - 1 for at in blocks[truth] for c in range(3)]
        return max(map(abs, values)), math.sqrt(sum(value * value for value in values) / len(values))

    return (len(blocks["ours"]), differences("ours", "three"), differences("ours", "khronos"),
            differences("without", "khronos"))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("folder", type=pathlib.Path, help="where npm installed both viewers")
    parser.add_argument("program", type=pathlib.Path, help="opaline")
    parser.add_argument("--browser", default="chromium")
    parser.add_argument("--keep", type=pathlib.Path, help="leaves files and pictures there")
    arguments = parser.parse_args()
    packages = arguments.folder / "node_modules"
    for package in ("@khronosgroup/gltf-viewer", "three"):
        if not (packages / package / "package.json").is_file():
            sys.exit(f"gltf_viewer.py: {packages} has no {package}; see --help")
    if not shutil.which(arguments.browser):
        sys.exit(f"gltf_viewer.py: there is no browser {arguments.browser}")
    materials = [(metallic, roughness) for metallic in METALNESSES for roughness in ROUGHNESSES]
    with tempfile.TemporaryDirectory() as temporary:
        folder = arguments.keep or pathlib.Path(temporary)
        folder.mkdir(exist_ok=True)
        for i, material in enumerate(materials):
            (folder / f"ball{i}.glb").write_bytes(ball_file(*material))
        where = packages, arguments.browser, folder, len(materials)
        shown = {"khronos": khronos_pictures(*where), "three": three_pictures(*where)}
        shares = {roughness: Shares(roughness ** 2) for roughness in ROUGHNESSES}
        print("| metallic | roughness | blocks | three.js | Khronos | Khronos, without what is added |")
        print("|---|---|---|---|---|---|")
        for i, material in enumerate(materials):
            ours = our_picture(arguments.program, folder / f"ball{i}.glb")
            if arguments.keep:
                for name, pictures in shown.items():
                    (folder / f"{name}{i}.exr").write_bytes(images.write_exr(pictures[i].rows))
            count, *found = compared(*material, shares[material[1]], ours, shown["khronos"][i], shown["three"][i])
            cells = " | ".join(f"{100 * largest:.1f}, {100 * rms:.1f} %" for largest, rms in found)
            print(f"| {material[0]} | {material[1]} | {count} | {cells} |", flush=True)


if __name__ == "__main__":
    main()
