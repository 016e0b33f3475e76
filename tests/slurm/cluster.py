"""A cluster of one machine: real daemons of Slurm and MUNGE, with files of their own in a folder."""

import os
import pathlib
import secrets
import shutil
import signal
import socket
import subprocess
import time

PROGRAMS = ("slurmctld", "slurmd", "munged", "sbatch", "scancel", "squeue", "sinfo")
SEARCHED = os.environ["PATH"] + ":/usr/sbin:/sbin"


def missing():
    """Why there can be no cluster; empty where there can."""
    absent = [name for name in PROGRAMS if shutil.which(name, path=SEARCHED) is None]
    if absent:
        return f"Slurm is not installed: there is no {absent[0]}"
    return "" if os.geteuid() == 0 else "slurmd is started by root alone"


def free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for each in sockets:
        each.bind(("127.0.0.1", 0))
    ports = [each.getsockname()[1] for each in sockets]
    for each in sockets:
        each.close()
    return ports


class Cluster:
    """Has so many places for tasks at once. A node that is silent for `seconds_to_miss` counts as lost."""

    def __init__(self, folder, places, seconds_to_miss=300):
        self.folder = pathlib.Path(folder)
        self._processes = []
        self._started = []
        for name in ("state", "spool"):
            (self.folder / name).mkdir()
        self.folder.chmod(0o755)
        (self.folder / "key").write_bytes(secrets.token_bytes(128))
        (self.folder / "key").chmod(0o600)
        self.environment = {**os.environ, "PATH": SEARCHED, "SLURM_CONF": str(self.folder / "slurm.conf")}
        self._write_configuration(places, seconds_to_miss)

    def _write_configuration(self, places, seconds_to_miss):
        ctld, d = free_ports(2)
        host = socket.gethostname().split(".")[0]
        (self.folder / "slurm.conf").write_text(f"""
ClusterName=test
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={ctld}
SlurmdPort={d}
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket={self.folder}/munge
CryptoType=crypto/munge
CredType=cred/munge
StateSaveLocation={self.folder}/state
SlurmdSpoolDir={self.folder}/spool
SlurmctldPidFile={self.folder}/slurmctld.pid
SlurmdPidFile={self.folder}/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_interval=1,sched_min_interval=0,batch_sched_delay=0,bf_interval=1
KillWait=1
SlurmdTimeout={seconds_to_miss}
MinJobAge=300
ReturnToService=2
SlurmdParameters=config_overrides
NodeName={host} NodeAddr=127.0.0.1 CPUs={places}
PartitionName=all Nodes={host} Default=YES MaxTime=INFINITE State=UP
""")

    def _start(self, name, *arguments):
        log = open(self.folder / f"{name}.log", "wb")
        self._processes.append(subprocess.Popen([shutil.which(name, path=SEARCHED), *arguments], stdout=log,
                                                stderr=subprocess.STDOUT, env=self.environment))
        log.close()

    def start(self):
        self._start("munged", "--foreground", "--force", f"--key-file={self.folder}/key", f"--socket={self.folder}/munge",
                    f"--pid-file={self.folder}/munged.pid", f"--seed-file={self.folder}/seed", "--log-file=" + str(self.folder / "munged.txt"))
        self.wait_for(lambda: (self.folder / "munge").exists())
        self._start("slurmctld", "-D", "-i")
        self._start("slurmd", "-D")
        self.wait_for(lambda: "idle" in self.run("sinfo", "--noheader", "--format=%t").stdout)

    def run(self, *words, check=False, **keywords):
        return subprocess.run([shutil.which(words[0], path=SEARCHED) or words[0], *map(str, words[1:])], env=self.environment,
                              capture_output=True, text=True, check=check, **keywords)

    def wait_for(self, what, longest=120):
        deadline = time.monotonic() + longest
        while not what():
            if time.monotonic() > deadline:
                logs = {name.name: name.read_text(errors="replace")[-2000:] for name in self.folder.glob("*.log")}
                raise AssertionError(f"the cluster is not ready: {logs}")
            time.sleep(0.1)

    def states(self):
        """Of all tasks, by job and task: '7_3' -> 'RUNNING'."""
        lines = self.run("squeue", "--noheader", "--array", "--states=all", "--format=%i %T").stdout.split("\n")
        return dict(line.split() for line in lines if line.strip())

    def processes(self):
        """Whatever runs with the cluster's configuration, but for this process: (number, environment, words)."""
        ours = f"SLURM_CONF={self.folder}/slurm.conf".encode()
        for entry in pathlib.Path("/proc").iterdir():
            if not entry.name.isdigit() or int(entry.name) == os.getpid():
                continue
            try:
                environment = (entry / "environ").read_bytes().split(b"\0")
                if ours in environment:
                    yield int(entry.name), environment, (entry / "cmdline").read_bytes().split(b"\0")
            except OSError:
                continue

    def lose_node(self):
        """As by a loss of power: the daemon and all tasks are gone at once, until the controller has seen it."""
        node = self._processes.pop()
        kept = {process.pid for process in self._processes}
        lost = [process for process, _, _ in self.processes() if process not in kept]
        for number in (signal.SIGSTOP, signal.SIGKILL):  # nobody is there to tell of another's end
            for process in lost:
                os.kill(process, number)
        node.wait()
        self.wait_for(lambda: "down" in self.run("sinfo", "--noheader", "--format=%t").stdout)
        self._start("slurmd", "-D")

    def stop(self):
        for process in reversed(self._processes):
            process.terminate()
        for process in reversed(self._processes):
            try:
                process.wait(10)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
