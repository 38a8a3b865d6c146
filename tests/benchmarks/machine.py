"""The machine that benchmarks run on, as it is written into their records."""

from __future__ import annotations

import os
import platform
import re
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
