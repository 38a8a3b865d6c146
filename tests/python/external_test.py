"""External forces in Python: the physics, the bits, and every kind of wrong answer."""

import gc
import json
import threading
import unittest
import warnings
import weakref

import numpy as np

import ljmd
from alarm import Alarm, a_while
from cases import Case, comet, command_line, long_deck, small_deck


@ljmd.external_force(energy=True)
def wave(s):
    """U = 2 cos(2 pi x/L)"""
    k = 2 * np.pi / s.edges[0]
    phase = k * s.positions[:, 0]
    forces = np.zeros_like(s.positions)
    forces[:, 0] = 2 * k * np.sin(phase)
    return forces, 2 * np.cos(phase).sum()


def uniform(s):
    return np.tile([0.0, 0.0, -1.5], (s.atoms, 1))


def ends_with(force, **changes):
    """A run of the small deck in memory, under this force."""
    return small_deck(**changes).run(external=force, progress=False)


class Physics(Case):
    def test_the_total_energy_has_the_external_one_and_is_conserved(self):
        deck = small_deck()
        deck.output.thermo = {"every": 1}
        deck.stages = deck.stages[1:]
        run = deck.run(external=wave, progress=False)
        rows = run.thermo
        np.testing.assert_allclose(rows["total_energy"],
                                   rows["potential_energy"] + rows["kinetic_energy"] + rows["external_energy"], atol=1e-12)
        self.assertGreater(np.ptp(rows["external_energy"]), 0.05)
        self.assertLess(np.ptp(rows["total_energy"]), 0.002)
        self.assertAlmostEqual(run["external_energy"].mean, rows["external_energy"][1:].mean(), 10)

    def test_energies_of_one_moment_have_it_too(self):
        sim = ljmd.Simulation(small_deck(), external=wave)
        sim.advance(7)
        expected = 2 * np.cos(2 * np.pi * sim.positions[:, 0] / sim.edges[0]).mean()
        self.assertAlmostEqual(sim.external_energy, expected, 12)
        self.assertAlmostEqual(sim.total_energy, sim.potential_energy + sim.kinetic_energy + expected, 12)
        self.assertIsNone(ljmd.Simulation(small_deck()).external_energy)

        @ljmd.observable(every=10, energy=True)
        def above_mean(s):
            return s.total_energy - s.kinetic_energy - s.potential_energy - s.external_energy

        self.assertLess(abs(small_deck().run(external=wave, observables=[above_mean], progress=False)["above_mean"].mean), 1e-12)

    def test_energies_of_each_atom_are_added_up(self):
        one = ends_with(wave)
        each = ljmd.external_force(lambda s: (wave(s)[0], 2 * np.cos(2 * np.pi * s.positions[:, 0] / s.edges[0])), energy=True,
                                   name="wave")
        np.testing.assert_allclose(ends_with(each).thermo["external_energy"], one.thermo["external_energy"], atol=1e-12)

    def test_a_uniform_force_accelerates_all_atoms(self):
        deck = small_deck()
        deck.stages = deck.stages[1:]
        sim = ljmd.Simulation(deck, external=uniform)
        sim.run(progress=False)
        np.testing.assert_allclose(sim.velocities.mean(axis=0), [0, 0, -1.5 * sim.time], atol=1e-12)
        self.assertNotIn("external_energy", sim.results())

    def test_a_uniform_force_leaves_diffusion_as_it_is_and_another_leaves_it_without_a_value(self):
        deck = small_deck()
        deck.analysis.msd(max_time=0.08, every=1)
        runs = [deck.run(external=force, progress=False) for force in (None, uniform, wave)]
        self.assertAlmostEqual(runs[1]["diffusion"].mean / runs[0]["diffusion"].mean, 1.0, 4)
        self.assertTrue(np.isnan(runs[2]["diffusion"].mean))
        self.assertIn("the external force 'wave' differs between atoms", runs[2]["diffusion"].remark)

    def test_a_force_of_time_sees_the_time_of_the_positions(self):
        times = []

        def drive(s):
            times.append(s.time)
            return np.full((s.atoms, 3), [np.cos(7 * s.time), 0, 0])

        deck = small_deck(temperature=0.0)
        deck.stages = [ljmd.Stage("only", 100, time_step=0.004)]
        sim = ljmd.Simulation(deck, external=drive)
        sim.advance(100)
        np.testing.assert_allclose(times, 0.004 * np.arange(101), atol=1e-12)
        self.assertAlmostEqual(sim.velocities[:, 0].mean(), np.sin(7 * 0.4) / 7, 4)

    def test_a_barostat_takes_a_virial(self):
        deck = small_deck()
        deck.stages = [ljmd.Stage("only", 20, temperature=1.0, thermostat="langevin",
                                  barostat={"type": "stochastic-cell-rescaling", "pressure": 1.0})]
        self.assertRaisesText(ljmd.InputError, "needs the virial of the external force 'wave'",
                              of=lambda: deck.run(external=wave, progress=False))
        self.assertRaisesText(ljmd.InputError, "needs the virial",
                              of=lambda: deck.run(self.folder / "refused", external=wave, progress=False))
        scaled = ljmd.external_force(lambda s: (*wave(s), np.zeros((3, 3))), energy=True, virial=True)
        self.assertIn("density", deck.run(external=scaled, progress=False).thermo)

    def test_the_virial_is_in_the_pressure(self):
        given = np.diag([3.0, 2.0, 1.0])
        with_it = ljmd.external_force(lambda s: (np.zeros((s.atoms, 3)), given), virial=True)
        without, found = ljmd.Simulation(small_deck()), ljmd.Simulation(small_deck(), external=with_it)
        self.assertAlmostEqual(found.pressure - without.pressure, 2.0 / np.prod(without.edges), 12)


class Bits(Case):
    def test_a_directory_and_threads_change_no_bit(self):
        one = ends_with(wave)
        for threads in (1, 2):
            run = small_deck().run(self.folder / f"run{threads}", external=wave, threads=threads, progress=False)
            self.assertEqual(run.stages, one.stages)
            self.assertEqual(run["external_energy"], one["external_energy"])
            np.testing.assert_array_equal(run.thermo, one.thermo)
            self.assertEqual(list(run.thermo), list(one.thermo))

    def test_the_record_names_it_and_the_command_line_refuses_to_go_on_without_it(self):
        run, folder = small_deck().run(self.folder / "run", external=wave, progress=False), self.folder / "run"
        record = json.loads((folder / "run.json").read_text(encoding="utf-8"))
        self.assertEqual((record["given"]["by"], record["given"]["external_force"]), ("Python", "wave"))
        before = (folder / "results.json").read_bytes()
        done = command_line("resume", folder, "--steps", "+10")
        self.assertEqual(done.returncode, 6)
        self.assertIn("was run with the external force 'wave' of a program in Python", done.stderr)
        self.assertIn(f'ljmd.resume("{folder}", external=wave) in Python', done.stderr)
        self.assertIn("run with      the external force 'wave'", command_line("info", folder).stdout)
        self.assertIn("the external force 'wave' is a force of the program",
                      command_line("export", folder, "--to", "lammps", "--out", self.folder / "x").stderr)
        self.assertEqual(command_line("export", folder, "--to", "extxyz", "--out", self.folder / "y").returncode, 0)
        self.assertRaises(ljmd.CheckpointError, ljmd.resume, folder, steps=10, external=uniform, progress=False)
        self.assertEqual((folder / "results.json").read_bytes(), before)
        again = ljmd.resume(folder, external=wave, progress=False)
        self.assertEqual(again.stages, run.stages)
        self.assertEqual(ljmd.resume(folder, progress=False).stages, run.stages)  # this process has it

    def test_an_interrupted_run_is_resumed_with_the_same_bits(self):
        """Interrupted twice, because it has no end; its rows are those of a run in one piece, and a run that is stopped at
        its first step has the results, too."""
        def deck(steps):
            made = long_deck(steps, atoms=108)
            made.potential.cutoff = 2.0
            return made

        parts = self.folder / "parts"
        with Alarm() as alarm:
            deck(10**9).run(parts, external=wave, progress=alarm.tell)
        self.assertFalse(ljmd.open(parts).finished)
        first = len(ljmd.open(parts).thermo)
        with Alarm() as alarm:
            ljmd.resume(parts, external=wave, progress=alarm.tell)
        found = ljmd.open(parts).thermo
        self.assertGreater(len(found), first)
        whole = deck(int(found["step"].max())).run(external=wave, progress=False)
        np.testing.assert_array_equal(found, whole.thermo[:len(found)])
        short = self.folder / "short"
        self.assertRaises(ljmd.Interrupted, deck(300).run, short, external=wave, walltime=1e-9, progress=False)
        again, whole = ljmd.resume(short, external=wave, progress=False), deck(300).run(external=wave, progress=False)
        self.assertEqual(again.stages, whole.stages)
        self.assertEqual(again["external_energy"], whole["external_energy"])

    def test_checkpoints_in_memory(self):
        sim = ljmd.Simulation(small_deck(), external=wave)
        sim.advance(33)
        twin = ljmd.Simulation(small_deck(), external=wave)
        twin.restore(sim.checkpoint())
        sim.advance(27)
        twin.advance(27)
        np.testing.assert_array_equal(twin.positions, sim.positions)
        self.assertRaises(ljmd.CheckpointError, ljmd.Simulation(small_deck()).restore, sim.checkpoint())


class Answers(Case):
    def test_arrays_of_any_real_type_and_layout_are_taken(self):
        expected = ends_with(uniform).stages
        read_only = np.tile([0.0, 0.0, -1.5], (108, 1))
        read_only.flags.writeable = False
        wide = np.zeros((216, 6))
        wide[::2, 4] = -1.5
        for forces in (read_only, np.asfortranarray(read_only), wide[::2, ::2], read_only.astype(np.float32),
                       read_only[::-1], np.broadcast_to([0.0, 0.0, -1.5], (108, 3)), read_only.tolist(),
                       read_only.astype(">f8"), np.ma.masked_array(read_only)):
            self.assertEqual(ends_with(lambda s, f=forces: f).stages, expected)
        whole_numbers = ends_with(lambda s: np.zeros((108, 3), dtype=int)).stages
        self.assertEqual(whole_numbers[-1]["checksum_at_end"], small_deck().run(progress=False).stages[-1]["checksum_at_end"])

    def test_other_answers_are_one_clear_message(self):
        zeros = np.zeros((108, 3))
        for wrong, text in ((None, "returned as forces is NoneType, not an array of real numbers"), ("text", "is str, not"), (1.0, "shape ()"),
                            (np.zeros((3, 108)), "returned forces of the shape (3, 108): it is (108, 3)"),
                            (np.zeros(3), "shape (3,)"), (np.zeros((107, 3)), "shape (107, 3)"), ([[1], [2, 3]], "is list, not"),
                            (zeros.astype(complex), "ndarray of complex128, not"), (zeros.astype(object), "object"),
                            (zeros.astype(str), "<U32"),
                            (zeros > 1, "bool"), ((zeros, 1.0), "2 things, expected forces alone")):
            self.assertRaisesText(ljmd.InputError, text, of=lambda w=wrong: ends_with(lambda s: w))
        for wrong, text in ((zeros, "ndarray alone, expected (forces, energy)"), ((zeros, None), "the energy of external force"),
                            ((zeros, zeros), "energy of the shape (108, 3)"), ((zeros, 1.0, zeros), "3 things")):
            force = ljmd.external_force(lambda s, w=wrong: w, energy=True)
            self.assertRaisesText(ljmd.InputError, text, of=lambda f=force: ends_with(f))
        force = ljmd.external_force(lambda s: (zeros, np.zeros(3)), virial=True)
        self.assertRaisesText(ljmd.InputError, "virial of the shape (3,): it is (3, 3)", of=lambda: ends_with(force))

    def test_what_is_not_finite_is_a_physics_error_with_the_atom(self):
        broken = np.zeros((108, 3))
        broken[16, 2] = np.nan
        self.assertRaisesText(ljmd.PhysicsError, "external force 'mine' on atom 17", "not finite",
                              of=lambda: ends_with(ljmd.external_force(lambda s: broken, name="mine")))
        energy = ljmd.external_force(lambda s: (np.zeros((108, 3)), np.inf), energy=True)
        self.assertRaisesText(ljmd.PhysicsError, "the energy of the external force", of=lambda: ends_with(energy))

    def test_what_is_no_force_is_refused(self):
        for wrong in (5, "wave", ljmd.external_force()):
            self.assertRaises(ljmd.InputError, small_deck().run, external=wrong, progress=False)
        self.assertRaisesText(ljmd.InputError, "few bodies", of=lambda: comet().run(external=uniform, progress=False))
        self.assertRaisesText(ljmd.InputError, "few bodies", of=lambda: comet().run(self.folder / "c", external=uniform, progress=False))
        deck = small_deck()
        deck.analysis.viscosity()
        self.assertRaisesText(ljmd.InputError, "homogeneous fluid", of=lambda: deck.run(external=wave, progress=False))
        self.assertRaisesText(ljmd.InputError, "printable", of=lambda: ends_with(ljmd.external_force(uniform, name="a\nb")))
        self.assertEqual(repr(wave), "<ljmd.external_force 'wave': with energy>")
        self.assertEqual(wave.__doc__, "U = 2 cos(2 pi x/L)")

    def test_what_it_raises_ends_the_run(self):
        class Enough(Exception):
            pass

        def late(s):
            if s.time > 0.1:
                raise Enough
            return uniform(s)

        sim = ljmd.Simulation(small_deck(), external=late)
        self.assertRaises(Enough, sim.run, progress=False)
        self.assertEqual(sim.velocities.shape, (108, 3))
        self.assertRaises(ljmd.InputError, sim.advance, 1)
        self.assertRaises(Enough, small_deck().run, self.folder / "run", external=late, progress=False)
        self.assertRaises(Enough, ljmd.resume, self.folder / "run", external=late, progress=False)

    def test_positions_are_seen_during_the_call_alone(self):
        kept = []

        def keep(s):
            kept.append(s)
            return uniform(s)

        ends_with(keep)
        self.assertRaisesText(ljmd.InputError, "has ended", of=lambda: kept[0].positions)

    def test_it_cannot_look_at_its_own_simulation(self):
        def look(s):
            if s.time > 0:
                sim.positions
            return uniform(s)

        sim = ljmd.Simulation(small_deck(), external=look)
        self.assertRaises(ljmd.InUseError, sim.advance, 1)


class Lifetime(Case):
    def test_one_that_never_returns_is_interrupted(self):
        for directory in (None, self.folder / "endless"):
            with Alarm() as alarm:
                def endless(s):
                    return alarm.never_returns() if s.time > 0 else uniform(s)

                long_deck().run(directory, external=endless, progress=False)

    def test_a_quick_one_that_is_interrupted_is_called_again(self):
        def slow(s):
            a_while()
            return uniform(s)

        deck = long_deck(300, atoms=108)
        deck.potential.cutoff = 2.0
        whole = deck.run(external=uniform, progress=False)
        sim = ljmd.Simulation(deck, external=slow)
        with Alarm() as alarm:
            sim.run(progress=alarm.tell)
        self.assertLess(sim.step, 300)
        self.assertEqual(sim.run(progress=False).stages[-1]["checksum_at_end"], whole.stages[-1]["checksum_at_end"])

    def test_it_is_let_go_with_its_simulation(self):
        class Force:
            def __call__(self, s):
                return uniform(s)

        force = Force()
        gone = weakref.ref(force)
        sim = ljmd.Simulation(small_deck(), external=force)
        sim.advance(3)
        del sim, force
        gc.collect()
        self.assertIsNone(gone())

    def test_one_force_in_two_threads_of_python(self):
        alone = ends_with(wave).stages
        found = [None, None]

        def run(k):
            found[k] = ends_with(wave).stages

        threads = [threading.Thread(target=run, args=(k,)) for k in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(found, [alone, alone])


if __name__ == "__main__":
    warnings.simplefilter("ignore", ljmd.RunWarning)
    unittest.main(warnings="ignore")
