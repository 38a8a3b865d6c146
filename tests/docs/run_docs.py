"""The documentation, executed: decks shown in README.md, CONTRIBUTING.md and docs/ are written, commands shown there are run.

Usage: run_docs.py --ljmd PROGRAM --source ROOT [--python-path FOLDER] [--quick]

- A block ```toml whose first line is `# file: NAME` is written as NAME.
- In a block ```sh, lines that begin with `ljmd` or `analysis/` are run, in order, in one folder for each document, which has
  the repository's inputs/. Other lines (tools/, tests/, build/, python3) are not run: they build, or take hours. Those of
  docs/class are run by tests/class.
- A block ```python whose first line is `# file: NAME` is a script of its own, which a test of the program runs.
- The other blocks ```python of a document are run as one program, in the same folder, with the package `ljmd` in FOLDER; without one
  they are not run. They find a trajectory.h5md and a trajectory.xyz of a short run there.
- A block ```text that shows a message of ljmd about a deck of the same document is compared with the message that the deck
  gives after the mistake has been made in it.
- docs/deck-reference.md must be what `ljmd info --keys` prints.
- Links to files of the repository must lead somewhere, and their text must not be the name of a page, as in `[x.md](x.md)`.
- Files that are named in backquotes, or as the script of a line in a block ```sh, must be there (`*` stands for anything; names with a
  <place holder> are left alone).

--quick: of the commands only those of README.md.
"""

import argparse
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

passed = 0
failed = 0


def check(name: str, good: bool, detail: str = "") -> None:
    global passed, failed
    passed += good
    failed += not good
    if not good:
        print(f"FAIL {name}\n{detail}")


def blocks(text: str) -> list[tuple[str, str]]:
    return re.findall(r"^```(\w+)\n(.*?)^```$", text, re.M | re.S)


def run(ljmd: str, command: str, folder: pathlib.Path, root: pathlib.Path) -> subprocess.CompletedProcess:
    """A command of ljmd, or a script of analysis/ with this Python."""
    first, *arguments = shlex.split(command, comments=True)
    program = [ljmd] if first == "ljmd" else [sys.executable, str(root / first)]
    if first == "analysis/convergence.py":  # it looks for the build of the release first
        arguments += ["--ljmd", ljmd]
    # Means of two long runs are compared within three standard errors, which fails by chance. In 400 steps both programs follow
    # one trajectory, and their means differ by a thousandth of that.
    if first == "ljmd" and arguments[0] == "compare" and "openmm" in arguments and "--parts" not in arguments:
        arguments += ["--set", "stage.production.steps=400"]
    return subprocess.run(program + arguments, cwd=folder, capture_output=True, text=True)


def check_message(document: str, ljmd: str, message: str, folder: pathlib.Path, root: pathlib.Path) -> None:
    """Make the mistake that a shown message is about: its second line is the wrong line of the deck."""
    name, number = re.match(r"error: (\S+?):(\d+):", message).groups()
    wrong = re.search(r"^ *\d+ \| (.*)$", message, re.M).group(1)
    lines = (folder / name).read_text().splitlines()
    lines[int(number) - 1] = wrong
    elsewhere = folder / "wrong"
    elsewhere.mkdir()
    (elsewhere / name).write_text("\n".join(lines) + "\n")
    said = run(ljmd, f"ljmd check {name}", elsewhere, root).stderr
    check(f"{document}: message about {name}", said == message, f"shown:\n{message}\nsaid:\n{said}")


def check_links(path: pathlib.Path) -> None:
    page = re.sub(r"^```.*?^```", "", path.read_text(encoding="utf-8"), flags=re.M | re.S)  # a lambda in C++ looks like a link
    for text in re.findall(r"\[([\w./-]+\.md)\]\(", page):
        check(f"{path.name}: the link [{text}] tells a reader where it leads", False)
    for target in re.findall(r"\]\(([^)#]+)(?:#[^)]*)?\)", page):
        if "://" not in target:
            check(f"{path.name}: link to {target}", (path.parent / target).exists())


def named_files(text: str) -> list[str]:
    """Files and folders of the repository that a document names."""
    scripts = [line.removeprefix("python3 ") for language, body in blocks(text) if language == "sh" for line in body.splitlines()]
    words = re.findall(r"`([^`\n]+)`", re.sub(r"^```.*?^```$", "", text, flags=re.M | re.S))
    names = [word.split()[0] for word in scripts + words if word.strip()]
    folders = ("src/", "include/", "tests/", "tools/", "cmake/", "docs/", "inputs/", "analysis/", ".ci/")
    return [name for name in names if name.startswith(folders) and "<" not in name]


def check_named_files(path: pathlib.Path, root: pathlib.Path) -> None:
    for name in named_files(path.read_text(encoding="utf-8")):
        check(f"{path.name}: {name}", any(root.glob(name.rstrip("/"))), "is not there")


def check_pictures(root: pathlib.Path) -> None:
    """Every picture has a recipe, by which it is drawn anew, and is shown on a page."""
    listed = subprocess.run([root / "tools/docs-figures", "--list"], capture_output=True, text=True, check=True).stdout.split()
    stored = sorted(path.name for path in (root / "docs/images").iterdir())
    check("docs/images are the pictures of tools/docs-figures", stored == sorted(listed), f"{set(stored) ^ set(listed)} are only in one")
    text = "".join(path.read_text(encoding="utf-8") for path in [root / "README.md", *(root / "docs").rglob("*.md")])
    for name in stored:
        check(f"docs/images/{name} is shown on a page", f"images/{name})" in text)


SHORT_RUN = """\
[system]
lattice = { type = "fcc", cells = 3 }
density = 0.8442
temperature = 1.0
[potential]
type = "lennard-jones"
cutoff = 2.4
truncation = "cut"
tail = true
[[stage]]
name = "production"
time_step = 0.004
steps = 20
[output]
trajectory = { every = 5, velocities = true }
"""


def write_trajectories(ljmd: str, folder: pathlib.Path) -> None:
    (folder / "short.toml").write_text(SHORT_RUN)
    for form in ("h5md", "xyz"):
        subprocess.run([ljmd, "run", "short.toml", "--out", form, "--quiet", "--set", f"output.trajectory.format={form}"],
                       cwd=folder, check=True, capture_output=True)
        (folder / form / f"trajectory.{form}").rename(folder / f"trajectory.{form}")


def check_python(path: pathlib.Path, ljmd: str, folder: pathlib.Path, package: str | None) -> None:
    program = "".join(body for language, body in blocks(path.read_text(encoding="utf-8")) if language == "python" and not body.startswith("# file: "))
    if program and package:
        write_trajectories(ljmd, folder)
        result = subprocess.run([sys.executable, "-c", program], cwd=folder, capture_output=True, text=True,
                                env={**os.environ, "PYTHONPATH": package})
        check(f"{path.name}: its program in Python", result.returncode == 0, result.stderr)


def check_commands(path: pathlib.Path, ljmd: str, root: pathlib.Path, package: str | None) -> None:
    text = path.read_text(encoding="utf-8")
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        (folder / "inputs").symlink_to(root / "inputs")
        for language, body in blocks(text):
            if language == "toml" and (match := re.match(r"# file: (\S+)\n", body)):
                (folder / match.group(1)).write_text(body)
            elif language == "sh":
                for command in body.splitlines():
                    if command.startswith(("ljmd ", "analysis/")):
                        result = run(ljmd, command, folder, root)
                        check(f"{path.name}: {command}", result.returncode == 0, result.stderr)
            elif language == "text" and body.startswith("error: "):
                check_message(path.name, ljmd, body, folder, root)
        check_python(path, ljmd, folder, package)


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--ljmd", required=True)
    parser.add_argument("--source", required=True, type=pathlib.Path)
    parser.add_argument("--python-path")
    parser.add_argument("--quick", action="store_true")
    arguments = parser.parse_args()
    ljmd = str(pathlib.Path(arguments.ljmd).resolve())
    root = arguments.source.resolve()
    readme = root / "README.md"
    for path in [readme, root / "CONTRIBUTING.md", *sorted((root / "docs").rglob("*.md"))]:
        check_links(path)
        check_named_files(path, root)
        if path == readme or not (arguments.quick or root / "docs/class" in path.parents):
            check_commands(path, ljmd, root, arguments.python_path)
    check_pictures(root)
    keys = subprocess.run([ljmd, "info", "--keys"], capture_output=True, text=True, check=True).stdout
    page = root / "docs/deck-reference.md"
    check("docs/deck-reference.md is what `ljmd info --keys` prints",
          page.exists() and keys == page.read_text(encoding="utf-8"),
          "write it anew: build/dev/ljmd info --keys > docs/deck-reference.md")
    print(f"{passed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
