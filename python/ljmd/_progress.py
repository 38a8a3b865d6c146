"""Progress of a run: tqdm's bar where it is installed, else one line on a terminal."""

from __future__ import annotations

import contextlib
import sys
import time
import warnings

from . import _check


class _Line:
    """Per cent and steps per second, in one line of the terminal."""

    def __init__(self, total: int, first: int, unit: str):
        self.total, self.first, self.unit, self.began, self.shown = total, first, unit, time.monotonic(), 0.0

    def __call__(self, step: int) -> None:
        now = time.monotonic()
        if now - self.shown > 0.2:
            self.shown = now
            rate = (step - self.first) / max(now - self.began, 1e-9)
            sys.stderr.write(f"\r{100 * step / max(self.total, 1):3.0f} %  {self.unit} {step}/{self.total}  {rate:.3g} {self.unit}s/s   ")
            sys.stderr.flush()

    def close(self) -> None:
        if self.shown:
            sys.stderr.write("\n")


class _Bar:
    def __init__(self, bar):
        self.bar = bar

    def __call__(self, step: int) -> None:
        self.bar.update(step - self.bar.n)

    def close(self) -> None:
        self.bar.close()


@contextlib.contextmanager
def shown(wanted, total: int, first: int = 0, unit: str = "step"):
    """What the engine calls with the number of steps done, or None. `wanted`: True, False, or a function of one's own."""
    wanted = _check.progress_of(wanted)
    if callable(wanted) or not wanted:
        yield wanted or None
        return
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # in a notebook without ipywidgets tqdm warns, and shows its bar as text
            from tqdm.auto import tqdm  # type: ignore
        progress: _Bar | _Line = _Bar(tqdm(total=total, initial=first, unit=unit, leave=False))
    except ImportError:
        if not sys.stderr.isatty():
            yield None
            return
        progress = _Line(total, first, unit)
    try:
        yield progress
        progress(total)
    finally:
        progress.close()
