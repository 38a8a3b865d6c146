"""Progress of a run: one line, on a terminal or in a notebook; nothing where neither is."""

from __future__ import annotations

import contextlib
import sys
import time

from . import _check

_PAUSE = 0.2  # seconds from one line to the next; what takes less shows none


class _Terminal:
    def __init__(self):
        self._width = 0

    def show(self, line: str) -> None:
        self._width = max(self._width, len(line))
        sys.stderr.write(f"\r{line.ljust(self._width)}")
        sys.stderr.flush()

    def clear(self) -> None:
        sys.stderr.write(f"\r{'':{self._width}}\r")
        sys.stderr.flush()


class _Notebook:
    """An output of the cell that changes: what is written to stderr would stay as an empty red box."""

    def __init__(self, display):
        self._display, self._handle = display, None

    def show(self, line: str) -> None:
        content = {"text/plain": line}
        if self._handle is None:
            self._handle = self._display(content, raw=True, display_id=True)
        else:
            self._handle.update(content, raw=True)

    def clear(self) -> None:
        self._handle.update({"text/plain": ""}, raw=True)


def _place():
    """Where a line can be shown that goes away again; None: nowhere."""
    shell = sys.modules["IPython"].get_ipython() if "IPython" in sys.modules else None
    if hasattr(shell, "kernel"):
        from IPython.display import display  # type: ignore
        return _Notebook(display)
    return _Terminal() if sys.stderr is not None and sys.stderr.isatty() else None


class _Line:
    """Per cent, steps per second and the time that is left."""

    def __init__(self, place, total: int, first: int, unit: str):
        self.place, self.total, self.first, self.unit = place, total, first, unit
        self.began = self.last = time.monotonic()
        self.shown = False

    def __call__(self, step: int) -> None:
        now = time.monotonic()
        if now - self.last < _PAUSE:
            return
        self.last, self.shown = now, True
        rate = max(step - self.first, 0) / max(now - self.began, 1e-9)
        left = f"  {(self.total - step) / rate:.0f} s left" if rate > 0 else ""
        self.place.show(f"{100 * step / max(self.total, 1):3.0f} %  {self.unit} {step}/{self.total}  {rate:.3g} {self.unit}s/s{left}")

    def close(self) -> None:
        if self.shown:
            self.place.clear()


@contextlib.contextmanager
def shown(wanted, total: int, first: int = 0, unit: str = "step"):
    """What the engine calls with the number of steps done, or None. `wanted`: True, False, or a function of one's own."""
    wanted = _check.progress_of(wanted)
    place = _place() if wanted is True else None
    if place is None:
        yield wanted if callable(wanted) else None
        return
    progress = _Line(place, total, first, unit)
    try:
        yield progress
    finally:
        progress.close()
