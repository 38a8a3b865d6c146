"""The machine that benchmarks run on, as it is written into their records, and the other work on it."""

from __future__ import annotations

import os
import platform
import re
import resource
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any

SIMD_FLAGS = ("sse2", "sse4_1", "sse4_2", "avx", "avx2", "fma", "avx512f", "avx512dq", "avx512vl", "asimd", "sve")


def cpu(text: str) -> dict[str, Any]:
    """Name of the processor and its instructions for vectors, from the text of /proc/cpuinfo."""
    name = re.search(r"^model name\s*: (.*)", text, re.M)
    flags = re.search(r"^(?:flags|Features)\s*: (.*)", text, re.M)
    has = set(flags.group(1).split()) if flags else set()
    return {"cpu": name.group(1).strip() if name else platform.machine(),
            "simd": [flag for flag in SIMD_FLAGS if flag in has]}


def cores() -> int:
    """Cores that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def describe() -> dict[str, Any]:
    information = Path("/proc/cpuinfo")
    text = information.read_text(errors="replace") if information.exists() else ""
    memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    return {**cpu(text), "cores": cores(), "memory_bytes": memory, "system": platform.platform(),
            "load_average": os.getloadavg()[0]}


def busy_seconds(text: str) -> float:
    """Seconds that all cores together have worked, from the text of /proc/stat; 0 without it."""
    first = re.match(r"cpu +(.*)", text)
    if not first:
        return 0.0
    user, nice, system, _idle, _waiting, interrupt, soft_interrupt, stolen = map(int, first.group(1).split()[:8])
    return (user + nice + system + interrupt + soft_interrupt + stolen) / os.sysconf("SC_CLK_TCK")


CROWDED = 0.2  # cores that a run may lack before its rate says little


@dataclass(frozen=True)
class Use:
    """What this process' children have used, and what others have meanwhile."""

    wall_seconds: float
    processor_seconds: float  # of all threads and processes of the children
    other_work: float  # mean number of cores busy with something else

    def is_crowded(self, threads: int, available: int) -> bool:
        """Whether others took a part of the cores that a run with that many threads wanted."""
        return threads + self.other_work > available + CROWDED


class Watch:
    """Watches the cores from when it is made."""

    def __init__(self) -> None:
        self.start = self.now()

    @staticmethod
    def now() -> tuple[float, float, float]:
        statistics = Path("/proc/stat")
        usage = resource.getrusage(resource.RUSAGE_CHILDREN)
        busy = busy_seconds(statistics.read_text()) if statistics.exists() else 0.0
        return time.monotonic(), busy, usage.ru_utime + usage.ru_stime

    def use(self) -> Use:
        elapsed, busy, own = (after - before for before, after in zip(self.start, self.now()))
        return Use(elapsed, own, max(0.0, (busy - own) / elapsed) if elapsed > 0.0 else 0.0)


def share_cores() -> None:
    """Let all programs that are started from now on give up a core while they wait for other threads or processes.

    As a rule they keep it, which is fastest on a machine of their own. Where there is other work, the one that is
    waited for may be without a core all that time, and the whole program slower by a factor of ten.
    """
    os.environ["OMP_WAIT_POLICY"] = "passive"
    os.environ["OMPI_MCA_mpi_yield_when_idle"] = "1"


def wait_for_idle(needed: int, limit: float) -> None:
    """Return once other work leaves `needed` cores idle, or after `limit` seconds."""
    deadline = time.monotonic() + limit
    while time.monotonic() < deadline:
        watch = Watch()
        time.sleep(1.0)
        if not watch.use().is_crowded(needed, cores()):
            return
