#!/usr/bin/env python3
"""A film of one run of ljmd, as an animated GIF and as an MP4.

    animate.py RUNDIR [--relative-to K] [--frames N] [--fps F] [--output NAME] [--formats gif,mp4] [--force]

Few bodies move in the x-y plane with trails that fade, seen from body K if asked for; bodies on a line move in the
plane of coordinate and velocity. The atoms of a fluid (trajectory.h5md or trajectory.xyz) are seen along z, in their
box. At most N frames are drawn (200 by default), evenly spread. Writes NAME.gif and NAME.mp4 (RUNDIR/animation by
default) and prints the path of each, one a line. Earlier films are replaced, other files only with --force. MP4 needs the program ffmpeg.
Exit codes: 0 all that was asked for was made, 2 usage, 3 a file of the run is missing or damaged, 4 a film cannot be
written; the GIF is written first, and stays when the MP4 fails.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
from pathlib import Path
from typing import Optional, Sequence, Union

sys.path.insert(0, str(Path(__file__).resolve().parent))
from script import reports_errors  # noqa: E402  (it finds the package ljmd)
import few_body_points  # noqa: E402
import style  # noqa: E402
from animation_scenes import BoxScene, PathScene  # noqa: E402
from matplotlib.animation import AbstractMovieWriter, FFMpegWriter, PillowWriter  # noqa: E402
from ljmd.errors import FileError, InputError  # noqa: E402
from ljmd.reading import few_bodies, records  # noqa: E402
from ljmd.reading.files import damaged  # noqa: E402

FORMATS = ("gif", "mp4")  # in the order in which they are made
DPI = 100
MARK = style.MARKS[".gif"].decode()


def make_scene(directory: Path, most: int, relative_to: Optional[int]) -> Union[PathScene, BoxScene]:
    """What is to be seen of a run."""
    if records.read(directory).kind == "fluid":
        if relative_to is not None:
            raise InputError("--relative-to is for runs of few bodies")
        return BoxScene(directory, most)
    run = few_bodies.load(directory)
    if run.trajectory is None:
        raise damaged(directory, "no trajectory: ask the deck for one with [output] trajectory")
    return PathScene(run, most, None if relative_to is None else few_body_points.body_index(run, relative_to))


class MarkedGif(PillowWriter):
    """Says in the comment of the file who drew it."""

    def finish(self) -> None:
        self._frames[0].info["comment"] = MARK.encode()
        super().finish()


def make_writer(kind: str, fps: float) -> AbstractMovieWriter:
    """What writes one kind of film. An MP4 has the colours that all players can show."""
    if kind == "gif":
        return MarkedGif(fps=fps)
    if not FFMpegWriter.isAvailable():
        message = "mp4: the program ffmpeg was not found; install it, or ask for --formats gif"
        raise FileError(message)
    return FFMpegWriter(fps=fps, codec="h264", extra_args=["-pix_fmt", "yuv420p"], metadata={"comment": MARK})


def write_film(scene: Union[PathScene, BoxScene], writer: AbstractMovieWriter, path: Path, force: bool) -> None:
    """Draw every frame into a film, which has its name only when it is complete."""
    try:
        with style.replacing(path, force) as half, writer.saving(scene.figure, str(half), DPI):
            for frame in range(len(scene.rows)):
                scene.draw(frame)
                writer.grab_frame()
    except subprocess.CalledProcessError as error:
        raise FileError(f"{path}: cannot be written: {str(error).splitlines()[0]}") from None
    print(path)


def formats_from(text: str) -> list[str]:
    """The kinds of film that a list like gif,mp4 names, in the order in which they are made."""
    wanted = text.split(",")
    unknown = [name for name in wanted if name not in FORMATS]
    if unknown:
        raise argparse.ArgumentTypeError(f"'{unknown[0]}' is not one of {', '.join(FORMATS)}")
    return [name for name in FORMATS if name in wanted]


def positive(kind: type) -> object:
    """A reader of numbers above 0, for argparse."""

    def number(text: str) -> Union[int, float]:
        value = kind(text)
        if not 0 < value < float("inf"):
            raise argparse.ArgumentTypeError(f"{text} is not above 0")
        return value

    number.__name__ = kind.__name__
    return number


def parse(arguments: Optional[Sequence[str]]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(description="Make a film of one run of ljmd.")
    parser.add_argument("rundir", type=Path, help="directory that `ljmd run` wrote, with a trajectory")
    parser.add_argument("--relative-to", type=int, metavar="K", help="few bodies: seen from this one, counted from 1")
    parser.add_argument("--frames", type=positive(int), metavar="N", default=200, help="draw at most so many (200)")
    parser.add_argument("--fps", type=positive(float), metavar="F", default=25.0, help="frames in a second (25)")
    parser.add_argument("--output", type=Path, metavar="NAME", help="path without .gif, .mp4 (RUNDIR/animation)")
    parser.add_argument("--formats", type=formats_from, default=list(FORMATS), help="gif, mp4 or gif,mp4 (both)")
    parser.add_argument("--force", action="store_true", help="replace files that are no films of ljmd")
    options = parser.parse_args(arguments)
    ending = options.output.suffix if options.output else ""
    if ending in (".gif", ".mp4"):
        parser.error(f"--output {options.output}: must not end in {ending}; --formats tells what is made")
    return options


@reports_errors
def main(arguments: Optional[Sequence[str]] = None) -> int:
    options = parse(arguments)
    output = options.output or options.rundir / "animation"
    films = {kind: output.with_name(f"{output.name}.{kind}") for kind in options.formats}
    for path in films.values():
        style.require_writable(path, options.force)
    style.use()
    scene = make_scene(options.rundir, options.frames, options.relative_to)
    scene.draw(0)
    scene.figure.canvas.draw()
    scene.figure.set_layout_engine("none")  # laid out once: a layout for each frame is slow, and may jitter
    for kind, path in films.items():
        write_film(scene, make_writer(kind, options.fps), path, options.force)
    return 0


if __name__ == "__main__":
    sys.exit(main())
