"""The installed program draws by the installed scripts: plotted.py PREFIX/bin/ljmd."""

import pathlib
import subprocess
import sys
import tempfile

DECK = """
[force]
type = "newtonian-gravity"
gravitational_constant = 1.0
central_mass = 1.0
[[body]]
mass = 1.0
position = [1.0, 0.0]
velocity = [0.0, 1.2]
[[stage]]
name = "orbit"
time_step = 0.01
steps = 500
[output]
trajectory = { every = 5 }
"""

program = pathlib.Path(sys.argv[1]).resolve()
assert not (program.parent / "analysis").exists(), "the scripts of a build lie beside the program"
with tempfile.TemporaryDirectory() as folder:
    (pathlib.Path(folder) / "deck.toml").write_text(DECK)
    subprocess.run([program, "run", "deck.toml", "--quiet", "--out", "out"], cwd=folder, check=True, capture_output=True)
    done = subprocess.run([program, "plot", "out"], cwd=folder, check=True, capture_output=True, text=True)
    pictures = done.stdout.splitlines()
    assert pictures == [f"out/{name}.png" for name in ("energy", "orbit", "phase", "momentum")], done
    for picture in pictures:
        assert (pathlib.Path(folder) / picture).read_bytes().startswith(b"\x89PNG"), picture
