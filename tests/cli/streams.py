"""stdout, stderr and terminals: who is told what, and what happens when nobody listens."""

import json
import os
import re
import subprocess

from harness import DECK, Case, Skip, clean_environment, on_a_terminal

LONG = DECK.replace("steps = 40", "steps = 400")  # long enough for a few lines of progress
RATE = r"\[(melt|production)\] +\d+ % step \d+/\d+  [\d.e+]+ steps/s  [\d.e+]+ atom-steps/s  ETA (\d+:)*\d+"


def plain_lines_off_a_terminal(t):
    t.deck(text=LONG)
    err = t.run_well("run", "deck.toml").err
    t.check("\r" not in err and "\x1b" not in err, "control characters off a terminal")
    t.check(err.endswith("\n"), "the last line is open")
    t.contains(err, "stage 'melt': 20 steps of 0.004 tau\n")
    t.contains(err, "stage 'production': 400 steps of 0.004 tau\n")
    lines = [line for line in err.splitlines() if line.startswith("[")]
    t.check(lines, "no progress")
    for line in lines:
        t.check(re.fullmatch(RATE, line), f"not a line of progress: {line!r}")
    t.check(len(lines) <= 11, f"{len(lines)} lines of progress")


def words_of_others(t):
    """A title, a time and a path that hold what a terminal would obey."""
    t.deck(('title = "small"', 'title = "small\\u001b]0;owned\\u0007"'))
    (t.dir / "deck.toml").rename(t.dir / "deck\x1b[2J.toml")
    result = t.run_well("run", "deck\x1b[2J.toml", "--out", "out")
    texts = [result.out, result.err, t.read("out/results.txt")]
    record = t.json("out/run.json")
    (t.dir / "out/run.json").write_text(json.dumps({**record, "began": "\x9b31mnow\nfinished      never"}))
    texts += [t.run_well("info", "out").out, t.run_well("info", "out", "--json").out, t.expect(3, t.run("info", "\x1b[2J")).err]
    (t.dir / "out/run.json").write_text(json.dumps({**record, "deck": "\x1b[2J = \x9b"}))
    texts.append(t.expect(3, t.run("info", "out")).err)
    for text in texts:
        t.check(not re.search("[\x00-\x08\x0b-\x1f\x7f-\x9f]", text), f"a control character in {text!r}")
    t.contains(texts[3], "began         ?31mnow?finished      never\n")


def one_line_on_a_terminal(t):
    t.deck(text=LONG)
    code, out, err = on_a_terminal(t, "run", "deck.toml")
    t.equal(code, 0, "exit code")
    renewed = re.findall(r"\r\x1b\[\?7l(\[[^\r\n\x1b]*)\x1b\[J\x1b\[\?7h\r", err)
    t.check(len(renewed) >= 2, f"the line was renewed {len(renewed)} times:\n{err!r}")
    last = err.split("\r\x1b[?7l\x1b[J")[-1]
    t.check("steps/s" not in last, f"progress is left on the screen: {last!r}")
    t.check("\x1b" not in out, "control characters on stdout")


def an_error_on_a_terminal(t):
    """An error in the middle of a run stands on a line of its own."""
    t.deck(("density = 0.8442", "density = 0.5"), ("temperature = 1.0", "temperature = 20.0"),
           ("time_step = 0.004\nsteps = 20", "time_step = 0.05\nsteps = 2000"),
           ('thermostat = { type = "rescale", every = 5 }\n', ""))
    code, _, err = on_a_terminal(t, "run", "deck.toml", "--force")
    t.equal(code, 5, "exit code")
    t.check(re.search(r"(^|\n|\x1b\[\?7h\r)error: step", err), f"the error does not begin a line: {err!r}")


def stdout_holds_results_only(t):
    t.deck(text=LONG)
    loud = t.run_well("run", "deck.toml", "--out", "a")
    quiet = t.run_well("run", "deck.toml", "--out", "b", "--quiet")
    t.equal(loud.out.replace("files: a", ""), quiet.out.replace("files: b", ""), "stdout with and without --quiet")
    t.check("steps/s" not in loud.out and "stage 'melt'" not in loud.out, "talk on stdout")


def quiet_is_quiet(t):
    """With --quiet nothing is said but doubts about the results."""
    t.deck(("sample = true", "sample = true\ntemperature = 2.0"))  # a warning about the deck
    err = t.run_well("run", "deck.toml", "--quiet").err
    results = t.json("runs/deck/results.json")
    t.equal(err.splitlines(), [f"warning: {warning}" for warning in results["warnings"]], "stderr with --quiet")
    t.check(any("crystal" in warning for warning in results["warnings"]), "a crystal was sampled without a word")


def warnings_of_a_short_run(t):
    t.deck()
    t.golden(t.run_well("run", "deck.toml", "--quiet").err)


def closed(stream, code):
    def test(t):
        t.deck(("thermo = { every = 5 }", 'thermo = { every = 1 }\ntrajectory = { format = "xyz", every = 1 }'))
        result = t.expect(code, t.shell(f'"$LJMD" run deck.toml {stream}'))
        t.run_well("run", "deck.toml", "--quiet", "--out", "open")
        for name in ("thermo.csv", "trajectory.xyz", "final.xyz", "results.json"):
            t.equal(t.read(f"runs/deck/{name}"), t.read(f"open/{name}"), f"{name} with {stream}")
        if code == 4 and "2>" not in stream:
            t.contains(result.err, "error: standard output: the results could not be written: ")
    return test


def full_stdout(t):
    if not os.path.exists("/dev/full"):
        raise Skip("no /dev/full")
    for arguments in ("info --keys", "--help", "run --help", "--version"):
        result = t.expect(4, t.shell(f'"$LJMD" {arguments} >/dev/full'))
        t.equal(result.err, "error: standard output: the results could not be written: No space left on device\n",
                f"stderr of {arguments}")


def full_stderr(t):
    if not os.path.exists("/dev/full"):
        raise Skip("no /dev/full")
    t.deck()
    t.expect(0, t.shell('"$LJMD" run deck.toml 2>/dev/full'))
    t.check((t.dir / "runs/deck/results.json").exists(), "no results")


def pipe_into_head(t):
    """The reader takes one line and goes: no message, no harm."""
    t.deck()
    for command in ('"$LJMD" info --keys', '"$LJMD" run deck.toml --quiet --force', '"$LJMD" info'):
        result = t.expect(0, t.shell(f"{command} | head -1"))
        t.equal(len(result.out.splitlines()), 1, f"lines of {command} | head -1")
        t.check("error:" not in result.err, f"stderr: {result.err}")


def reader_gone(t):
    """Nobody reads stdout at all: the program ends as filters do, by SIGPIPE, when its files are complete."""
    t.deck()
    ours, theirs = os.pipe()
    os.close(ours)
    try:
        result = t.run("run", "deck.toml", "--quiet", capture_output=False, stdout=theirs, stderr=subprocess.PIPE)
    finally:
        os.close(theirs)
    t.equal(result.code, -13, "exit code (13: SIGPIPE)")
    t.equal(t.json("runs/deck/run.json")["finished"], True, "finished")


def stderr_reader_gone(t):
    """Nobody reads the talk: the run goes on."""
    t.deck(text=LONG)
    ours, theirs = os.pipe()
    os.close(ours)
    try:
        t.expect(0, t.run("run", "deck.toml", capture_output=False, stdout=subprocess.PIPE, stderr=theirs))
    finally:
        os.close(theirs)


def locale_with_decimal_comma(t):
    """No locale reaches a file or a message."""
    known = subprocess.run(["locale", "-a"], capture_output=True, check=False).stdout.decode().split()
    german = next((name for name in known if name.lower() in ("de_de.utf8", "de_de.utf-8", "de_de")), None)
    if german is None:
        raise Skip("no de_DE locale")
    t.deck()
    for out, locale in (("c", "C"), ("de", german)):
        t.run_well("run", "deck.toml", "--quiet", "--out", out, env={**clean_environment(), "LC_ALL": locale})
    for name in ("thermo.csv", "final.xyz", "results.json"):
        t.equal(t.read(f"de/{name}"), t.read(f"c/{name}"), f"{name} in {german}")


def cases():
    return [Case(test.__name__.replace("_", " "), test)
            for test in (plain_lines_off_a_terminal, words_of_others, one_line_on_a_terminal, an_error_on_a_terminal, stdout_holds_results_only,
                         quiet_is_quiet, warnings_of_a_short_run, full_stdout, full_stderr, pipe_into_head, reader_gone,
                         stderr_reader_gone, locale_with_decimal_comma)] + [
        Case("closed stdin", closed("<&-", 0)), Case("closed stdout", closed(">&-", 4)),
        Case("closed stderr", closed("2>&-", 0)), Case("all closed", closed("<&- >&- 2>&-", 4))]
