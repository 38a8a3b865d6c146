"""Values of the wrong type are refused where they are given, by name; those of NumPy count as those of Python."""

import unittest
import warnings

import numpy as np

import ljmd
from cases import Case, small_deck

SITES = np.stack(np.meshgrid(*[np.arange(5) * 1.4] * 3, indexing="ij"), -1).reshape(-1, 3)
CUT = {"cutoff": 2.5, "truncation": "cut"}


def evaluated(**potential):
    return ljmd.evaluate(SITES, 7.0, potential={**CUT, **potential})


def masked(array):
    found = np.ma.array(array, mask=np.zeros_like(array, bool))
    found[1] = np.ma.masked
    return found


class Refused(Case):
    def check(self, cases):
        for text, call in cases:
            self.assertRaisesText(ljmd.InputError, text, of=call)

    def test_truth_values_are_no_text_and_no_numbers(self):
        self.check([("potential: tail", lambda: evaluated(tail="false")), ("potential: tail", lambda: evaluated(tail=0)),
                    ("energies", lambda: ljmd.evaluate(SITES, 7.0, energies="no")),
                    ("energy", lambda: ljmd.observable(energy="no")), ("energy", lambda: ljmd.external_force(energy=1)),
                    ("virial", lambda: ljmd.external_force(virial=None)), ("force", lambda: small_deck().run(force="no")),
                    ("force", lambda: small_deck().sweep({"system.density": [0.8]}, force="no", directory=self.folder / "a")),
                    ("force", lambda: small_deck().compare(force="no")),
                    ("replace", lambda: small_deck().run(self.folder / "b", replace="no")),
                    ("metastable", lambda: ljmd.reference(1.0, 0.1, metastable="no")),
                    ("energies", lambda: ljmd.trajectory(self.folder / "c", energies="no"))])

    def test_numbers_are_no_text_no_truth_values_and_real(self):
        self.check([("potential: cutoff", lambda: evaluated(cutoff="2.5")), ("potential: cutoff", lambda: evaluated(cutoff=True)),
                    ("potential: cutoff", lambda: evaluated(cutoff=np.complex128(2.5 + 1j))),
                    ("skin", lambda: ljmd.Evaluator(skin="0.3")), ("cutoff", lambda: ljmd.pair(np.exp, cutoff=None, truncation="cut")),
                    ("start", lambda: ljmd.pair(np.exp, cutoff=2.0, truncation="cut", start="0.5")),
                    ("error", lambda: ljmd.pair(np.exp, cutoff=2.0, truncation="cut", error="small")),
                    ("temperature", lambda: ljmd.pair(np.exp, cutoff=2.0, truncation="cut").second_virial("1")),
                    ("temperature", lambda: ljmd.eos("1.5", 0.5)), ("temperature", lambda: ljmd.eos(np.complex128(1.5 + 1j), 0.5)),
                    ("density", lambda: ljmd.eos(1.5, [0.5, None])), ("density", lambda: ljmd.eos(1.5, ["0.5"])),
                    ("temperature", lambda: ljmd.reference("1.0", 0.8)), ("energy", lambda: ljmd.reference(1.0, 0.8, errors={"energy": "1"})),
                    ("walltime", lambda: small_deck().run(self.folder / "a", walltime=True)),
                    ("start", lambda: ljmd.trajectory(self.folder / "a", start="0"))])

    def test_text_is_text(self):
        self.check([("unit", lambda: ljmd.observable(unit=None)), ("name", lambda: ljmd.observable(name=3)),
                    ("name", lambda: ljmd.external_force(name=None)), ("simd", lambda: small_deck().run(simd=3)),
                    ("simd", lambda: ljmd.evaluate(SITES, 7.0, simd=3)), ("precision", lambda: ljmd.evaluate(SITES, 7.0, precision=2)),
                    ("potential: type", lambda: evaluated(type=None)), ("truncation", lambda: ljmd.pair(np.exp, cutoff=2.0, truncation=None)),
                    ("model", lambda: ljmd.eos(1.5, 0.5, model=2016)), ("group", lambda: ljmd.trajectory(self.folder / "a", group=3)),
                    ("positions", lambda: ljmd.trajectory(self.folder / "a", positions=3))])

    def test_lists_and_tables_are_such(self):
        def given(name, value):
            deck = small_deck()
            setattr(deck, name, value)

        self.check([("observables: ", lambda value=value: small_deck().run(observables=value)) for value in (None, 3, "fastest", {"a": 1})] +
                   [("stages", lambda value=value: given("stages", value)) for value in (None, 3, [3], "melt")] +
                   [("analysis", lambda value=value: given("analysis", value)) for value in (3, "rdf", ["rdf"], {"rdf": 200})] +
                   [("points", lambda: small_deck().sweep(None)), ("properties", lambda: ljmd.reference(1.0, 0.8, properties=[1])),
                    ("a table of errors by name", lambda: ljmd.reference(1.0, 0.8, errors=0.01)), ("deck", lambda: ljmd.trajectory(self.folder / "a", deck="argon.toml")),
                    ("sample", lambda: ljmd.Stage("all", 3, sample="no")), ("reverse", lambda: ljmd.Stage("all", 3, reverse=1)),
                    ("threads: True is no whole number", lambda: small_deck().run(threads=True))])

    def test_arrays_hold_real_numbers_all_of_them(self):
        self.check([("positions: some of its numbers are masked", lambda: ljmd.evaluate(masked(SITES), 7.0)),
                    ("positions: an array of real numbers", lambda: ljmd.evaluate(SITES.astype(complex), 7.0)),
                    ("positions: an array of real numbers", lambda: ljmd.evaluate(SITES.astype(str), 7.0)),
                    ("positions: an array of real numbers", lambda: ljmd.evaluate([[1, 2, 3], [1, 2]], 7.0)),
                    ("edges", lambda: ljmd.evaluate(SITES, "7.0")), ("edges", lambda: ljmd.evaluate(SITES, ["7", "7", "7"])),
                    ("density: some of its numbers are masked", lambda: ljmd.eos(1.5, masked(np.array([0.1, 0.2])))),
                    ("density: the array is empty", lambda: ljmd.eos(1.5, np.array([]))),
                    ("distances", lambda: ljmd.pair(np.exp, cutoff=2.0, truncation="cut")("1.0")),
                    ("not an energy for each", lambda: ljmd.pair(lambda r: r + 0j, cutoff=2.0, truncation="cut"))])

    def test_a_switch_belongs_to_a_switched_potential(self):
        self.check([("switch_start has no meaning for truncation = \"cut\"", lambda: evaluated(switch_start=2.0)),
                    ("switch_start has no meaning",
                     lambda: ljmd.pair(np.exp, cutoff=2.5, truncation="shifted", switch_start=2.0))])

    def test_an_observable_is_a_real_number(self):
        for value in (2.5 + 7j, np.complex128(2.5 + 7j), np.complex64(2.5 + 7j), np.array(2.5 + 7j)):
            own = ljmd.observable(lambda s, value=value: value, name="mine")
            self.assertRaisesText(ljmd.InputError, "observable 'mine' returned complex" if np.isscalar(value) else "'mine' returned",
                                  of=lambda own=own: small_deck().run(observables=[own], progress=False))


class Taken(Case):
    def test_values_of_numpy_are_those_of_python(self):
        for tail in (True, False):
            self.assertEqual(evaluated(tail=np.bool_(tail), cutoff=np.float32(2.5)).potential_energy, evaluated(tail=tail).potential_energy)
        self.assertTrue(small_deck().run(self.folder / "run", walltime=np.int64(100), progress=False).finished)
        self.assertEqual(ljmd.eos(np.array(1.5), np.float64(0.5)).data, ljmd.eos(1.5, 0.5).data)
        own = [ljmd.observable(lambda s, value=value: value, name=name)
               for name, value in (("a", np.float32(2.5)), ("b", np.int16(2)), ("c", np.array([2.5])), ("d", np.bool_(True)))]
        run = small_deck().run(observables=own, progress=False)
        self.assertEqual([run[name].mean for name in "abcd"], [2.5, 2.0, 2.5, 1.0])

    def test_an_array_without_masked_numbers_is_an_array(self):
        expected = ljmd.evaluate(SITES, 7.0).forces
        for array in (np.ma.masked_array(SITES), SITES.astype(object), SITES.astype(">f8")):
            np.testing.assert_array_equal(ljmd.evaluate(array, 7.0).forces, expected)


if __name__ == "__main__":
    warnings.simplefilter("ignore", ljmd.RunWarning)
    unittest.main(warnings="ignore")
