"""The notebooks of docs/notebooks, executed in a short form, and what they find. Each is copied to an empty folder and runs there: it
needs the package and nothing else of the repository, as one that was installed or downloaded.

Usage: notebooks_test.py [NAME]       one notebook, without the end .ipynb; without a name how all are stored

The values in the cell with the tag `parameters` are replaced by shorter ones. After the last cell another one checks results.
PYTHONPATH has the package. The numbers are the same on every processor.
"""

import ast
import os
import pathlib
import re
import shutil
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve()
sys.path.insert(0, str(HERE.parents[1]))

import keeper  # noqa: E402
import waiting  # noqa: E402

try:
    import ipykernel  # noqa: F401
    import nbclient
    import nbformat
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

FOLDER = HERE.parents[2] / "docs/notebooks"

# Name: the parameters of the short form, and what holds at the end.
CASES = {
    "argon-1967": (dict(steps=5000), """
        assert abs(T.mean - 0.76) < 0.03
        assert abs(found["potential_energy"].mean - there.potential_energy) < 5 * found["potential_energy"].error + 0.02
        assert abs(found["compressibility_factor"].mean - 0.78) < 5 * found["compressibility_factor"].error + 0.05
        assert 2.6 < g[peak] < 3.4 and 1.05 < r[peak] < 1.13, (g[peak], r[peak])
        assert abs(einstein.mean - kubo.mean) < 5 * np.hypot(einstein.error, kubo.error)
        assert abs(einstein.mean * unit / (einstein.si.mean * 1e-9) - 1) < 1e-3             # nm^2/ns
        """),
    "phase-diagram": (dict(steps=4000, temperatures=[0.9, 1.5]), """
        assert len(deviations) > 20 and np.median(np.abs(deviations)) < 1.5, deviations   # short runs have guessed errors
        assert all(p.min() < -0.05 for p, _ in loops.values())                       # a loop, in boxes of both sizes
        pressure, vapour, liquid = binodal[0.9][0]
        expected = ljmd.eos(0.9, model=model)
        assert abs(pressure / expected.pressure - 1) < 0.2
        assert abs(vapour / expected.vapour.density - 1) < 0.2 and abs(liquid / expected.liquid.density - 1) < 0.05
        """),
    "integrators-and-the-comet": (dict(orbits=50), """
        assert all(abs(order[name] - expected[name]) < 0.1 for name in methods), order
        assert largest["leapfrog"][-1] < 1.01 * largest["leapfrog"][0]              # no drift
        assert largest["rk2-midpoint"][-1] > 5 * largest["rk2-midpoint"][0]
        assert back["bit-reversible"] == 0 and back["leapfrog"] < 1e-9 < back["rk2-midpoint"]
        assert abs(found["first_apocentre"].mean / (half_axis * (1 + eccentricity)) - 1) < 2e-3
        """),
    "your-own-potential": (dict(steps=1000), """
        assert difference < 1e-7
        assert all(error.max() <= stated for error, stated in zip(errors.values(), [table.error, table.force_error]))
        assert abs(run["longest_wave"].mean - structure_factor(k_min)) < 0.04
        wide = rdf["r"] > 1
        assert np.abs(rdf["g"] - pair_correlation(rdf["r"].to_numpy()))[wide].max() < 0.05
        assert 0 < run["closest_pair"].mean < 0.4 and run["closest_pair"].error > 0
        """),
    "verifying-another-engine": (dict(steps=400), """
        assert max(agreement["ASE, default", "shifted"]) < 1e-10
        assert max(agreement["ASE, default", "cut"][1:]) < 1e-10 < agreement["ASE, default", "cut"][0]
        assert agreement["ASE, smooth=True", "ljmd.pair(smoothed)"][0] < rebuilt.error
        for name, calculator in mistakes.items():
            assert (max(differences(calculator, ours["shifted"])) < 1e-10) == (name == "none"), name
        assert apart["ASE, its own forces"][10] < 1e-10 and apart["ASE, forces of ljmd"][10] < 1e-10
        assert abs(a - b) < 0.01                                             # in 400 steps both are one trajectory
        """),
}


def shortened(source: str, values: dict) -> str:
    """The parameters with other values; a name that the cell does not set is a mistake."""
    for name, value in values.items():
        source, count = re.subn(rf"^{name} = .*$", f"{name} = {value!r}", source, flags=re.M)
        assert count == 1, f"the cell of parameters does not set {name}"
    return source


def code_cells(notebook) -> list:
    return [cell for cell in notebook.cells if cell.cell_type == "code"]


def execute(name: str, folder: str) -> None:
    values, checks = CASES[name]
    notebook = nbformat.read(shutil.copy(FOLDER / f"{name}.ipynb", folder), as_version=4)
    parameters = [cell for cell in code_cells(notebook) if "parameters" in cell.metadata.get("tags", [])]
    assert len(parameters) == 1, "one cell has the tag `parameters`"
    parameters[0].source = shortened(parameters[0].source, values)
    drawn = sum("plt.subplots" in cell.source for cell in code_cells(notebook))
    checks = re.sub(r"^ {8}", "", checks.strip("\n"), flags=re.M)
    ast.parse(checks)
    notebook.cells.append(nbformat.v4.new_code_cell(checks))
    os.environ.update({"IPYTHONDIR": f"{folder}/ipython", "JUPYTER_RUNTIME_DIR": f"{folder}/runtime"})  # not at home
    client = nbclient.NotebookClient(notebook, timeout=waiting.PATIENCE, kernel_name="python3", resources={"metadata": {"path": folder}})
    client.execute()  # raises what a cell raises
    outputs = [each for cell in code_cells(notebook) for each in cell.outputs]
    pictures = sum("image/png" in each.get("data", {}) for each in outputs)
    assert pictures == drawn > 0, f"{pictures} pictures, {drawn} figures"
    said = "".join(each.text for each in outputs if each.output_type == "stream" and each.name == "stderr")
    odd = re.findall(r"^.*(?:Deprecation|User|Future|Runtime)Warning.*$|^.*\r.*$", said, re.M)  # a bar would leave an empty red box
    assert not odd, odd


def check_stored() -> None:
    """Without outputs, with a kernel of any version, listed on the page, with links that lead somewhere."""
    stored = {path.stem for path in FOLDER.glob("*.ipynb")}
    assert stored == set(CASES), f"{stored} are stored, {set(CASES)} are tested"
    page = (FOLDER / "README.md").read_text(encoding="utf-8")
    for name in sorted(stored):
        notebook = nbformat.read(FOLDER / f"{name}.ipynb", as_version=4)
        nbformat.validate(notebook)
        assert f"]({name}.ipynb)" in page, f"{name} is not on the page"
        assert notebook.metadata.kernelspec.name == "python3"
        assert "version" not in notebook.metadata.language_info
        for cell in code_cells(notebook):
            assert not cell.outputs and cell.execution_count is None, (
                f"{name}: stored with outputs; tools/python -m nbconvert --clear-output --inplace docs/notebooks/{name}.ipynb")
        for cell in notebook.cells:
            for target in re.findall(r"\]\(([^)#:]+)(?:#[^)]*)?\)", cell.source) if cell.cell_type == "markdown" else []:
                assert (FOLDER / target).exists(), f"{name}: link to {target}"


def main() -> None:
    if len(sys.argv) > 1:
        execute(sys.argv[1], tempfile.gettempdir())
    else:
        check_stored()


if __name__ == "__main__":
    sys.exit(keeper.kept(main))
