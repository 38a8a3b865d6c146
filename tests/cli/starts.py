"""Where a run may start: lattices, random places, files of other programs, other runs."""

import csv
import gzip
import math
import resource
from pathlib import Path

from harness import ARGON, DECK, Case, Failure

DATA = Path(__file__).resolve().parents[1] / "data"
LATTICE = 'lattice = { type = "fcc", cells = 3 }\n'

NIST = """\
[system]
file = "{file}"
temperature = 1.0

[potential]
type = "lennard-jones"
cutoff = {cutoff}
truncation = "cut"
tail = {tail}

[[stage]]
name = "look"
time_step = 0.004
steps = 0
"""

XYZ = """\
{count}
Lattice="6 0 0 0 6 0 0 0 6" Properties=species:S:1:pos:R:3 pbc="T T T"
{atoms}
"""

HALVED = (5.04, 6.06, 6.6, 10.01, 10.26)  # edges of a box

PAIR = DECK.replace(LATTICE, 'file = "pair.xyz"\n').replace("density = 0.8442\n", "")


def published():
    """Rows of the published table as dictionaries of texts."""
    with open(DATA / "nist" / "published.csv", encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def agrees(t, what, found, printed):
    """A number agrees with a printed one when it rounds to its digits."""
    digits = len(printed.lstrip("-").replace(".", "").lstrip("0"))
    last = 10.0 ** (math.floor(math.log10(abs(float(printed)))) + 1 - digits)
    # a printed trailing zero may have been lost: 690.0 is given to four digits, all numbers to five at best
    t.check(abs(found - float(printed)) <= 0.5 * last * (1 + 1e-6), f"{what}: found {found}, published {printed}")


def nist(row):
    """U, W and the tail of a reference configuration, through the program."""
    def test(t):
        found = {}
        for tail in ("false", "true"):
            t.deck(text=NIST.format(file=DATA / "nist" / f"lj_sample_config_periodic{row['config']}.txt", cutoff=row["rc"],
                                    tail=tail))
            t.run_well("run", "deck.toml", "--quiet", "--out", tail)
            found[tail] = t.json(f"{tail}/results.json")
        atoms = int(row["N"])
        t.equal(found["false"]["system"]["atoms"], atoms, "atoms")
        t.check(abs(found["false"]["system"]["box_edges"][0] - float(row["L"])) < 1e-12, "box")
        energy = {tail: atoms * r["observables"]["potential_energy"]["mean"] for tail, r in found.items()}
        agrees(t, "U", energy["false"], row["U"])
        agrees(t, "W", found["false"]["observables"]["virial"]["mean"], row["W"])
        agrees(t, "tail", energy["true"] - energy["false"], row["ULRC"])
    return test


def continued(t, file):
    """Run 40 steps, then 20 from its end; the positions, velocities and box carry over."""
    t.deck()
    t.run_well("run", "deck.toml", "--quiet", "--out", "first")
    t.deck((LATTICE, f'file = "{file}"\n'), ("density = 0.8442\n", ""), ("temperature = 1.0\n", ""),
           ("steps = 20\nthermostat = { type = \"rescale\", every = 5 }", "steps = 0"))
    t.run_well("run", "deck.toml", "--quiet", "--out", "second")
    ends, begins = t.columns("first/thermo.csv"), t.columns("second/thermo.csv")
    for name in ("temperature", "potential_energy", "total_energy", "pressure"):
        end, begin = ends[name][-1], begins[name][0]
        t.check(abs(end - begin) < 1e-10 * (1 + abs(end)), f"{name} ends at {end} and goes on from {begin}")


def from_final_xyz(t):
    continued(t, "first/final.xyz")


def from_a_run_directory(t):
    continued(t, "first")


def from_a_trajectory(t):
    t.deck(("thermo = { every = 5 }", 'trajectory = { format = "xyz", every = 10, velocities = true }'))
    t.run_well("run", "deck.toml", "--quiet", "--out", "first")
    t.deck((LATTICE, 'file = "first/trajectory.xyz"\n'), ("density = 0.8442\n", ""))
    t.run_well("run", "deck.toml", "--quiet", "--out", "second")


def new_density(t):
    t.deck()
    t.run_well("run", "deck.toml", "--quiet", "--out", "first")
    t.deck((LATTICE, 'file = "first"\n'), ("density = 0.8442", "density = 0.7"))
    t.run_well("run", "deck.toml", "--quiet", "--out", "second")
    t.check(abs(t.json("second/results.json")["system"]["density"] - 0.7) < 1e-12, "density")


def new_velocities(t):
    t.deck()
    t.run_well("run", "deck.toml", "--quiet", "--out", "first")
    t.deck((LATTICE, 'file = "first"\nvelocities = "maxwell"\n'), ("temperature = 1.0", "temperature = 0.5"))
    t.run_well("run", "deck.toml", "--quiet", "--out", "second")
    t.check(abs(t.columns("second/thermo.csv")["temperature"][0] - 0.5) < 1e-12, "temperature of the start")


def random_start(t):
    t.deck(('type = "fcc", cells = 3', 'type = "random", atoms = 100'), ("cutoff = 2.5", "cutoff = 2.4"))
    t.run_well("run", "deck.toml", "--quiet")
    columns = t.columns("runs/deck/thermo.csv")
    t.check(abs(columns["temperature"][0] - 1.0) < 1e-12, "temperature of the start")
    t.check(columns["potential_energy"][0] < 0, "overlaps were not relaxed")


def wca(t):
    """Weeks, Chandler and Andersen: Lennard-Jones shifted at its minimum; no energy is negative."""
    t.deck(("cutoff = 2.5", "cutoff = 1.122462048309373"), ('truncation = "cut"\ntail = true', 'truncation = "shifted"'))
    t.run_well("run", "deck.toml", "--quiet")
    t.check(min(t.columns("runs/deck/thermo.csv")["potential_energy"]) >= 0, "an energy below zero")


def morse(t):
    t.deck(('type = "lennard-jones"', 'type = "morse"\nwell_depth = 1.0\nsteepness = 6.0\nminimum = 1.1225'), ("tail = true", "tail = true"))
    t.run_well("run", "deck.toml", "--quiet")
    t.check(all(map(math.isfinite, t.columns("runs/deck/thermo.csv")["pressure"])), "pressure")


def two_atoms_by_hand(t):
    """r = 1.5 in a box of 6: U = 4 (1.5^-12 - 1.5^-6), W = 24 (2 1.5^-12 - 1.5^-6), without tail."""
    (t.dir / "pair.xyz").write_text(XYZ.format(count=2, atoms="Ar 0.1 0 0\nAr 4.6 0 0"))  # nearest image: 1.5 apart
    t.deck(("tail = true", "tail = false"), ("steps = 20", "steps = 0"), ("steps = 40", "steps = 0"), text=PAIR)
    t.run_well("run", "deck.toml", "--quiet")
    found = t.json("runs/deck/results.json")["observables"]
    t.check(abs(2 * found["potential_energy"]["mean"] - 4 * (1.5**-12 - 1.5**-6)) < 1e-12, "U")
    t.check(abs(found["virial"]["mean"] - 24 * (2 * 1.5**-12 - 1.5**-6)) < 1e-11, "W")


def bad_start(name, content, deck=PAIR):
    def test(t):
        if content is not None:
            (t.dir / "pair.xyz").write_bytes(content if isinstance(content, bytes) else content.encode())
        t.deck(text=deck)
        before = t.files()
        result = t.expect(3, t.run("run", "deck.toml"))
        t.equal(result.out, "", "stdout")
        t.equal(t.files(), before, "files")
        t.golden(result.err)
    return Case(name, test)


def cutoff_and_box_of_a_file(t):
    """The box is known only when the file is read; the cutoff is checked then."""
    (t.dir / "pair.xyz").write_text(XYZ.format(count=2, atoms="Ar 0 0 0\nAr 1.5 0 0"))
    t.deck(("cutoff = 2.5", "cutoff = 3.5"), text=PAIR)
    t.golden(t.expect(2, t.run("run", "deck.toml")).err)


def moving_centre(t):
    """A start that drifts is brought to rest, aloud."""
    text = XYZ.format(count=2, atoms="Ar 0 0 0 1 0 0\nAr 1.5 0 0 1 0 0").replace("pos:R:3", "pos:R:3:velo:R:3")
    (t.dir / "pair.xyz").write_text(text)
    t.deck(("temperature = 1.0\n", ""), ('thermostat = { type = "rescale", every = 5 }\n', ""), text=PAIR)
    result = t.run_well("run", "deck.toml")
    t.contains(result.err, "warning: the centre of mass moved with 1 sigma/tau; its motion was removed\n")


def compressed(t):
    """What gzip has compressed starts as it is."""
    text = XYZ.format(count=2, atoms="Ar 0.1 0 0\nAr 4.6 0 0")
    t.deck(("steps = 20", "steps = 0"), ("steps = 40", "steps = 0"), text=PAIR)
    energies = []
    for content in (text.encode(), gzip.compress(text.encode())):
        (t.dir / "pair.xyz").write_bytes(content)
        t.run_well("run", "deck.toml", "--quiet", "--force")
        energies.append(t.json("runs/deck/results.json")["observables"]["potential_energy"]["mean"])
    t.equal(energies[1], energies[0], "energy")


def decompression_bomb(t):
    """1 GB of atoms in 1 MB: refused, in little memory."""
    atoms = b"Ar 0 0 0\n" * 600_000
    with open(t.dir / "pair.xyz", "wb") as file:
        file.write(gzip.compress('1000000000\nLattice="9 0 0 0 9 0 0 0 9"\n'.encode()))
        member = gzip.compress(atoms)
        for _ in range(200):
            file.write(member)
    t.deck(text=PAIR)
    t.contains(t.expect(3, t.run("run", "deck.toml")).err, "pair.xyz:")
    t.contains(t.run("run", "deck.toml").err, "the gzip file unpacks to more than")
    taken = 1024 * resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
    t.check(taken < 5e8, f"{taken / 1e6:.0f} MB of memory taken")


def comment_beside_the_file(t):
    """Positions of CP2K, in angstrom."""
    (t.dir / "pair.xyz").write_text("2\n i = 1, time = 0.500, E = -12.5\nAr 0 0 0\nAr 5.1075 0 0\n")
    deck = PAIR.replace('file = "pair.xyz"\n',
                        """file = "pair.xyz"\nxyz_comment = 'Lattice="20.43 0 0 0 20.43 0 0 0 20.43" units=si'\n""")
    t.deck(("steps = 20", "steps = 0"), ("steps = 40", "steps = 0"), ("tail = true", "tail = false"), text=deck + ARGON)
    t.run_well("run", "deck.toml", "--quiet")
    found = t.json("runs/deck/results.json")["observables"]
    t.check(abs(2 * found["potential_energy"]["mean"] - 4 * (1.5**-12 - 1.5**-6)) < 1e-12, "U")
    t.deck(('density = 0.8442\n', 'density = 0.8442\nxyz_comment = "units=si"\n'))
    refused = t.expect(2, t.run("check", "deck.toml")).err
    t.deck(text=deck + ARGON)
    (t.dir / "pair.xyz").write_text(XYZ.format(count=2, atoms="Ar 0 0 0\nAr 1.5 0 0"))
    refused += t.expect(3, t.run("run", "deck.toml")).err
    t.golden(refused)


def cutoff_of_half_an_edge(t):
    """Typed as half of an edge that the grid of the box rounds down, or that is a difference of bounds."""
    data = "\n\n2 atoms\n1 atom types\n0.1 10.36 xlo xhi\n0.1 10.36 ylo yhi\n0.1 10.36 zlo zhi\n\nAtoms\n\n1 1 1 1 1\n2 1 2.5 1 1\n"
    lattice = XYZ.format(count=2, atoms="Ar 0 0 0\nAr 1.5 0 0")
    for content, cutoff in ((lattice.replace("6 0 0 0 6 0 0 0 6", "EDGE 0 0 0 EDGE 0 0 0 EDGE".replace("EDGE", str(edge))), edge / 2)
                            for edge in HALVED):
        (t.dir / "pair.xyz").write_text(content)
        t.deck(("cutoff = 2.5", f"cutoff = {cutoff!r}"), text=PAIR)
        t.run_well("run", "deck.toml", "--quiet", "--force")
    (t.dir / "pair.xyz").write_text(data)
    t.deck(("cutoff = 2.5", "cutoff = 5.13"), text=PAIR)
    t.run_well("run", "deck.toml", "--quiet", "--force")
    t.deck(("cutoff = 2.5", "cutoff = 5.1300001"), text=PAIR)
    t.contains(t.expect(2, t.run("run", "deck.toml", "--force")).err, "more than half the box")


def cases():
    if len(published()) != 8:
        raise Failure("published.csv does not hold 8 rows")
    result = [Case(f"NIST configuration {row['config']}, rc = {row['rc']}", nist(row)) for row in published()]
    result += [Case(test.__name__.replace("_", " "), test)
               for test in (from_final_xyz, from_a_run_directory, from_a_trajectory, new_density, new_velocities, random_start,
                            wca, morse, compressed, decompression_bomb, comment_beside_the_file, cutoff_of_half_an_edge,
                            two_atoms_by_hand, cutoff_and_box_of_a_file, moving_centre)]
    good = "Ar 0 0 0\nAr 1.5 0 0"
    return result + [
        bad_start("missing start file", None),
        bad_start("start from a directory without a run", None, PAIR.replace("pair.xyz", ".")),
        bad_start("start from an empty file", ""),
        bad_start("start from a text", "dear diary\n"),
        bad_start("start in UTF-16", XYZ.format(count=2, atoms=good).encode("utf-16")),
        bad_start("start with lines that end in CR", XYZ.format(count=2, atoms=good).replace("\n", "\r")),
        bad_start("start from a damaged HDF5 file", b"\x89HDF\r\n\x1a\n"),
        bad_start("start with a tilted box", XYZ.format(count=2, atoms=good).replace("0 0 0 6\"", "0 0 0.1 6\"")),
        bad_start("start with an atom too few", XYZ.format(count=3, atoms=good)),
        bad_start("start with a nan", XYZ.format(count=2, atoms="Ar 0 0 0\nAr nan 0 0")),
        bad_start("start with coincident atoms", XYZ.format(count=2, atoms="Ar 1 1 1\nAr 1 1 1")),
        bad_start("start with atoms a box apart", XYZ.format(count=2, atoms="Ar 1 1 1\nAr 7 1 1")),
        bad_start("start with atoms that all but coincide", XYZ.format(count=2, atoms="Ar 1 1 1\nAr 1.0000000000000002 1 1")),
        bad_start("start with a flat box", XYZ.format(count=2, atoms=good).replace("0 6\"", "0 0\"")),
        bad_start("start with a huge box", XYZ.format(count=2, atoms=good).replace("6", "1e200")),
        bad_start("start without a box", XYZ.format(count=2, atoms=good).replace('Lattice="6 0 0 0 6 0 0 0 6" ', "")),
        bad_start("start with 10^12 atoms", XYZ.format(count=10**12, atoms=good)),
        bad_start("start without velocities or temperature", XYZ.format(count=2, atoms=good),
                  PAIR.replace("temperature = 1.0\n", "").replace("thermostat =", "temperature = 1.0\nthermostat =")),
        bad_start("velocities of a file that has none", XYZ.format(count=2, atoms=good),
                  PAIR.replace("temperature = 1.0\n", 'temperature = 1.0\nvelocities = "file"\n')),
    ]
