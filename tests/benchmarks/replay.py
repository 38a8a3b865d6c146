"""Steps of many ranks on a simulated network, by SimGrid's replay of traces (smpirun, Debian: libsimgrid-dev).

A trace has what a rank does in a step, in the order of the program: positions begin to pass to and from the ranks of its
halo; the decision whether the list is still good; half of the atoms of inner tiles as computing; the positions are there;
the atoms of tiles with ghosts of other ranks; forces begin to pass; the other half; the forces are there; the decision
whether a checkpoint is due. What goes between which ranks is counted by the program `decomposition --messages`.

Two networks: "links" is that of the model on paper, a link of BANDWIDTH in each direction for every rank, with a switch
between them that never is the bottleneck. "tree" has computers of CORES ranks that share a link, and a fat tree of
switches with half as many links up as down. A message costs no processor time on either.
"""

from __future__ import annotations

import os
import re
import resource
import shutil
import subprocess
import time
from pathlib import Path
from typing import Any, Iterator

from programs import ProgramFailed
from rank_model import BANDWIDTH, BYTES_OF_FORCE, BYTES_OF_POSITION, LATENCY

NETWORKS = ("links", "tree")
# Atoms and ranks: a million, a hundred million, and some 100,000 a rank.
RUNS = (*((1_000_000, ranks) for ranks in (8, 64)), *((100_000_000, ranks) for ranks in (8, 64, 512, 1024, 4096, 10_000)),
        *((100_000 * ranks, ranks) for ranks in (8, 64, 512, 1024)))
LARGEST = {"links": 10_000, "tree": 512}  # ranks that the simulator manages in minutes
STEPS = 3
CORES = 16  # ranks of a computer of "tree"
LINK = 12.5e9  # bytes/s of its link, in each direction
MEMORY_BANDWIDTH = 10e9  # bytes/s between two ranks of a computer
LEAF = 16  # computers at a switch of the lowest level
# Of SimGrid 3.32: the selectors of collective algorithms crash with 256 ranks; sends that nobody waits for are looked up
# in one list of them all; the model of SMPI has factors of an old Ethernet.
OPTIONS = ("network/model:CM02", "network/crosstraffic:0", "smpi/allreduce:rdb", "smpi/host-speed:1Gf", "smpi/send-is-detached-thresh:0",
           "contexts/stack-size:256", "contexts/guard-size:0")  # of 10,000 ranks a guard page each is too many
# Of more ranks messages take turns at a link of "links": so the time of the simulator is proportional to their number. A
# decision then waits for positions that are on their way. On a tree they would hold up each other's links.
SIDE_BY_SIDE = 64
TURNS = "maxmin/concurrency-limit:1"
PLATFORM = """<?xml version='1.0'?>
<!DOCTYPE platform SYSTEM "https://simgrid.org/simgrid.dtd">
<platform version="4.1">
<cluster id="all" prefix="host" suffix="" radical="0-{last}" speed="1Gf" {rest}/>
</platform>
"""
HALF = LATENCY / 2  # of a link: a message takes two


def installed() -> bool:
    return shutil.which("smpirun") is not None


def transfers(decomposition: dict[str, Any], part: int, size: int) -> tuple[list[dict[int, int]], list[dict[int, int]]]:
    """Bytes that each rank sends and receives, by the other rank. `part`: 1 for positions, 2 for forces."""
    sent: list[dict[int, int]] = [{} for _ in decomposition["asked"]]
    received: list[dict[int, int]] = [{} for _ in decomposition["asked"]]
    for one in decomposition["asked"]:
        for entry in one["parts"]:
            count = round(size * entry[part])
            # Positions come from the other rank, forces go to it.
            source, target = (entry[0], one["rank"]) if part == 1 else (one["rank"], entry[0])
            if count > 0:
                sent[source][target] = received[target][source] = count
    return sent, received


def actions(rank: int, exchanges: list[Any], inner: float, outer: float) -> Iterator[str]:
    """A step. `exchanges`: of positions and of forces; `inner`, `outer`: computing of tiles without and with ghosts of other ranks [s]."""
    def begin(sent: list[dict[int, int]], received: list[dict[int, int]]) -> Iterator[str]:
        yield from (f"{rank} irecv {other} 0 {count} 6" for other, count in received[rank].items())
        yield from (f"{rank} isend {other} 0 {count} 6" for other, count in sent[rank].items())

    def compute(seconds: float) -> str:
        return f"{rank} compute {seconds * 1e9:.0f}"

    positions, forces = exchanges
    yield from begin(*positions)
    yield f"{rank} allreduce 1 0 0"
    yield compute(inner / 2)
    yield f"{rank} waitall"
    yield compute(outer)
    yield from begin(*forces)
    yield compute(inner / 2)
    yield f"{rank} waitall"
    yield f"{rank} allreduce 1 0 0"


def write_traces(decomposition: dict[str, Any], cost: float, steps: int, folder: Path) -> Path:
    """A trace for each rank. `cost`: seconds for an atom and step. Returns the file that names them."""
    exchanges = [transfers(decomposition, 1, BYTES_OF_POSITION), transfers(decomposition, 2, BYTES_OF_FORCE)]
    names = []
    for one in decomposition["asked"]:
        rank = one["rank"]
        step = "\n".join(actions(rank, exchanges, cost * one["inner"], cost * (one["atoms"] - one["inner"])))
        path = folder / f"{rank}.trace"
        path.write_text("\n".join([f"{rank} init", *[step] * steps, f"{rank} finalize"]) + "\n")
        names.append(str(path))
    traces = folder / "traces"
    traces.write_text("\n".join(names) + "\n")
    return traces


def write_platform(network: str, ranks: int, folder: Path) -> tuple[Path, Path]:
    """The platform, and the file that says where each rank runs."""
    hosts, cores, rest = ranks, 1, f'bw="{BANDWIDTH}Bps" lat="{HALF}s" sharing_policy="SPLITDUPLEX"'
    if network == "tree":
        cores = CORES
        used = -(-ranks // CORES)
        leaves = -(-used // LEAF)
        hosts = leaves * LEAF
        rest = (f'core="{CORES}" bw="{LINK}Bps" lat="{HALF}s" sharing_policy="SPLITDUPLEX" loopback_bw="{MEMORY_BANDWIDTH}Bps" '
                f'loopback_lat="{HALF}s" topology="FAT_TREE" topo_parameters="2;{LEAF},{leaves};1,{LEAF // 2};1,1"')
    platform, places = folder / "platform.xml", folder / "hosts"
    platform.write_text(PLATFORM.format(last=hosts - 1, rest=rest))
    places.write_text("".join(f"host{rank // cores}\n" for rank in range(ranks)))
    return platform, places


def simulated(decomposition: dict[str, Any], cost: float, network: str, folder: Path, steps: int = STEPS) -> dict[str, Any]:
    """Seconds of a step, and what part of the ideal rate that leaves."""
    ranks = decomposition["ranks"]
    traces = write_traces(decomposition, cost, steps, folder)
    platform, places = write_platform(network, ranks, folder)
    options = (*OPTIONS, TURNS) if network == "links" and ranks > SIDE_BY_SIDE else OPTIONS
    command = ["smpirun", "-quiet", "-platform", str(platform), "-hostfile", str(places), "-np", str(ranks), "-replay", str(traces),
               "--log=replay.thres:critical", *(f"--cfg={option}" for option in options)]
    files = resource.getrlimit(resource.RLIMIT_NOFILE)
    start = time.monotonic()
    process = subprocess.Popen(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace",
                               preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_NOFILE, (files[1], files[1])))
    assert process.stdout is not None
    said = process.stdout.read()
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    found = re.search(r"Simulation time (\S+)", said)
    if process.returncode != 0 or not found:
        raise ProgramFailed(f"smpirun: exit code {process.returncode}: {said.strip()[-300:]}")
    step = float(found.group(1)) / steps
    return {"atoms": decomposition["atoms"], "ranks": ranks, "network": network, "steps": steps, "step": step,
            "efficiency": cost * decomposition["atoms"] / ranks / step,
            "simulator": {"seconds": time.monotonic() - start, "mebibytes": usage.ru_maxrss / 1024}}
