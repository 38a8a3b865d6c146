"""The exercises of docs/class: their commands are run, and give the numbers of the answers.

Usage: class_test.py --ljmd PROGRAM [--update] [NAME]     one exercise, such as `melting`; without a name what the answers quote

PYTHONPATH has the package `ljmd`. The numbers are the same on every processor.
--update writes what the scripts print into the answers, and their pictures, half as large, into docs/images.
"""

import argparse
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]

FOLDER = ROOT / "docs/class"
BLOCK = re.compile(r"^```text\n(.*?)^```$", re.M | re.S)
NUMBER = re.compile(r"(?<![\w.^(/-])-?\d+\.\d+(?:e-?\d+)?(?![\w^])")


def exercises() -> list:
    return sorted(path.stem for path in (FOLDER / "answers").glob("*.md"))


def page(name: str) -> str:
    return (FOLDER / f"{name}.md").read_text(encoding="utf-8")


def shown(name: str) -> str:
    """What the answers show of the script."""
    blocks = BLOCK.findall((FOLDER / f"answers/{name}.md").read_text(encoding="utf-8"))
    assert len(blocks) == 1, f"{name}: {len(blocks)} blocks of numbers"
    return blocks[0]


def run(command: str, ljmd: str, folder: pathlib.Path) -> str:
    """One command of the page; one that ends in `# fails` has to fail."""
    program, *arguments = shlex.split(command, comments=True)
    start = {"ljmd": [ljmd], "tools/python": [sys.executable]}[program]
    done = subprocess.run([*start, *arguments], cwd=folder, capture_output=True, text=True, check=False)
    assert (done.returncode != 0) == command.endswith("# fails"), f"{command}\nexit code {done.returncode}\n{done.stderr}"
    return done.stdout


def keep_picture(drawn: pathlib.Path, name: str) -> None:
    from PIL import Image
    picture = Image.open(drawn).convert("RGB")
    picture = picture.resize((picture.width // 2, picture.height // 2), Image.Resampling.LANCZOS)
    picture.quantize(64, Image.Quantize.FASTOCTREE).save(ROOT / f"docs/images/class-{name}.png", optimize=True)


def printed(name: str, ljmd: str, keep: bool = False) -> str:
    """What the last script of the page prints, after all commands before it."""
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        (folder / "docs").symlink_to(ROOT / "docs")
        outputs = [run(command, ljmd, folder) for block in re.findall(r"^```sh\n(.*?)^```$", page(name), re.M | re.S)
                   for command in block.splitlines()]
        numbers = [text for text in outputs if "picture: " in text]
        assert len(numbers) == 1, f"{name}: {len(numbers)} scripts drew a picture"
        picture = folder / re.findall(r"^picture: (.*)$", numbers[0], re.M)[0]
        assert picture.stat().st_size > 10_000, picture
        if keep:
            keep_picture(picture, name)
    return "".join(line + "\n" for line in numbers[0].splitlines() if not line.startswith("picture: "))


def values(text: str) -> dict:
    """{name: (number, what stands behind +-, or a unit of its last digit)}."""
    found = {}
    for line in text.splitlines():
        name, number, error = re.fullmatch(r"(.*?) +(\S+?)(?: \+- (\S+))?", line).groups()
        digits = re.match(r"-?\d+(?:\.(\d+))?(?:e(-?\d+))?", number).groups()
        last = 10.0**(int(digits[1] or 0) - len(digits[0] or ""))
        found[name] = float(number), float(error or last)
    return found


def compare(name: str, ljmd: str) -> None:
    there, here = values(shown(name)), values(printed(name, ljmd))
    assert list(there) == list(here), f"shown: {list(there)}\nprinted: {list(here)}"
    wrong = [f"{each}: {there[each]} shown, {here[each]} printed" for each in there
             if abs(there[each][0] - here[each][0]) > 1.01 * there[each][1]]
    assert not wrong, "\n".join(wrong)
    print(f"{name}: {len(there)} numbers agree")


def is_quoted(number: str, known: list) -> bool:
    """Whether a number of the text is one of the known ones, perhaps with fewer digits."""
    decimals = len(number.partition("e")[0].partition(".")[2])
    exponent = int(number.partition("e")[2] or 0)
    unit = 10.0**(exponent - decimals)
    return any(abs(float(number) - each) <= 0.501 * unit for each in known)


def check_quotes() -> None:
    """Every number with a decimal point in the answers is one that the script prints, or that page or decks have."""
    decks = "\n".join(path.read_text(encoding="utf-8") for path in (FOLDER / "decks").iterdir())
    overview = (FOLDER / "README.md").read_text(encoding="utf-8")
    for name in exercises():
        answers = (FOLDER / f"answers/{name}.md").read_text(encoding="utf-8")
        known = [float(number) for number in NUMBER.findall(shown(name) + page(name) + decks)]
        known += [error for _, error in values(shown(name)).values()]
        unknown = [number for number in NUMBER.findall(BLOCK.sub("", answers)) if not is_quoted(number, known)]
        assert not unknown, f"answers/{name}.md: neither printed by the script nor given: {', '.join(unknown)}"
        assert f"]({name}.md)" in overview and f"](answers/{name}.md)" in overview, f"{name} is not in docs/class/README.md"
        asked = re.findall(r"^(\d+)\. ", page(name).partition("## Questions")[2], re.M)
        answered = re.findall(r"^(\d+)\. ", answers, re.M)
        assert asked == answered, f"{name}: questions {asked}, answers {answered}"


def update(name: str, ljmd: str) -> None:
    path = FOLDER / f"answers/{name}.md"
    block = f"```text\n{printed(name, ljmd, keep=True)}```"
    path.write_text(BLOCK.sub(lambda _: block, path.read_text(encoding="utf-8")), encoding="utf-8")


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--ljmd", required=True)
    parser.add_argument("--update", action="store_true")
    parser.add_argument("name", nargs="?", choices=exercises())
    arguments = parser.parse_args()
    os.environ["OMP_NUM_THREADS"] = "1"
    program = str(pathlib.Path(arguments.ljmd).resolve())
    if arguments.name is None:
        check_quotes()
    elif arguments.update:
        update(arguments.name, program)
    else:
        compare(arguments.name, program)
