"""How a test waits: for something that a program does, never for a time that should be long enough.

A machine may be ten times faster or slower, or busy. So what a test waits for is seen (a file, a row, a state of a process),
a program that is to be interrupted cannot end by itself, and no result depends on how long something took.
"""

import os
import pathlib
import time

PATIENCE = 900  # seconds after which a test says what never came: far more than anything takes anywhere


def until(condition, what, process=None):
    """The value of a condition, once it has a true one.

    what: what is waited for, in words. process: a Popen that is to bring it about; it is an error if it ends without.
    """
    end = time.monotonic() + PATIENCE
    while True:
        ended = process is not None and process.poll() is not None  # asked first: what it did last counts
        if found := condition():
            return found
        if ended:
            raise ChildProcessError(f"the program ended with {process.returncode} before: {what}")
        if time.monotonic() > end:
            raise TimeoutError(f"never: {what}")
        time.sleep(0.002)


def _stat(pid):
    """State of a process, and its processor time [s]."""
    fields = pathlib.Path(f"/proc/{pid}/stat").read_text(encoding="ascii").rpartition(")")[2].split()
    return fields[0], (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def is_alive(pid):
    """Whether a process runs or waits."""
    try:
        return _stat(pid)[0] not in "ZX"
    except OSError:
        return False


def until_stopped(process):
    """Until SIGSTOP has stopped it."""
    until(lambda: _stat(process.pid)[0] in "TZ", "the process is stopped")


def until_used(process, seconds):
    """Until it has used so much processor time, which tells how far it is on a machine of any speed and load."""
    until(lambda: _stat(process.pid)[1] >= seconds or _stat(process.pid)[0] == "Z", f"{seconds:.3g} s of processor time", process)
