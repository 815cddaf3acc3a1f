"""A Slurm cluster of three nodes on this machine: munged, slurmctld and three slurmd, all on 127.0.0.1 and all below
one folder. In the end, exactly these are stopped, by their process ids."""

import getpass
import os
import signal
import socket
import subprocess
import sys
import time

NODES = ["n1", "n2", "n3"]

CONFIGURATION = """\
ClusterName=loop
SlurmctldHost=localhost(127.0.0.1)
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
CredType=cred/munge
AuthInfo=socket={root}/run/munge.socket
CommunicationParameters=NoCtldInAddrAny,NoInAddrAny
SlurmctldPort={ports[0]}
MailProg=/bin/true
MpiDefault=none
SwitchType=switch/none
StateSaveLocation={root}/ctld
SlurmdSpoolDir={root}/spool/%n
SlurmctldPidFile={root}/run/ctld.pid
SlurmdPidFile={root}/run/%n.pid
SlurmctldLogFile={root}/log/ctld.log
SlurmdLogFile={root}/log/%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
JobCompType=jobcomp/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerType=sched/backfill
SchedulerParameters=sched_interval=1,batch_sched_delay=0,bf_interval=1
ReturnToService=2
SlurmctldTimeout=10
SlurmdTimeout=6
MessageTimeout=4
BatchStartTimeout=4
InactiveLimit=0
KillWait=2
JobRequeue=1
SlurmdParameters=config_overrides
NodeName=n1 NodeHostname=localhost NodeAddr=127.0.0.1 Port={ports[1]} CPUs=1 RealMemory=1000 State=UNKNOWN
NodeName=n2 NodeHostname=localhost NodeAddr=127.0.0.1 Port={ports[2]} CPUs=1 RealMemory=1000 State=UNKNOWN
NodeName=n3 NodeHostname=localhost NodeAddr=127.0.0.1 Port={ports[3]} CPUs=1 RealMemory=1000 State=UNKNOWN
PartitionName=render Nodes=n[1-3] Default=YES MaxTime=INFINITE State=UP
"""


def wait_until(condition, seconds, what, meanwhile=lambda: None):
    """Waits for `condition` to be true and returns its value."""
    end = time.monotonic() + seconds
    while not (value := condition()):
        if time.monotonic() > end:
            raise TimeoutError(f"after {seconds} s there is still no {what}")
        meanwhile()
        time.sleep(0.02)
    return value


def free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for one in sockets:
        one.bind(("127.0.0.1", 0))
    ports = [one.getsockname()[1] for one in sockets]
    for one in sockets:
        one.close()
    return ports


class Process:
    """What /proc says about a process."""

    def __init__(self, pid):
        self.pid = pid
        with open(f"/proc/{pid}/cmdline", "rb") as file:
            self.words = file.read().decode(errors="replace").split("\0")
        self.parent = int(self.status()[1])

    def status(self):
        """Its state, a letter; its parent; and so on. The state is X if it is gone."""
        try:
            with open(f"/proc/{self.pid}/stat", encoding="utf-8", errors="replace") as file:
                return file.read().rpartition(")")[2].split()
        except (FileNotFoundError, ProcessLookupError):
            return ["X", "0"]

    def hold(self):
        """Stops it. False if it has ended instead."""
        self.send(signal.SIGSTOP)
        return wait_until(lambda: self.status()[0] if self.status()[0] in "TXZ" else None, 20, "stopped process") == "T"

    def send(self, number):
        try:
            os.kill(self.pid, number)
        except ProcessLookupError:
            pass


def processes():
    for name in os.listdir("/proc"):
        if name.isdigit():
            try:
                yield Process(int(name))
            except (FileNotFoundError, ProcessLookupError, PermissionError):
                pass


class LoopCluster:
    def __init__(self, root):
        self.root = root
        self.daemons = {}
        self.reports_due = None
        for folder in ["munge", "ctld", "log", "run"] + [f"spool/{node}" for node in NODES]:
            os.makedirs(f"{root}/{folder}")
        os.chmod(f"{root}/munge", 0o700)
        os.chmod(f"{root}/run", 0o711)
        with open(os.open(f"{root}/munge/key", os.O_WRONLY | os.O_CREAT, 0o600), "wb") as key:
            key.write(os.urandom(128))
        self.configuration = f"{root}/slurm.conf"
        with open(self.configuration, "w", encoding="utf-8") as file:
            file.write(CONFIGURATION.format(root=root, user=getpass.getuser(), ports=free_ports(4)))
        os.environ["SLURM_CONF"] = self.configuration

    def __enter__(self):
        try:
            self.start("munged", "munged", "--foreground", "--force", f"--key-file={self.root}/munge/key",
                       f"--socket={self.root}/run/munge.socket", f"--pid-file={self.root}/run/munged.pid",
                       f"--log-file={self.root}/log/munged.log", f"--seed-file={self.root}/munge/seed")
            wait_until(lambda: os.path.exists(f"{self.root}/run/munge.socket"), 20, "munged")
            self.start_controller()
            for node in NODES:
                self.start_node(node)
            self.wait_for_idle_nodes(len(NODES))
        except BaseException:
            self.stop()
            raise
        return self

    def __exit__(self, failure, *_):
        if failure:
            self.tell()
        self.stop()

    def tell(self):
        """Prints what Slurm reports, to help find the reason of a failure."""
        for words in [["squeue", "-r", "-o", "%i %T %r %S %N"], ["sinfo", "-N", "-o", "%N %T %E"]]:
            print(self.ask(*words), file=sys.stderr)
        with open(f"{self.root}/log/ctld.log", encoding="utf-8", errors="replace") as log:
            print(*log.readlines()[-60:], sep="", file=sys.stderr)

    def start(self, name, *words):
        log = open(f"{self.root}/log/{name}.out", "ab")
        self.daemons[name] = subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=log, stderr=log,
                                              env=os.environ | {"PATH": os.environ["PATH"] + ":/usr/sbin:/sbin"})
        log.close()

    def start_controller(self):
        self.start("slurmctld", "slurmctld", "-D", "-f", self.configuration)
        wait_until(lambda: self.ask("sinfo") is not None, 30, "answer of the controller")

    def kill_controller(self, moment):
        """Kills it once it has saved what it knew at that moment: it saves every few seconds, and forgets the rest."""
        wait_until(lambda: os.path.getmtime(f"{self.root}/ctld/job_state") > moment, 30, "saved state of the controller")
        self.kill("slurmctld")

    def restart_controller(self):
        self.start_controller()
        self.reports_due = time.monotonic() + 10  # until then, it trusts the state that it saved

    def start_node(self, node):
        self.start(node, "slurmd", "-D", "-N", node, "-f", self.configuration)

    def kill(self, name):
        self.daemons[name].kill()
        self.daemons.pop(name).wait()

    def tasks_of(self, node):
        """The shells of the tasks that run on a node, their parents, which watch over them, and their children."""
        everything = list(processes())
        shells = [p for p in everything if any(word.startswith(f"{self.root}/spool/{node}/") for word in p.words[1:2])]
        ids = {p.pid for p in shells}
        return [p for p in everything if p.parent in ids] + shells + \
               [p for p in everything if p.pid in {shell.parent for shell in shells} and "slurmstepd" in p.words[0]]

    def watchers(self):
        """The processes of Slurm that watch over tasks and may outlive both the task and its node."""
        def writes_here(process):
            try:
                folder = f"/proc/{process.pid}/fd"
                return any(os.readlink(f"{folder}/{fd}").startswith(f"{self.root}/") for fd in os.listdir(folder))
            except OSError:
                return False
        return [p for p in processes() if p.words[0].startswith("slurmstepd") and writes_here(p)]

    def kill_node(self, node):
        """Kills a node as a power cut does."""
        victims = self.tasks_of(node)
        self.kill(node)
        for process in victims:
            process.send(signal.SIGKILL)

    def declare_down(self, node):
        """Tells the controller what it would find out by itself later."""
        self.ask("scontrol", "update", f"NodeName={node}", "State=DOWN", "Reason=dead")

    def stop(self):
        subprocess.run(["scancel", "--state=PENDING"], check=False, capture_output=True, timeout=30)
        for node in NODES:
            for process in self.tasks_of(node):
                process.send(signal.SIGKILL)
        for name in reversed(list(self.daemons)):
            self.daemons[name].terminate()
            try:
                self.daemons[name].wait(timeout=10)
            except subprocess.TimeoutExpired:
                self.kill(name)
        for process in self.watchers():
            process.send(signal.SIGKILL)

    def ask(self, *words):
        """What a command of Slurm prints; None if it fails."""
        result = subprocess.run(words, capture_output=True, text=True, check=False)
        return result.stdout if result.returncode == 0 else None

    def wait_for_idle_nodes(self, count):
        wait_until(lambda: (self.ask("sinfo", "-h", "-t", "idle", "-o", "%D") or "").strip() == str(count), 60,
                   f"{count} idle nodes")

    def hurry(self):
        """Does now what Slurm does by itself within minutes. A task that is started again has to wait for two; and a
        controller that was killed learns only from the next report of a node that a task it remembers is over."""
        for line in (self.ask("squeue", "-h", "-r", "-t", "PENDING", "-o", "%i %r") or "").splitlines():
            job, reason = line.split(maxsplit=1)
            if reason == "BeginTime":
                self.ask("scontrol", "update", f"JobId={job}", "StartTime=now")
            elif "held" in reason:  # "launch failed requeued held": its node still had the forgotten task
                self.ask("scontrol", "release", job)
        for node in (self.ask("sinfo", "-h", "-N", "-t", "drain", "-o", "%N") or "").split():
            self.ask("scontrol", "update", f"NodeName={node}", "State=RESUME")
        if self.reports_due and time.monotonic() > self.reports_due:
            self.reports_due = None
            self.ask("scontrol", "reconfigure")  # all nodes report
