"""integrations/slurm/opaline-film: a film by many tasks, some of which die and some of which run twice."""

import os
import pathlib
import shutil
import signal
import subprocess
import tempfile
import unittest

import cluster

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCRIPT = ROOT / "integrations" / "slurm" / "opaline-film"
PROGRAM = pathlib.Path(os.environ["OPALINE"]).resolve()
HAVE_FFMPEG = shutil.which("ffmpeg") is not None
SCENE = ("--builtin", "teapot", "--shadow-size", "64", "--transport", "dipole", "--max-surfels", "1024", "--fov-degrees", "50",
         "--size", "64x48", "--antialias", "1", "--deform", "twist:0.5:1.5", "--clip", "none")


class Films(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def film(self, *arguments, environment=None, folder=None, scene=SCENE):
        return subprocess.run([SCRIPT, *arguments, "--", *scene], cwd=folder or self.folder, capture_output=True, text=True,
                              check=False, env={**os.environ, **(environment or {}), "OPALINE": str(PROGRAM)})

    def pictures(self, folder):
        return {path.name: path.read_bytes() for path in sorted((self.folder / folder).glob("frame_*.png"))}

    def expect_whole(self, folder, frames):
        """The pictures are those of one process."""
        subprocess.run([PROGRAM, "render", *SCENE, "--frames", f"0:{frames - 1}", "--quiet", "-o", self.folder / "alone_%04d.png"],
                       check=True)
        alone = {path.name.replace("alone", "frame"): path.read_bytes() for path in self.folder.glob("alone_*.png")}
        self.assertEqual(len(alone), frames)
        self.assertEqual(self.pictures(folder), alone)


@unittest.skipIf(cluster.missing(), cluster.missing())
@unittest.skipUnless(HAVE_FFMPEG, "ffmpeg is not installed")
class Slurm(Films):
    FRAMES, CHUNKS, SECONDS_TO_MISS = 60, 6, 300

    def setUp(self):
        super().setUp()
        (self.folder / "slurm").mkdir()
        self.cluster = cluster.Cluster(self.folder / "slurm", self.CHUNKS, self.SECONDS_TO_MISS)
        self.addCleanup(self.cluster.stop)
        self.cluster.start()

    def processes_of(self, task):
        """The renderers of a task."""
        wanted = f"SLURM_ARRAY_TASK_ID={task}".encode()
        return [process for process, environment, words in self.cluster.processes() if wanted in environment and b"render" in words]

    def kill(self, task):
        self.cluster.wait_for(lambda: self.processes_of(task))
        for process in self.processes_of(task):
            os.kill(process, signal.SIGKILL)

    def expect_film(self):
        self.cluster.wait_for(lambda: (self.folder / "film.mp4").exists(), 300)
        self.expect_whole("frames", self.FRAMES)
        self.assertEqual(len(list(self.folder.glob("frames/.opaline*"))), 0)


class KilledTasks(Slurm):
    def test_killed_and_doubled_tasks(self):
        done = self.film("--frames", f"0:{self.FRAMES - 1}", "--chunks", str(self.CHUNKS), environment=self.cluster.environment)
        self.assertEqual(done.returncode, 0, done.stderr)
        first = done.stdout.split()[2].split(":")[0]
        self.kill(2)
        self.cluster.wait_for(lambda: self.processes_of(5))
        self.cluster.run("scancel", f"{first}_5", check=True)
        # The third once more beside itself.
        self.cluster.run("sbatch", "--array=3", "--output=/dev/null", self.folder / "frames" / "chunk.sh", check=True)
        self.expect_film()
        states = self.cluster.states()
        ended_badly = sum(state in ("FAILED", "CANCELLED") for task, state in states.items() if task.startswith(first + "_"))
        self.assertEqual(ended_badly, 2, states)


class LostNode(Slurm):
    SECONDS_TO_MISS = 9

    def test_a_lost_node(self):
        done = self.film("--frames", f"0:{self.FRAMES - 1}", "--chunks", str(self.CHUNKS), environment=self.cluster.environment)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.cluster.wait_for(lambda: self.processes_of(4))
        first = done.stdout.split()[2].split(":")[0]
        self.cluster.lose_node()
        # Slurm would begin again after two minutes. Before that the node refuses tasks it had, and the next round makes their frames.
        self.cluster.wait_for(lambda: "PENDING" in self.cluster.states().get(f"{first}_4", ""))
        self.cluster.run("scontrol", "update", f"JobId={first}", "StartTime=now", check=True)
        self.expect_film()


class Ssh(Films):
    def fake_ssh(self, script):
        """Machines that are this one."""
        tools = self.folder / "tools"
        tools.mkdir()
        (tools / "ssh").write_text("#!/bin/bash\nshift 2\nhost=$1\n" + script + '\nexec bash -c "$2"\n')
        (tools / "ssh").chmod(0o755)
        return {"PATH": f"{tools}:{os.environ['PATH']}"}

    @unittest.skipUnless(HAVE_FFMPEG, "ffmpeg is not installed")
    def test_a_host_that_is_down(self):
        environment = self.fake_ssh('if [ "$host" = down ]; then echo "no route" >&2; exit 255; fi')
        done = self.film("--frames", "0:8", "--chunks", "4", "--ssh", "here down there", "-o", "a film.mp4", environment=environment)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertGreater((self.folder / "a film.mp4").stat().st_size, 0)
        self.expect_whole("frames", 9)

    @unittest.skipUnless(HAVE_FFMPEG, "ffmpeg is not installed")
    def test_the_reference_makes_films_too(self):
        scene = ("reference", "--builtin", "teapot", "--size", "8x6", "--integral", "--tolerance", ".3", "--deform", "twist:0.5:1.5")
        done = self.film("--frames", "0:2", "--ssh", "here there", scene=scene, environment=self.fake_ssh(""))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(len(self.pictures("frames")), 3)
        self.assertIn(b'"integral"', self.pictures("frames")["frame_0001.png"], "its stamp")

    def test_when_nothing_helps_what_is_missing_is_counted(self):
        done = self.film("--frames", "0:3", "--ssh", "down", environment=self.fake_ssh("exit 255"))
        self.assertEqual(done.returncode, 1)
        self.assertIn("frame_%04d.png", done.stderr)
        self.assertFalse((self.folder / "film.mp4").exists())

    def test_refusals(self):
        for arguments, says in (((), "--frames A:B"), (("--frames", "0:1", "--chunks", "0"), "--chunks 0"),
                                (("--frames",), "needs a value"), (("--size", "8x8"), "after --")):
            done = subprocess.run([SCRIPT, *arguments], cwd=self.folder, capture_output=True, text=True, check=False,
                                  env={**os.environ, "OPALINE": str(PROGRAM)})
            self.assertEqual(done.returncode, 2, arguments)
            self.assertIn(says, done.stderr)


if __name__ == "__main__":
    unittest.main()
