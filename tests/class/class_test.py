"""The exercises of docs/class: their commands are run, and give the numbers of the answers.

Usage: class_test.py --ljmd PROGRAM [--update | --seeds N] [NAME]

NAME is one exercise, such as `melting`, or `page`, the lesson without an installation. Without a name: what the answers quote, and
whether tools/python finds an installed package. PYTHONPATH has the package `ljmd`. The numbers are the same on every processor.

What answers quote, in the text around the numbers of the script, has to be right in three ways: a number with a decimal point is one
of the script, with or without its sign, or is given by the page or its decks; `A +- B` is a line of the script; and `A/B = C` and
`A*B = C` hold.

--update writes what the scripts print into the answers, and their pictures, half as large, into docs/images.
--seeds N runs the exercise with N seeds, and compares the scatter of its numbers with the errors behind +-.
"""

import argparse
import os
import pathlib
import re
import shlex
import shutil
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]

FOLDER = ROOT / "docs/class"
BLOCK = re.compile(r"^```text\n(.*?)^```$", re.M | re.S)
FIGURE = r"-?\d+(?:\.\d+)?(?:e-?\d+)?"
NUMBER = re.compile(r"(?<![\w.^])(?:(?<![(/)-])-)?\d+\.\d+(?:e-?\d+)?(?![\w^])")
PAIR = re.compile(rf"({FIGURE}) \+- ({FIGURE})")
RESULT = re.compile(rf"(?<![\w.)/*^-])({FIGURE})([/*])({FIGURE}) = ({FIGURE})")


def exercises() -> list:
    return sorted(path.stem for path in (FOLDER / "answers").glob("*.md"))


def page(name: str) -> str:
    return (FOLDER / f"{name}.md").read_text(encoding="utf-8")


def shown(name: str) -> str:
    """What the answers show of the script."""
    blocks = BLOCK.findall((FOLDER / f"answers/{name}.md").read_text(encoding="utf-8"))
    assert len(blocks) == 1, f"{name}: {len(blocks)} blocks of numbers"
    return blocks[0]


def run(command: str, ljmd: str, folder: pathlib.Path, seed: int | None = None) -> str:
    """One command of the page; one that ends in `# fails` has to fail."""
    program, *arguments = shlex.split(command, comments=True)
    if program == "ljmd" and seed is not None:
        arguments += ["--set", f"system.seed={seed}"]
    start = {"ljmd": [ljmd], "tools/python": [sys.executable]}[program]
    done = subprocess.run([*start, *arguments], cwd=folder, capture_output=True, text=True, check=False)
    assert (done.returncode != 0) == command.endswith("# fails"), f"{command}\nexit code {done.returncode}\n{done.stderr}"
    return done.stdout


def keep_picture(drawn: pathlib.Path, name: str) -> None:
    from PIL import Image
    picture = Image.open(drawn).convert("RGB")
    picture = picture.resize((picture.width // 2, picture.height // 2), Image.Resampling.LANCZOS)
    picture.quantize(64, Image.Quantize.FASTOCTREE).save(ROOT / f"docs/images/class-{name}.png", optimize=True)


def printed(name: str, ljmd: str, keep: bool = False, seed: int | None = None) -> str:
    """What the last script of the page prints, after all commands before it."""
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        (folder / "docs").symlink_to(ROOT / "docs")
        outputs = [run(command, ljmd, folder, seed) for block in re.findall(r"^```sh\n(.*?)^```$", page(name), re.M | re.S)
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


def unit_of(number: str) -> float:
    """Of the last digit."""
    mantissa, _, exponent = number.partition("e")
    return 10.0**(int(exponent or 0) - len(mantissa.partition(".")[2]))


def rounds_to(value: float, number: str) -> bool:
    return abs(float(number) - value) <= 0.501 * unit_of(number)


def check_quotes(name: str) -> None:
    answers = BLOCK.sub("", (FOLDER / f"answers/{name}.md").read_text(encoding="utf-8"))
    decks = "".join((ROOT / deck).read_text(encoding="utf-8") for deck in sorted(set(re.findall(r"docs/class/decks/[\w.-]+", page(name)))))
    lines = values(shown(name))
    wrong = [f"{pair[0]} is no line of the script" for pair in PAIR.finditer(answers)
             if not any(rounds_to(value, pair[1]) and rounds_to(error, pair[2]) for value, error in lines.values())]
    for a, operator, b, result in RESULT.findall(answers):
        if not rounds_to(float(a) / float(b) if operator == "/" else float(a) * float(b), result):
            wrong.append(f"{a}{operator}{b} is not {result}")
    rest = PAIR.sub("", RESULT.sub(r"\1 \3", answers))
    known = [each for value, _ in lines.values() for each in (value, abs(value))]
    known += [float(number) for number in NUMBER.findall("\n".join([*lines, page(name), decks]))]
    wrong += [f"{number} is neither printed by the script nor given" for number in NUMBER.findall(rest)
              if not any(rounds_to(value, number) for value in known)]
    assert not wrong, f"answers/{name}.md: " + "; ".join(wrong)


def check_answers(name: str) -> None:
    overview = (FOLDER / "README.md").read_text(encoding="utf-8")
    assert f"]({name}.md)" in overview and f"](answers/{name}.md)" in overview, f"{name} is not in docs/class/README.md"
    asked = re.findall(r"^(\d+)\. ", page(name).partition("## Questions")[2], re.M)
    answered = re.findall(r"^(\d+)\. ", (FOLDER / f"answers/{name}.md").read_text(encoding="utf-8"), re.M)
    assert asked == answered, f"{name}: questions {asked}, answers {answered}"
    check_quotes(name)


def check_installed() -> None:
    """tools/python of a tree without a build starts Python with the package of the installed program in PATH."""
    import ljmd
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary).resolve()
        for name in ("tree/tools", "installed/bin", "installed/share/ljmd/python"):
            (folder / name).mkdir(parents=True)
        shutil.copy(ROOT / "tools/python", folder / "tree/tools")
        (folder / "installed/share/ljmd/python/ljmd").symlink_to(pathlib.Path(ljmd.__file__).parent)
        program = folder / "installed/bin/ljmd"
        program.write_text("#!/bin/sh\n")
        program.chmod(0o755)
        environment = {key: value for key, value in os.environ.items() if key not in ("PYTHONPATH", "LJMD_BUILD")}
        environment["PATH"] = f"{program.parent}:{environment['PATH']}"
        found = subprocess.run([folder / "tree/tools/python", "-c", "import ljmd; print(ljmd.__file__)"], env=environment,
                               capture_output=True, text=True, check=False)
        assert found.stdout.startswith(str(folder / "installed")), found.stdout + found.stderr
        print("tools/python finds an installed package")


def check_scatter(name: str, ljmd: str, seeds: int) -> None:
    """Numbers of runs that differ by their seeds scatter as the errors behind +- say, which are two standard errors.

    One number of a few runs proves little. What is judged is the mean over all numbers, 0.85 with fourteen seeds of `melting`.
    """
    runs = [values(printed(name, ljmd, seed=seed)) for seed in range(1, seeds + 1)]
    with_errors = [key for key in re.findall(r"^(.*?) +\S+ \+- ", shown(name), re.M) if all(key in found for found in runs)]
    ratios = []
    for key in with_errors:
        numbers, errors = zip(*(found[key] for found in runs))
        ratios.append(2 * statistics.stdev(numbers) / statistics.fmean(error**2 for error in errors)**0.5)
        print(f"{key:52} scatter / error {ratios[-1]:.2f}")
    ratio = statistics.fmean(each**2 for each in ratios)**0.5
    print(f"{name}: {len(ratios)} numbers, {seeds} seeds: scatter / error {ratio:.2f}")
    assert 0.6 < ratio < 1.4, "errors behind +- are wrong"


def check_lesson(ljmd: str) -> None:
    """What docs/class/page.md says about the crystal that is heated by hand."""
    import ljmd as package
    import numpy as np
    text = page("page")
    for temperature, phase in (("0.76", "crystal"), ("1.29", "fluid")):
        assert f"at {'T = ' if phase == 'crystal' else ''}{temperature}" in text, f"page.md does not name {temperature}"
        said = subprocess.run([ljmd, "eos", "--temperature", temperature, "--density", "0.96" if phase == "crystal" else "0.98"],
                              capture_output=True, text=True, check=True).stderr
        assert rounds_to(float(re.search(rf"{phase} of density (\S+)", said)[1]), "0.97"), said
    with tempfile.TemporaryDirectory() as temporary:
        subprocess.run([ljmd, "run", FOLDER / "decks/page.toml", "--quiet", "--out", f"{temporary}/run"], check=True, capture_output=True)
        run = package.open(f"{temporary}/run")
        step, order = np.asarray(run.thermo["step"]), np.asarray(run.thermo["order_parameter"])
        g, r = np.asarray(run.table("rdf")["g"]), np.asarray(run.table("rdf")["r"])
    found = {stage["name"]: order[(step > 5000 * place + 1000) & (step <= 5000 * (place + 1))].mean()
             for place, stage in enumerate(run.stages)}
    print({name: round(float(value), 3) for name, value in found.items()})
    assert "is 0.86" in text and abs(found["up 0.60"] - 0.86) < 0.01, found
    assert "with 0.72" in text and abs(found["up 1.20"] - 0.72) < 0.02, found
    assert "at T = 1.4" in text and found["up 1.40"] > 0.5, found
    assert order[(step > 5000 * 5 + 2500) & (step <= 5000 * 6)].mean() < 0.1 and abs(found["still 0.60"]) < 0.1, found
    lowest = g[(r > 1.2) & (r < 1.7)].min()
    assert "is 0.43 high" in text and abs(lowest - 0.43) < 0.03, lowest


def update(name: str, ljmd: str) -> None:
    path = FOLDER / f"answers/{name}.md"
    block = f"```text\n{printed(name, ljmd, keep=True)}```"
    path.write_text(BLOCK.sub(lambda _: block, path.read_text(encoding="utf-8")), encoding="utf-8")


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--ljmd", required=True)
    parser.add_argument("--update", action="store_true")
    parser.add_argument("--seeds", type=int)
    parser.add_argument("name", nargs="?", choices=[*exercises(), "page"])
    arguments = parser.parse_args()
    os.environ["OMP_NUM_THREADS"] = "1"
    program = str(pathlib.Path(arguments.ljmd).resolve())
    if arguments.name is None:
        for each in exercises():
            check_answers(each)
        check_installed()
    elif arguments.name == "page":
        check_lesson(program)
    elif arguments.seeds:
        check_scatter(arguments.name, program, arguments.seeds)
    elif arguments.update:
        update(arguments.name, program)
    else:
        compare(arguments.name, program)
