#!/usr/bin/env python3
"""Lets nothing of a test outlive it, neither a process nor a temporary file, however it ends.

    keeper.py COMMAND [ARGUMENT ...]      what a script does by itself that calls kept()

A test that is killed cannot tidy up. So it runs in a grandchild of the process that was called. Between them is its keeper:
in a session of its own, where what kills a whole group of processes does not meet it, and a subreaper, to which all comes
that the test has started, daemons that left their parents included. When the test ends, or the process that was called, the
keeper kills all that is left and removes the folder that the test had for temporary files. If the keeper is killed, the
test does so.
"""

import ctypes
import os
import shutil
import signal
import stat
import subprocess
import sys
import tempfile
import traceback
from pathlib import Path

import waiting

PR_SET_PDEATHSIG, PR_SET_CHILD_SUBREAPER = 1, 36
ENDING = {signal.SIGTERM, signal.SIGINT, signal.SIGHUP}


def kept(test):
    """Call a function in a process of its own; when that has ended, however it ended, end all that is left of it.

    To be called before there are threads. @return the exit code of the function: what it returns or gives to sys.exit()
    """
    called = os.getpid()
    signal.signal(signal.SIGCHLD, signal.SIG_DFL)  # who ignores it is not told of the end of a child
    mask = signal.pthread_sigmask(signal.SIG_BLOCK, {*ENDING, signal.SIGCHLD})
    sys.stdout.flush()
    sys.stderr.flush()
    keeper = os.fork()
    if keeper == 0:
        code = 1
        try:
            code = _keep(test, called, mask)
        except OSError:
            traceback.print_exc()
        finally:
            os._exit(code)
    while True:
        if signal.sigwait({*ENDING, signal.SIGCHLD}) != signal.SIGCHLD:
            os.kill(keeper, signal.SIGTERM)
        if (code := reap().get(keeper)) is not None:
            signal.pthread_sigmask(signal.SIG_SETMASK, mask)
            return _exit_code(code)


def _keep(test, called, mask):
    """In the keeper. @return the exit code"""
    os.setsid()
    _ends_with(called)
    process_control(PR_SET_CHILD_SUBREAPER, 1)
    folder = Path(tempfile.mkdtemp(prefix="ljmd-test-"))
    folder.chmod(0o711)  # below it, a test may have a folder for everybody
    keeper = os.getpid()
    child = os.fork()
    if child == 0:
        _be_tested(test, folder, mask, keeper)
    code = None
    while code is None:
        if signal.sigwait({*ENDING, signal.SIGCHLD}) != signal.SIGCHLD:
            code = 128 + signal.SIGTERM
        else:
            code = reap().get(child)
    end_all(folder)
    return _exit_code(code)


def _be_tested(test, folder, mask, keeper):
    """In the process of the test."""
    def ended(*_):  # without unwinding, which might wait for a program that has no end
        end_all(folder)
        os._exit(128 + signal.SIGTERM)

    process_control(PR_SET_CHILD_SUBREAPER, 1)
    signal.signal(signal.SIGTERM, ended)
    _ends_with(keeper)
    signal.pthread_sigmask(signal.SIG_SETMASK, mask - {signal.SIGTERM})
    os.environ["TMPDIR"] = tempfile.tempdir = str(folder)
    code = 1
    try:
        code = test()
    except SystemExit as end:
        code = end.code
        if isinstance(code, str):
            print(code, file=sys.stderr)
    except BaseException:  # as at the end of any script
        traceback.print_exc()
    finally:
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(code if isinstance(code, int) else 0 if code is None else 1)


def _ends_with(parent):
    """Let this process get SIGTERM when its parent has ended."""
    process_control(PR_SET_PDEATHSIG, signal.SIGTERM)
    if os.getppid() != parent:  # it has ended before
        os.kill(os.getpid(), signal.SIGTERM)


def _exit_code(code):
    """Of a process whose end Python tells as -N if signal N was it, as a shell tells it."""
    return code if code >= 0 else 128 - code


def process_control(option, value):
    ctypes.CDLL(None, use_errno=True).prctl(option, value, 0, 0, 0)


def descendants(pid):
    """Processes below a process, zombies excepted."""
    parents = {}
    for status in Path("/proc").glob("[0-9]*/stat"):
        try:
            fields = status.read_text().rpartition(")")[2].split()
        except OSError:  # it has ended
            continue
        if fields[0] != "Z":
            parents[int(status.parent.name)] = int(fields[1])
    found, new = set(), {pid}
    while new:
        new = {child for child, parent in parents.items() if parent in new and child not in found}
        found |= new
    return found


def end_all(folder):
    """Kill all processes below this one, and those that come to it meanwhile, until there is none; remove the folder."""
    def all_gone():
        victims = descendants(os.getpid())
        for victim in victims:
            try:
                os.kill(victim, signal.SIGKILL)
            except ProcessLookupError:
                pass
        reap()
        return not victims

    waiting.until(all_gone, "the processes of the test are killed")
    make_writable(folder)
    shutil.rmtree(folder, ignore_errors=True)


def make_writable(folder):
    """Let all folders below one be removed: tests leave some that may not be written to, and paths too long to be named."""
    for _, names, _, descriptor in os.fwalk(folder):
        for name in names:
            if not stat.S_ISLNK(os.stat(name, dir_fd=descriptor, follow_symlinks=False).st_mode):
                os.chmod(name, 0o700, dir_fd=descriptor)


def reap():
    """@return exit codes of the children that have ended, by their numbers"""
    codes = {}
    try:
        while (found := os.waitpid(-1, os.WNOHANG)) != (0, 0):
            codes[found[0]] = os.waitstatus_to_exitcode(found[1])
    except ChildProcessError:
        pass
    return codes


def main():
    if len(sys.argv) < 2:
        print(__doc__)
        return 2
    return kept(lambda: _exit_code(subprocess.run(sys.argv[1:], check=False).returncode))


if __name__ == "__main__":
    sys.exit(main())
