"""The program ljmd, where a script asks it for something: LJMD_PROGRAM, which `ljmd plot` sets, else the release build,
else the one on PATH."""

from __future__ import annotations

import json
import os
import subprocess
from pathlib import Path
from typing import Any, Optional

RELEASE = Path(__file__).resolve().parents[1] / "build" / "release" / "ljmd"


def path() -> str:
    chosen = os.environ.get("LJMD_PROGRAM")
    return chosen or (str(RELEASE) if RELEASE.exists() else "ljmd")


def answer(*arguments: Any) -> Optional[Any]:
    """The JSON that a command prints; None where the program is not there, or refuses."""
    try:
        done = subprocess.run([path(), *map(str, arguments)], capture_output=True, text=True, check=False)
        return json.loads(done.stdout) if done.returncode == 0 else None
    except (OSError, json.JSONDecodeError):
        return None
