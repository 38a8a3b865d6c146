#!/usr/bin/env python3
"""Ends a test of the made-up kind in all ways that there are, and looks whether tests/keeper.py lets something of it live on.

Usage: keeper_test.py

The test has started a daemon that is deaf to signals, in a session of its own and with a parent that has ended, and has left
a folder for temporary files that may not be written to, in which paths are longer than the system takes. Prints "N passed, M failed". Exit code 1 when something failed.
"""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

import keeper  # noqa: E402
import waiting  # noqa: E402

DAEMON = "(trap '' HUP INT QUIT TERM; setsid tail -f /dev/null & setsid tail -f /dev/null) & exit 0"
ENDS = {"returns": 7, "words": 1, "raises": 1, "test": 128 + signal.SIGKILL, "keeper": 128 + signal.SIGKILL, "called": -signal.SIGKILL,
        "group": -signal.SIGKILL, "told": 128 + signal.SIGTERM, "interrupted": 128 + signal.SIGTERM}

LONG = "d" * 200


def name_of(pid: int) -> str:
    try:
        return Path(f"/proc/{pid}/comm").read_text(encoding="utf-8").strip()
    except OSError:  # it has ended
        return ""


def made_up_test(end: str) -> int:
    folder = Path(tempfile.gettempdir())
    (folder / "inner/innermost").mkdir(parents=True)
    depth = os.open(folder / "inner/innermost", os.O_RDONLY)
    for _ in range(1 + os.pathconf(folder, "PC_PATH_MAX") // len(LONG)):
        os.mkdir(LONG, dir_fd=depth)
        parent, depth = depth, os.open(LONG, os.O_RDONLY, dir_fd=depth)
        os.fchmod(parent, 0o555)
        os.close(parent)
    (folder / "inner").chmod(0)
    subprocess.run(["/bin/sh", "-c", DAEMON], check=True)
    waiting.until(lambda: [name_of(pid) for pid in keeper.descendants(os.getpid())].count("tail") == 2, "two daemons")
    print(os.getpid(), os.getppid(), folder, flush=True)
    if end == "raises":
        raise ValueError("as it is meant to")
    if end == "words":
        sys.exit("as it is meant to")
    while end != "returns":
        signal.pause()
    return ENDS["returns"]


def left_by(end: str) -> str:
    """What is wrong after an end of this kind; empty if nothing is."""
    command = [sys.executable, __file__, end]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, start_new_session=True) as process:
        test, kept_by, folder = process.stdout.readline().split()
        if end == "group":
            os.killpg(process.pid, signal.SIGKILL)
        elif end == "interrupted":
            os.killpg(process.pid, signal.SIGINT)
        elif end in ("test", "keeper", "called", "told"):
            victim = {"test": int(test), "keeper": int(kept_by)}.get(end, process.pid)
            os.kill(victim, signal.SIGTERM if end == "told" else signal.SIGKILL)
        process.stdout.read()  # till its end, which comes when all have ended that had it
        code = process.wait(waiting.PATIENCE)
    if Path(folder).exists():
        return "its folder is left"
    return "" if code == ENDS[end] else f"exit code {code}, expected {ENDS[end]}"


def main() -> int:
    failed = 0
    for end in ENDS:
        if wrong := left_by(end):
            failed += 1
            print(f"FAILED {end}: {wrong}")
    print(f"{len(ENDS) - failed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(keeper.kept(lambda: made_up_test(sys.argv[1])) if len(sys.argv) > 1 else main())
