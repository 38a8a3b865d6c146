#!/usr/bin/env python3
"""`run DECK --out DIR [--force]` and `resume DIR` as the program has them, with a pair potential of Python's that the
directory stores as a table."""

import argparse
import warnings

import ljmd


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("command", choices=["run", "resume"])
    parser.add_argument("what")
    parser.add_argument("--out")
    parser.add_argument("--force", action="store_true")
    parser.add_argument("--quiet", action="store_true")
    options = parser.parse_args()
    warnings.simplefilter("ignore", ljmd.RunWarning)
    if options.command == "resume":
        ljmd.resume(options.what, progress=False)
        return
    deck = ljmd.Deck.load(options.what)
    deck.potential = ljmd.pair(lambda r: 4 * (r**-12 - r**-6), cutoff=2.0, truncation="shifted")
    deck.run(options.out, replace=options.force, progress=False)


if __name__ == "__main__":
    main()
