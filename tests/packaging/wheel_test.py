"""The wheel that tools/wheel makes of an install tree: it runs from where it is unpacked, and what is planted in it is found.

Usage: wheel_test.py --ljmd PROGRAM --package FOLDER      FOLDER: the Python package of the build, with its extension
"""

import argparse
import pathlib
import shutil
import subprocess
import sys
import tempfile
import zipfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
WHEEL = ROOT / "tools" / "wheel"


def install_tree(tree: pathlib.Path, program: pathlib.Path, package: pathlib.Path) -> None:
    """What `cmake --install` gives with the options of pyproject.toml, from the files of this build."""
    shutil.copytree(package, tree / "ljmd", ignore=shutil.ignore_patterns("__pycache__"))
    (tree / "ljmd" / "bin").mkdir()
    shutil.copy(program, tree / "ljmd" / "bin" / "ljmd")
    for name in ("analysis", "inputs"):
        shutil.copytree(ROOT / name, tree / "ljmd" / "share" / "ljmd" / name, ignore=shutil.ignore_patterns("__pycache__"))
    for file in (tree / "ljmd" / "bin" / "ljmd", *(tree / "ljmd").glob("_core*.so")):
        subprocess.run(["strip", file], check=True)


def changed(wheel: pathlib.Path, folder: pathlib.Path, change) -> pathlib.Path:
    """A copy of a wheel whose members went through `change(name, data)`; None: left out."""
    copy = folder / wheel.name
    with zipfile.ZipFile(wheel) as old, zipfile.ZipFile(copy, "w") as new:
        for name in old.namelist():
            data = change(name, old.read(name))
            if data is not None:
                new.writestr(name, data)
    return copy


def complaint(wheel: pathlib.Path, work: pathlib.Path) -> str:
    done = subprocess.run([sys.executable, WHEEL, "--work", work, "--check", wheel], capture_output=True, text=True, check=False)
    assert (done.returncode == 0) == (done.stderr == ""), done
    return done.stderr


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--ljmd", type=pathlib.Path, required=True)
    parser.add_argument("--package", type=pathlib.Path, required=True)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        install_tree(folder / "made", options.ljmd, options.package)
        made = subprocess.run([sys.executable, WHEEL, "--work", folder / "work", "--tree", folder / "made"], capture_output=True,
                              text=True, check=False)
        assert made.returncode == 0, made.stdout + made.stderr
        wheel = pathlib.Path(made.stdout.splitlines()[-1])
        assert "needs glibc 2." in made.stdout, made.stdout

        site = folder / "site"
        subprocess.run([sys.executable, "-m", "zipfile", "-e", wheel, site], check=True)
        (site / "ljmd" / "bin" / "ljmd").chmod(0o755)  # which an installer keeps, and zipfile does not
        code = ("import sys, ljmd; deck = ljmd.Deck.fluid(108, cutoff=2.0); deck.stages = [ljmd.Stage('short', 20)]\n"
                "deck.run(progress=False)\n"
                "sys.argv = ['ljmd', 'verify']\nfrom ljmd._command import main; main()")
        used = subprocess.run([sys.executable, "-I", "-c", f"import sys; sys.path.insert(0, {str(site)!r})\n{code}"], cwd=folder,
                              capture_output=True, text=True, check=False)
        assert used.returncode == 0 and "digits" in used.stdout, used

        other = folder / "other"
        other.mkdir()
        check = folder / "work"
        text = complaint(changed(wheel, other, lambda name, data: data + b"#" if name.endswith("/deck.py") else data), check)
        assert "ljmd/deck.py is not what RECORD says" in text, text
        text = complaint(changed(wheel, other, lambda name, data: data + str(ROOT).encode() if name.endswith("/deck.py") else data), check)
        assert "ljmd/deck.py holds the path of the build" in text, text
        text = complaint(changed(wheel, other, lambda name, data: None if "ljmd.libs/libhdf5" in name else data), check)
        assert "is not in the wheel, and not everywhere" in text and "libhdf5" in text, text
        text = complaint(changed(wheel, other, lambda name, data: None if "licenses/" in name else data), check)
        assert "is named as a licence, and is not there" in text, text
    print("the wheel runs, and four planted faults are found")


if __name__ == "__main__":
    main()
