"""A Slurm of its own for a test: munged, slurmctld and two slurmd on 127.0.0.1, in a temporary directory, as whoever runs
the test, root or not, and without systemd. Ports and sockets are its own, so that it does not meet a Slurm of the computer or
another copy of the test.

All that it starts, jobs included, ends with the test, however that ends, if it is run by keeper.kept().
"""

import os
import pwd
import shutil
import socket
import subprocess
from pathlib import Path

import waiting

PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch", "squeue", "scancel", "scontrol")

CONFIGURATION = """\
ClusterName=ljmd
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={ports[0]}
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
CredType=cred/munge
AuthInfo=socket={directory}/munge/socket
StateSaveLocation={directory}/state
SlurmdSpoolDir={directory}/spool/%n
SlurmctldPidFile={directory}/run/slurmctld.pid
SlurmdPidFile={directory}/run/%n.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
JobCompType=jobcomp/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
MpiDefault=none
SwitchType=switch/none
ReturnToService=2
SlurmctldTimeout=300
SlurmdTimeout=3600
SchedulerParameters=sched_interval=2,batch_sched_delay=1
NodeName=n1 NodeHostname={host} NodeAddr=127.0.0.1 Port={ports[1]} CPUs=1 State=UNKNOWN
NodeName=n2 NodeHostname={host} NodeAddr=127.0.0.1 Port={ports[2]} CPUs=1 State=UNKNOWN
PartitionName=all Nodes=n[1-2] Default=YES MaxTime=INFINITE State=UP
"""


def find(program):
    """Path of a program; daemons are in sbin, which is not in every PATH. None without it."""
    return shutil.which(program, path=os.environ.get("PATH", "/usr/bin:/bin") + ":/usr/sbin:/sbin:/usr/local/sbin")


def missing():
    """What a cluster needs and this computer lacks; None if nothing."""
    return next((program for program in PROGRAMS if not find(program)), None)


def nameless():
    """What no package brings; None if nothing is missing."""
    try:
        socket.getaddrinfo(socket.gethostname(), None)  # Slurm's daemons look it up, and would try again and again
    except OSError as error:
        return f"address of the name of this computer, '{socket.gethostname()}' ({error}); an entry in /etc/hosts is enough"
    return None


class Cluster:
    """The daemons, and the commands of Slurm against them."""

    def __init__(self, directory):
        self.directory = Path(directory)
        self.environment = {**{key: value for key, value in os.environ.items()
                               if not key.startswith(("SLURM", "SBATCH", "SQUEUE", "SCANCEL"))},
                            "SLURM_CONF": str(self.directory / "slurm.conf"), "PATH": os.environ.get("PATH", "") + ":/usr/bin:/usr/sbin"}
        for name in ("munge", "state", "spool/n1", "spool/n2", "run", "log"):
            (self.directory / name).mkdir(parents=True)
        (self.directory / "munge").chmod(0o711)
        self.processes = {}
        key = self.directory / "munge/key"
        key.write_bytes(os.urandom(1024))
        key.chmod(0o400)
        self._start_munge()
        self._configure()
        self.start_controller()
        for node in ("n1", "n2"):
            self.start_node(node)
        waiting.until(lambda: self.node_states() == {"n1": "idle", "n2": "idle"}, "both nodes are idle")

    def _configure(self):
        """Free ports: each is held until all are known."""
        sockets = [socket.socket() for _ in range(3)]
        for one in sockets:
            one.bind(("127.0.0.1", 0))
        ports = [one.getsockname()[1] for one in sockets]
        for one in sockets:
            one.close()
        text = CONFIGURATION.format(host=socket.gethostname().split(".")[0], directory=self.directory, ports=ports,
                                    user=pwd.getpwuid(os.geteuid()).pw_name)
        (self.directory / "slurm.conf").write_text(text, encoding="utf-8")

    def _start(self, name, *command):
        with open(self.directory / "log" / f"{name}.out", "ab") as output:
            self.processes[name] = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=output, stderr=output,
                                                    env=self.environment, cwd=self.directory, start_new_session=True)

    def _start_munge(self):
        munge = self.directory / "munge"
        self._start("munged", find("munged"), "--foreground", "--force", f"--socket={munge}/socket", f"--key-file={munge}/key",
                    f"--pid-file={munge}/pid", f"--log-file={munge}/log", f"--seed-file={munge}/seed", "--num-threads=2")
        waiting.until(lambda: (munge / "socket").exists() or self.ended("munged"), "munged listens")

    def ended(self, name):
        if (code := self.processes[name].poll()) is not None:
            raise OSError(f"{name} has ended with {code}:\n{self.log(name)}")
        return False

    def log(self, name):
        """The end of what a daemon has said."""
        return (self.directory / "log" / f"{name}.out").read_text(errors="replace")[-3000:]

    def start_controller(self):
        self._start("slurmctld", find("slurmctld"), "-D", "-f", self.environment["SLURM_CONF"])
        waiting.until(lambda: self.ended("slurmctld") or self.command("scontrol", "ping", check=False).returncode == 0,
                   "slurmctld answers")

    def start_node(self, node):
        self._start(node, find("slurmd"), "-D", "-N", node, "-f", self.environment["SLURM_CONF"])

    def kill(self, name):
        """SIGKILL to a daemon."""
        self.processes[name].kill()
        self.processes[name].wait()

    def command(self, *words, check=True, **options):
        options = {"cwd": self.directory, "env": self.environment, "capture_output": True, "text": True,
                   "timeout": waiting.PATIENCE, "stdin": subprocess.DEVNULL, **options}
        return subprocess.run([find(words[0]), *map(str, words[1:])], check=check, **options)

    def node_states(self):
        found = self.command("sinfo", "--noheader", "--Node", "--format=%N %t", check=False).stdout.split()
        return dict(zip(found[::2], found[1::2]))

    def tasks(self):
        """Tasks in the queue, and their states."""
        done = self.command("squeue", "--noheader", "--array", "--format=%A_%a %T", check=False)
        return None if done.returncode != 0 else done.stdout.splitlines()

    def wait_until_saved(self):
        """Until the controller has written what it knows now, so that it finds it again when it was killed."""
        state = self.directory / "state/job_state"
        now = self.directory / "now"
        now.touch()
        waiting.until(lambda: state.exists() and state.stat().st_mtime_ns > now.stat().st_mtime_ns, "the controller has saved its state")

    def wait_for_tasks(self):
        """Until none is in the queue."""
        waiting.until(lambda: self.tasks() == [], "no task is in the queue")
