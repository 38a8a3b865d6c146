"""What a run has left in its directory, read by NumPy and the standard library alone, each file checked as it is read.

    from ljmd.reading import fluids
    fluids.load(pathlib.Path("runs/first")).thermo["pressure"]

This is the only reader of run directories in Python: `ljmd.open` and `ljmd.open_sweep` use it, and so do the pictures
(analysis/). It takes nothing of the compiled part of the package, so that any Python will do, 3.9 or later. Runs that go
on, were stopped or have failed are read up to the last whole row or frame. What cannot be used raises DataError, which
names file, line and column; InputError stands for a path or a kind of run that was not asked for.

    files           texts and JSON, and fields of JSON by their types
    tables          CSV
    records         run.json: what a directory holds
    observables     means with standard errors
    stages          the stages of a run, as results.json or its deck has them
    fluids          runs of a fluid
    few_bodies      runs of few bodies
    trajectories    frames, in the units of their file: CSV, H5MD (takes h5py), extended XYZ
    sweeps          sweeps and replicas
    comparisons     comparisons with other programs
    reproductions   reproduced tables
    decks           decks as tables (takes Python 3.11 or tomli)
"""
