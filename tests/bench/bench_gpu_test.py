"""Figures of a GPU are only taken on one; what was measured arrives in the report."""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

BENCH = pathlib.Path(__file__).resolve().parents[2] / "bench"
sys.path.insert(0, str(BENCH))

import bench_gpu

SOFTWARE = {"index": 0, "name": "llvmpipe", "type": "software", "driver": "Mesa"}
INTEGRATED = {"index": 1, "name": "Small One", "type": "integrated", "driver": "1.2"}
DISCRETE = {"index": 2, "name": "Large One", "type": "discrete", "driver": "3.4"}

FRAME_ROW = {"site": "fragment", "sources": 7, "frame_ms": 1.25, "opaque_frames": 2.5, "papers": 0.75,
             "passes_ms": {"gather": .25, "estimate": .125, "scatter": .25}}
FRAME = {"scene": "bunny", "lighting": "lit from behind", "device": DISCRETE, "size": [1024, 1024], "opaque_ms": .5,
         "rows": [{"way": way, **FRAME_ROW} for way in ("paper fragment", "tree auto", "tree fragment")]}
FRAMES = {"ways": [FRAME],
          "defaults": [{"scene": "walker", "medium": "jade", "rows": [
              {"passes_ms": {"solve": .625}, "frame_ms": 1.875, "opaque_frames": 4.5, "dispatches": 221, "barriers": 251}]}]}
MOTION = {"rows": [{"motion": "skin", "frame_ms": 2, "ratio": 1.0625, "allowed": 1.1}]}
SCALING_ROW = {"surfels": 9, "gather_ms": 1, "scatter_ms": 2, "nearby_ms": 0, "frame_ms": 3, "scatter_ratio": 1,
               "frame_ratio": 1, "evaluations": 111.5}
SCALING = {"scene": "bear", "size": [1024, 1024],
           "surfels": {"rows": [{"max_surfels": 65536, "scatter_growth_per_doubling": None, **SCALING_ROW}]},
           "sigma_tr": {"rows": [{"divisor": 100, **SCALING_ROW}]},
           "tolerance": {"rows": [{"tolerance": .003, "rel_rmse": .00125, **SCALING_ROW}]}}
TABLE1 = {"rows": [{"data": "Teapot", "ftf_fps": 1, "vtf_fps": 2, "tree_fps": 345.5}]}

# Answers as the programs would.
STAND_IN = """#!{python}
import json, sys
asked = " ".join(sys.argv)
answers = json.loads({answers!r})
print(json.dumps(next(answer for words, answer in answers.items() if words in asked)))
"""


class BenchGpu(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def run_with(self, devices, *options, models=()):
        answers = {"opaline info": {"devices": devices}, "bench table1": TABLE1, "bench scaling": SCALING,
                   "frame_bench": FRAMES, "motion_bench": MOTION}
        for name in ("opaline", "opaline_frame_bench", "opaline_motion_bench"):
            program = self.folder / name
            program.write_text(STAND_IN.format(python=sys.executable, answers=json.dumps(answers)))
            program.chmod(0o755)
        for name in models:
            (self.folder / name).write_text("")
        return subprocess.run([sys.executable, BENCH / "bench_gpu.py", self.folder, self.folder, *options],
                              env={**os.environ, "OPALINE_MODELS": str(self.folder)}, capture_output=True, text=True,
                              check=False)

    def test_refuses_a_software_device(self):
        for devices in ([SOFTWARE], []):
            done = self.run_with(devices)
            self.assertEqual(done.returncode, 1)
            self.assertIn("there is no GPU", done.stderr)
            self.assertFalse((self.folder / "bench_gpu.json").exists())
        self.assertIn("Large", self.run_with([SOFTWARE, INTEGRATED], "--device", "Large").stderr)

    def test_chooses_the_fastest_kind_or_the_one_asked_for(self):
        everything = [SOFTWARE, INTEGRATED, DISCRETE]
        self.assertEqual(bench_gpu.choose(everything, ""), DISCRETE)
        self.assertEqual(bench_gpu.choose(everything, "small"), INTEGRATED)
        self.assertEqual(bench_gpu.choose(everything, "1"), INTEGRATED)
        self.assertIsNone(bench_gpu.choose(everything, "llvmpipe"))

    def test_writes_all_figures(self):
        done = self.run_with([SOFTWARE, DISCRETE], models=bench_gpu.TABLE1_MODELS)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stderr.count("--device 2"), 4)
        figures = json.loads((self.folder / "bench_gpu.json").read_text())
        self.assertEqual(figures["device"], DISCRETE)
        self.assertEqual((figures["frames"], figures["motion"], figures["scaling"], figures["table1"]),
                         (FRAMES, MOTION, SCALING, TABLE1))
        text = (self.folder / "bench_gpu.md").read_text()
        for part in ("Large One", "3.4", "measured 0.375 ms", "measured 1.250 ms", "walker, jade", "0.625", "1.875", "4.50", "221, 251", "1.062", "0.125 %", "345.5"):
            self.assertIn(part, text)

    def test_does_without_the_models(self):
        done = self.run_with([DISCRETE])
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("without Table 1", done.stderr)
        self.assertIsNone(json.loads((self.folder / "bench_gpu.json").read_text())["table1"])


if __name__ == "__main__":
    unittest.main()
