"""The installed Python package is imported from where it was installed, and runs a deck."""

import pathlib
import sys

sys.path.insert(0, sys.argv[1])
import ljmd  # noqa: E402

assert pathlib.Path(ljmd.__file__).is_relative_to(sys.argv[1]), ljmd.__file__
assert pathlib.Path(ljmd._core.__file__).is_relative_to(sys.argv[1]), ljmd._core.__file__
deck = ljmd.Deck.fluid(atoms=108, density=0.8, temperature=1.0, cutoff=2.0)
deck.stages = [ljmd.Stage("production", 40, sample=True)]
print(deck.run(progress=False)["pressure"])
