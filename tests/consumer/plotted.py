"""The installed program draws by the installed scripts: plotted.py PREFIX/bin/ljmd."""

import pathlib
import subprocess
import sys
import tempfile

program = pathlib.Path(sys.argv[1]).resolve()
assert not (program.parent / "analysis").exists(), "the scripts of a build lie beside the program"
with tempfile.TemporaryDirectory() as folder:
    subprocess.run([program, "init", "deck.toml", "--example", "kepler-leapfrog"], cwd=folder, check=True, capture_output=True)
    subprocess.run([program, "run", "deck.toml", "--quiet", "--out", "out", "--set", "stage.orbits.steps=500"], cwd=folder,
                   check=True, capture_output=True)
    done = subprocess.run([program, "plot", "out"], cwd=folder, check=True, capture_output=True, text=True)
    pictures = done.stdout.splitlines()
    assert pictures == [f"out/{name}.png" for name in ("energy", "orbit", "phase", "momentum")], done
    for picture in pictures:
        assert (pathlib.Path(folder) / picture).read_bytes().startswith(b"\x89PNG"), picture
