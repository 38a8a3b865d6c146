"""ASE: the calculator and the conversion of atoms."""

import copy
import pickle
import unittest
import warnings

import numpy as np

import ljmd
from cases import Case, comet, small_deck

try:
    from ase import units
    from ase.build import bulk
    from ase.calculators.calculator import PropertyNotImplementedError
    from ase.calculators.lj import LennardJones
    from ase.md.verlet import VelocityVerlet
except ImportError:
    raise SystemExit("skipped: there is no ASE")

import ljmd.ase

ARGON = dict(sigma=3.405, epsilon=0.0103235)


def crystal(cells=3, rattled=0.1, edge=5.3, seed=1):
    """fcc argon with moved atoms, in an orthorhombic box that is no cube."""
    atoms = bulk("Ar", "fcc", a=edge, cubic=True).repeat((cells, cells, cells + 1))
    atoms.rattle(rattled, seed=seed)
    return atoms


def liquid(**changes):
    """A simulation of a small liquid in reduced units."""
    sim = ljmd.Simulation(small_deck(**changes))
    sim.advance(20)
    return sim


class Calculators(Case):
    def test_in_reduced_units_forces_and_energy_are_those_of_the_program_to_the_last_bit(self):
        for truncation in ("cut", "shifted", "force-shifted"):
            sim = ljmd.Simulation(small_deck(atoms=864, truncation=truncation, tail=False if truncation == "cut" else None))
            atoms = ljmd.ase.to_atoms(sim)
            atoms.calc = ljmd.ase.Calculator(cutoff=2.0, truncation=truncation)
            np.testing.assert_array_equal(atoms.get_forces(), sim.forces)
            self.assertEqual(atoms.get_potential_energy() / 864, sim.potential_energy)

    def test_other_units_are_a_factor(self):
        sim = liquid()
        reduced = ljmd.ase.to_atoms(sim)
        reduced.calc = ljmd.ase.Calculator(cutoff=2.0)
        atoms = ljmd.ase.to_atoms(sim, **ARGON, mass=39.948, symbol="Ar")
        atoms.calc = ljmd.ase.Calculator(**ARGON, cutoff=2.0 * ARGON["sigma"])
        scale = ARGON["epsilon"] / ARGON["sigma"]
        np.testing.assert_allclose(atoms.get_forces(), scale * reduced.get_forces(), rtol=0, atol=1e-11 * scale)
        self.assertAlmostEqual(atoms.get_potential_energy() / ARGON["epsilon"], reduced.get_potential_energy(), 9)
        np.testing.assert_allclose(atoms.get_stress() * ARGON["sigma"]**3 / ARGON["epsilon"], reduced.get_stress(), atol=1e-12)
        kinetic = sim.kinetic_energy * 108 * ARGON["epsilon"]
        self.assertAlmostEqual(atoms.get_kinetic_energy(), kinetic, 12)

    def test_it_is_lennard_jones_of_ase(self):
        atoms = crystal()
        theirs = atoms.copy()
        theirs.calc = LennardJones(**ARGON, rc=7.9)
        atoms.calc = ljmd.ase.Calculator(**ARGON, cutoff=7.9)
        for ours, expected in ((atoms.get_potential_energy(), theirs.get_potential_energy()),
                               (atoms.get_forces(), theirs.get_forces()), (atoms.get_stress(), theirs.get_stress()),
                               (atoms.get_potential_energies(), theirs.get_potential_energies())):
            np.testing.assert_allclose(ours, expected, rtol=1e-10, atol=1e-12)
        self.assertEqual(atoms.calc.get_property("free_energy", atoms), atoms.get_potential_energy())

    def test_the_stress_is_the_derivative_of_the_energy_by_strain(self):
        for options in (dict(truncation="shifted"), dict(truncation="force-shifted"),
                        dict(truncation="switched", switch_start=6.5)):
            atoms = crystal(rattled=0.05)
            atoms.set_cell(atoms.cell * [1.0, 1.02, 0.97], scale_atoms=True)
            calculator = ljmd.ase.Calculator(**ARGON, cutoff=7.6, **options)
            atoms.calc = calculator
            found = atoms.get_stress()
            for k, axis in enumerate(range(3)):
                energies = []
                for strain in (-1e-6, 1e-6):
                    strained = atoms.copy()
                    factor = np.ones(3)
                    factor[axis] += strain
                    strained.set_cell(atoms.cell * factor, scale_atoms=True)
                    strained.calc = calculator
                    energies.append(strained.get_potential_energy())
                slope = (energies[1] - energies[0]) / 2e-6 / atoms.get_volume()
                # A pair that crosses a cutoff within the strain jumps in the force, not in the energy.
                self.assertAlmostEqual(found[k], slope, delta=3e-6 * max(1e-3, abs(found).max()) + 2e-8)
            virial = sum(np.outer(r, f) for r, f in zip(*self.pairs(atoms, calculator, options)))
            np.testing.assert_allclose(found, -virial[[0, 1, 2, 1, 0, 0], [0, 1, 2, 2, 2, 1]] / atoms.get_volume(), atol=1e-12)

    def pairs(self, atoms, calculator, options):
        """Separations of all pairs within the cutoff, and the forces between them, of two atoms each."""
        from ase.neighborlist import neighbor_list
        i, j, d = neighbor_list("ijD", atoms, 7.6)
        d = d[i < j]
        sigma, epsilon = ARGON["sigma"], ARGON["epsilon"]
        potential = {**calculator._evaluator._potential}
        forces = [-ljmd.evaluate([[0, 0, 0], each / sigma], 100, potential=potential).forces[0] * epsilon / sigma for each in d]
        return d, forces

    def test_velocity_verlet_of_ase_follows_the_trajectory_of_the_program(self):
        for units_of in (dict(), dict(**ARGON, mass=39.948)):
            sigma, epsilon, mass = (units_of.get(name, 1.0) for name in ("sigma", "epsilon", "mass"))
            sim = ljmd.Simulation(small_deck(truncation="force-shifted"))
            sim.advance(20)  # the thermostat's stage
            atoms = ljmd.ase.to_atoms(sim, **units_of)
            atoms.calc = ljmd.ase.Calculator(sigma=sigma, epsilon=epsilon, cutoff=2.0 * sigma, truncation="force-shifted")
            tau = sigma * np.sqrt(mass / epsilon)
            dynamics = VelocityVerlet(atoms, 0.004 * tau)
            begin = sim.unwrapped
            for _ in sim.steps(40, every=10):
                dynamics.run(10)
                np.testing.assert_allclose(atoms.positions / sigma, sim.unwrapped, rtol=0, atol=1e-10)
                np.testing.assert_allclose(atoms.get_velocities() * np.sqrt(mass / epsilon), sim.velocities, rtol=0, atol=1e-9)
            self.assertGreater(np.abs(sim.unwrapped - begin).max(), 0.1)

    def test_a_hundred_steps_in_which_atoms_cross_walls(self):
        deck = ljmd.Deck.fluid(256, 0.8, 1.5, cutoff=2.5, truncation="shifted", seed=5)
        deck.stages = [ljmd.Stage("all", 100)]
        sim = ljmd.Simulation(deck)
        atoms = ljmd.ase.to_atoms(sim)
        atoms.calc = ljmd.ase.Calculator(cutoff=2.5)
        dynamics = VelocityVerlet(atoms, 0.004)
        for _ in sim.steps(100, every=5):
            dynamics.run(5)
            atoms.wrap()
            moved = atoms.positions - sim.positions
            np.testing.assert_allclose(moved - np.round(moved / sim.edges) * sim.edges, 0, atol=1e-10)

    def test_the_tail_is_that_of_the_program(self):
        sim = ljmd.Simulation(small_deck(truncation="cut", tail=True))
        atoms = ljmd.ase.to_atoms(sim)
        atoms.calc = ljmd.ase.Calculator(cutoff=2.0, truncation="cut", tail=True)
        self.assertEqual(atoms.get_potential_energy() / 108, sim.potential_energy)
        pressure = -atoms.get_stress()[:3].mean() + sim.density * sim.temperature
        self.assertAlmostEqual(pressure, sim.pressure, 12)

    def test_pairs_of_ones_own_and_parameters(self):
        atoms = crystal()
        table = ljmd.pair(lambda r: 4 * (r**-12 - r**-6), cutoff=2.25, truncation="shifted")
        atoms.calc = ljmd.ase.Calculator(**ARGON, potential=table)
        ours = atoms.get_forces()
        atoms.calc = ljmd.ase.Calculator(**ARGON, cutoff=2.25 * ARGON["sigma"])
        np.testing.assert_allclose(ours, atoms.get_forces(), atol=1e-8)
        before = atoms.get_potential_energy()
        atoms.calc.set(epsilon=2 * ARGON["epsilon"])
        self.assertAlmostEqual(atoms.get_potential_energy(), 2 * before, 12)
        atoms.calc.set(cutoff=2.0 * ARGON["sigma"])
        self.assertNotAlmostEqual(atoms.get_potential_energy(), 2 * before, 3)
        self.assertRaises(ljmd.InputError, atoms.calc.set, cutof=3)
        self.assertRaises(ljmd.InputError, ljmd.ase.Calculator, potential=table, cutoff=3.0)

    def test_what_cannot_be_computed_is_one_clear_message(self):
        def wrong(change):
            atoms = crystal()
            change(atoms)
            atoms.calc = ljmd.ase.Calculator(**ARGON, cutoff=7.9)
            return atoms.get_forces

        for text, change in (("several kinds, Ar, Ne", lambda a: a.numbers.__setitem__(0, 10)),
                             ("periodic", lambda a: a.set_pbc([True, False, True])),
                             ("not orthorhombic", lambda a: a.set_cell(a.cell + [[0, 0.1, 0], [0, 0, 0], [0, 0, 0]])),
                             ("not orthorhombic", lambda a: a.set_cell(-a.cell)),
                             ("half the box", lambda a: a.set_cell(a.cell * [0.99, 1, 1])),
                             ("no atoms", lambda a: a.__delitem__(slice(None))),
                             ("not finite", lambda a: a.positions.__setitem__((3, 0), np.nan))):
            self.assertRaisesText(ljmd.InputError, text, of=wrong(change))
        for options in (dict(sigma=0), dict(epsilon=-1), dict(sigma="3"), dict(truncation="smooth"), dict(cutoff=np.inf),
                        dict(depth=1.0), dict(threads=0), dict(truncation="switched"), dict(tail=True),
                        dict(truncation="cut", tail="false"), dict(switch_start=2.0)):
            self.assertRaises(ljmd.InputError, ljmd.ase.Calculator, **options)
        calculator = ljmd.ase.Calculator(**ARGON, cutoff=7.9)
        for options in (dict(cutoff=[1, [2]]), dict(truncation=range(10**15)), dict(parameters_of_potential=5), dict(precision=[])):
            self.assertRaisesText(ljmd.InputError, next(iter(options)), of=lambda options=options: calculator.set(**options))
        self.assertEqual((calculator.parameters["cutoff"], calculator.parameters["precision"]), (7.9, "double"))
        for call in (lambda: ljmd.ase.Calculator(atoms=np.zeros(3)), lambda: ljmd.ase.to_deck([], self.folder / "a.xyz")):
            self.assertRaisesText(ljmd.InputError, "atoms: ", of=call)
        atoms = crystal()
        atoms.calc = ljmd.ase.Calculator(**ARGON, cutoff=7.9)
        self.assertRaises(PropertyNotImplementedError, atoms.get_dipole_moment)

    def test_a_cell_is_orthorhombic_up_to_rounding_as_in_files(self):
        atoms = crystal(cells=3)
        atoms.set_cell(np.diag(np.diag(atoms.cell)))
        calculator = ljmd.ase.Calculator(**ARGON, cutoff=7.9)
        atoms.calc = calculator
        expected = atoms.get_potential_energy()
        turned = atoms.copy()
        turned.set_cell(atoms.cell + 0.9e-12 * 15.9 * (1 - np.eye(3)))
        turned.calc = calculator
        self.assertEqual(turned.get_potential_energy(), expected)
        deck = ljmd.ase.to_deck(turned, self.folder / "start.xyz", **ARGON, cutoff=7.9, temperature=1.0)
        deck.stages = [ljmd.Stage("none", 0)]
        np.testing.assert_allclose(ljmd.Simulation(deck).edges * ARGON["sigma"], np.diag(atoms.cell), rtol=1e-12)
        turned.set_cell(atoms.cell + 1.1e-12 * 15.9 * (1 - np.eye(3)))
        self.assertRaisesText(ljmd.InputError, "not orthorhombic", of=turned.get_potential_energy)

    def test_copies_and_pickles(self):
        atoms = crystal()
        atoms.calc = ljmd.ase.Calculator(**ARGON, cutoff=7.9)
        expected = atoms.get_forces()
        for calculator in (copy.deepcopy(atoms.calc), pickle.loads(pickle.dumps(atoms.calc)),
                           ljmd.ase.Calculator(**ARGON, cutoff=7.9)):
            twin = atoms.copy()
            twin.calc = calculator
            np.testing.assert_array_equal(twin.get_forces(), expected)


class Conversions(Case):
    def test_there_and_back(self):
        sim = liquid()
        atoms = ljmd.ase.to_atoms(sim, **ARGON, mass=39.948, symbol="Ar")
        self.assertEqual(atoms.info["time"], sim.time)
        deck = ljmd.ase.to_deck(atoms, self.folder / "start.xyz", **ARGON, cutoff=2.0 * ARGON["sigma"])
        deck.stages = [ljmd.Stage("all", 40)]
        again = ljmd.Simulation(deck)
        np.testing.assert_allclose(again.positions, sim.positions, atol=1e-13)
        np.testing.assert_allclose(again.velocities, sim.velocities, atol=1e-13)
        again.advance(40)
        sim.advance(40)
        np.testing.assert_allclose(again.unwrapped - sim.unwrapped, np.round((again.unwrapped - sim.unwrapped) / sim.edges)
                                   * sim.edges, atol=1e-9)
        run = deck.run(self.folder / "run", progress=False)
        last = ljmd.ase.to_atoms(run)
        np.testing.assert_allclose(last.get_velocities(), again.velocities, atol=1e-10)

    def test_in_reduced_units_the_bits_are_kept(self):
        sim = liquid()
        deck = ljmd.ase.to_deck(ljmd.ase.to_atoms(sim), self.folder / "start.xyz", cutoff=2.0)
        deck.stages = [ljmd.Stage("all", 4)]
        again = ljmd.Simulation(deck)
        np.testing.assert_array_equal(again.positions, sim.positions)
        np.testing.assert_allclose(again.velocities, sim.velocities, atol=1e-15)  # the centre of mass is stopped once more

    def test_snapshots_runs_and_trajectories(self):
        found = []

        @ljmd.observable(every=40)
        def seen(s):
            found.append(ljmd.ase.to_atoms(s))
            return 0.0

        deck = small_deck()
        deck.output.trajectory = dict(every=20, velocities=True)
        run = deck.run(self.folder / "run", observables=[seen], progress=False)
        frames = [ljmd.ase.to_atoms(run.trajectory(), frame=k) for k in range(4)]
        last = ljmd.ase.to_atoms(run)
        np.testing.assert_allclose(frames[-1].positions, last.positions, atol=1e-12)
        np.testing.assert_allclose(frames[-1].get_velocities(), last.get_velocities(), atol=1e-12)
        self.assertEqual([round(each.info["time"], 9) for each in frames], [0.0, 0.08, 0.16, 0.24])
        np.testing.assert_allclose(found[0].positions, frames[2].positions, atol=1e-12)
        np.testing.assert_array_equal(last.get_masses(), np.ones(108))

    def test_what_cannot_be_converted_is_said(self):
        self.assertRaises(ljmd.InputError, ljmd.ase.to_atoms, ljmd.Simulation(comet()))
        self.assertRaises(ljmd.DataError, ljmd.ase.to_atoms, small_deck().run(progress=False))
        self.assertRaisesText(ljmd.InputError, "what: ", of=lambda: ljmd.ase.to_atoms(3))
        for symbol in ("", "Xyz", 5):
            self.assertRaisesText(ljmd.InputError, "symbol: ", of=lambda symbol=symbol: ljmd.ase.to_atoms(liquid(), symbol=symbol))
        deck = small_deck()
        deck.output.trajectory = dict(every=20)
        frames = deck.run(self.folder / "frames", progress=False).trajectory()
        for frame in (4, -5, 1.5, [0]):
            self.assertRaisesText(ljmd.InputError, "frame: ", of=lambda frame=frame: ljmd.ase.to_atoms(frames, frame=frame))
        self.assertRaisesText(ljmd.InputError, "frame: ", of=lambda: ljmd.ase.to_atoms(liquid(), frame={}))
        self.assertRaises(ljmd.InputError, ljmd.ase.to_atoms, liquid(), sigma=-1)
        atoms = crystal()
        to_deck = lambda: ljmd.ase.to_deck(atoms, self.folder / "a.xyz", **ARGON, cutoff=7.9)  # noqa: E731
        self.assertRaisesText(ljmd.InputError, "at rest", of=to_deck)
        atoms.set_masses([39.9] * (len(atoms) - 1) + [1.0])
        self.assertRaisesText(ljmd.InputError, "masses", of=to_deck)

    def test_atoms_at_rest_get_velocities_and_a_cell_of_any_edges(self):
        atoms = crystal()
        deck = ljmd.ase.to_deck(atoms, self.folder / "start.xyz", **ARGON, cutoff=7.9, temperature=0.3, seed=4)
        deck.stages = [ljmd.Stage("all", 2)]
        sim = ljmd.Simulation(deck)
        np.testing.assert_allclose(sim.edges * ARGON["sigma"], np.diag(atoms.cell), rtol=1e-14)
        self.assertAlmostEqual(sim.temperature, 0.3, 12)

    def test_units_are_those_of_the_deck(self):
        sigma, epsilon, mass = ljmd.ase.units()
        self.assertAlmostEqual(sigma, 3.405, 12)
        self.assertAlmostEqual(epsilon / units.kB, 119.8, 3)
        self.assertAlmostEqual(mass, 39.948, 12)
        self.assertRaises(ljmd.InputError, ljmd.ase.units, dict(sigma=3.4, epsilon="1 K", mass="1 parsec"))


if __name__ == "__main__":
    warnings.simplefilter("ignore", ljmd.RunWarning)
    unittest.main(warnings="ignore")
