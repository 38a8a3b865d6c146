#!/usr/bin/env python3
"""What Python costs beside the engine: control after each step, views, copies by id, observables,
external forces, two simulations at once.

    tools/python tests/benchmarks/python_overhead.py

Prints medians of several rounds. Nothing is asserted.
"""

import multiprocessing
import queue
import statistics
import sys
import threading
import time
import warnings

import numpy as np

import ljmd


def liquid(atoms: int, steps: int) -> ljmd.Deck:
    deck = ljmd.Deck.fluid(atoms=atoms, seed=3)
    deck.stages = [ljmd.Stage("production", steps, sample=True)]
    deck.output.thermo = {"every": 1000}
    return deck


def seconds(work, clock) -> float:
    began = clock()
    work()
    return clock() - began


def medians(rounds: int, clock=time.process_time, **works) -> dict:
    """Of interleaved rounds; processor time by default, which other programs disturb less."""
    times = {name: [] for name in works}
    for _ in range(rounds):
        for name, work in works.items():
            times[name].append(seconds(work, clock))
    return {name: statistics.median(each) for name, each in times.items()}


def control_after_each_step():
    count = 400
    for atoms in (108, 864):
        deck = liquid(atoms, 1000 * count)
        if atoms == 108:
            deck.potential.cutoff = 2.0
        sims = [ljmd.Simulation(deck) for _ in range(2)]

        def step_by_step():
            for _ in sims[0].steps(count, every=1):
                pass

        found = medians(21, engine=lambda: sims[1].advance(count), python=step_by_step)
        print(f"sim.steps(n, every=1), {atoms} atoms: {1e6 * (found['python'] - found['engine']) / count:.2f} us a step more than "
              f"the engine's {1e6 * found['engine'] / count:.1f} us")


def views_and_copies():
    sim = ljmd.Simulation(liquid(864, 1000))
    sim.advance(100)

    def views():
        for _ in range(1000):
            with sim.arrays() as a:
                a.positions

    print(f"zero-copy view of 864 atoms: {1e3 * medians(9, views=views)['views']:.2f} us")
    sim = ljmd.Simulation(liquid(1_000_188, 10))
    sim.advance(3)
    source = sim.velocities
    found = medians(9, memcpy=source.copy, velocities=lambda: sim.velocities, positions=lambda: sim.positions)
    print(f"copies by id of {sim.atoms} atoms: velocities {1e3 * found['velocities']:.1f} ms, positions "
          f"{1e3 * found['positions']:.1f} ms, numpy's copy of as many bytes {1e3 * found['memcpy']:.1f} ms")


def observables():
    count = 1000
    deck = liquid(864, count)
    functions = [ljmd.observable(lambda s: 0.0, every=1, name="nothing"),
                 ljmd.observable(lambda s: s.velocities[0, 0], every=1, name="velocity")]
    found = medians(7, without=lambda: deck.run(progress=False),
                    nothing=lambda: deck.run(observables=functions[:1], progress=False),
                    velocity=lambda: deck.run(observables=functions[1:], progress=False))
    for name in ("nothing", "velocity"):
        print(f"observable at every step, {name}: {1e6 * (found[name] - found['without']) / count:.1f} us a call")


def external_forces():
    count = 1000
    deck = liquid(864, count)
    nothing = np.zeros((864, 3))

    def trap(s):
        return -0.1 * (s.positions - 0.5 * s.edges)

    def trap_with_energy(s):
        d = s.positions - 0.5 * s.edges
        return -0.1 * d, 0.05 * np.vdot(d, d)

    forces = {"zeros": ljmd.external_force(lambda s: nothing), "a trap": ljmd.external_force(trap),
              "a trap with energy": ljmd.external_force(trap_with_energy, energy=True)}
    sims = {name: ljmd.Simulation(deck, external=force) for name, force in forces.items()}
    sims["without"] = ljmd.Simulation(deck)
    part = count // 20
    found = medians(19, **{name: lambda sim=sim: sim.advance(part) for name, sim in sims.items()})
    for name in forces:
        print(f"external force of 864 atoms, {name}: {1e6 * (found[name] - found['without']) / part:.1f} us a step more than "
              f"the engine's {1e6 * found['without'] / part:.1f} us")


def pairs():
    count = 300
    own = liquid(864, count)
    own.potential = ljmd.pair(lambda r: 4 * (r**-12 - r**-6), cutoff=2.5, truncation="shifted")
    built_in = liquid(864, count)
    built_in.potential = dict(type="lennard-jones", cutoff=2.5, truncation="shifted")
    found = medians(5, own=lambda: own.run(progress=False), built_in=lambda: built_in.run(progress=False))
    print(f"pair potential as a table: {found['own'] / found['built_in']:.1f} times the built-in one's time")


def run_when_all_are_ready(gate, times) -> None:
    """One of two runs that begin together. Puts the times of its beginning and its end into `times`."""
    warnings.simplefilter("ignore")  # a new process has the usual filter
    deck = liquid(2048, 1000)
    gate.wait()
    began = time.monotonic()
    deck.run(progress=False)
    times.put((began, time.monotonic()))


def two_at_once(workers, times) -> float:
    """Seconds from the first beginning to the last end."""
    for worker in workers:
        worker.start()
    found = [times.get() for _ in workers]
    for worker in workers:
        worker.join()
    return max(end for _, end in found) - min(began for began, _ in found)


def two_threads():
    def in_threads():
        gate, times = threading.Barrier(2), queue.Queue()
        return two_at_once([threading.Thread(target=run_when_all_are_ready, args=(gate, times)) for _ in range(2)], times)

    def in_processes():
        new = multiprocessing.get_context("spawn")
        gate, times = new.Barrier(2), new.Queue()
        return two_at_once([new.Process(target=run_when_all_are_ready, args=(gate, times)) for _ in range(2)], times)

    pairs = [(in_threads(), in_processes()) for _ in range(15)]
    ratios = sorted(a / b for a, b in pairs)
    print(f"two simulations in two threads of Python: {statistics.median(ratios):.3f} times the time of two processes at once "
          f"(quartiles {ratios[3]:.3f} and {ratios[11]:.3f} of {len(ratios)} pairs)")


if __name__ == "__main__":
    warnings.simplefilter("ignore")
    print(f"ljmd {ljmd.__version__}, {ljmd.build()['build_type']}, {ljmd.build()['simd']}, NumPy {np.__version__}, "
          f"Python {sys.version.split()[0]}")
    control_after_each_step()
    views_and_copies()
    observables()
    external_forces()
    pairs()
    two_threads()
