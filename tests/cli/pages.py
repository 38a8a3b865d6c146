"""What tells people about the program and what begins a first run: help, version, init, the manual page, completion."""

import json
import os
import pty
import re
import select
import shutil
import subprocess
from pathlib import Path

from harness import Case, Failure, Skip, clean_environment
import waiting

ROOT = Path(__file__).resolve().parents[2]
COMMANDS = {"run", "resume", "check", "compare", "export", "bench", "eos", "reproduce", "sweep", "analyze", "info", "init",
            "help", "version", "verify", "completion"}


def need(program):
    found = shutil.which(program)
    if found is None:
        raise Skip(f"no {program}")
    return found


def commands_of(t):
    listed = t.run_well("help").out.split("Runs:\n")[1]
    return re.findall(r"^  (\w+)", listed, flags=re.M)


def help_of_commands(t):
    t.check(COMMANDS <= set(commands_of(t)), f"commands: {commands_of(t)}")
    for command in commands_of(t):
        result = t.run_well("help", command)
        t.equal(result.out.replace(f"Usage: ljmd {command}", f"Usage: {command}"),
                t.run_well(command, "--help").out.replace(f"Usage: ljmd {command}", f"Usage: {command}"), f"help of {command}")
        t.contains(result.out, f"Usage: ljmd {command}")
    t.equal(t.run_well("help").out, t.run_well("--help").out, "help of the program")


def help_of_no_command(t):
    t.golden(t.expect(2, t.run("help", "rnu")).err)


def version(t):
    t.equal(t.run_well("version").out, t.run_well("--version").out, "version")


def verify_knows_the_digits_of_this_version_on_every_level(t):
    found = json.loads(t.run_well("info", "--json").out)
    for level in found["simd_levels"]:
        if level == "x86-64-v4-intel":
            t.contains(t.expect(2, t.run("verify", "--simd", level)).err, "has digits of its own")
            continue
        result = json.loads(t.run_well("verify", "--simd", level, "--threads", 2, "--json").out)
        t.check(result["right"] and len(result["runs"]) == 3, f"{level}: {result['runs']}")
        t.equal([run["wanted"] for run in result["runs"]], [run["found"] for run in result["runs"]], level)
    t.contains(t.run_well("verify").out, "those that this version has on every machine")
    t.equal(t.files(), [], "files")


def init_writes_the_deck_of_the_readme(t):
    shown = re.search(r"```toml\n# file: first\.toml\n(.*?)```", (ROOT / "README.md").read_text(encoding="utf-8"), re.S)
    t.golden(t.run_well("init").out)
    t.equal(t.read("first.toml"), shown.group(1), "first.toml")
    t.equal(t.run_well("check", "first.toml").err, "", "warnings about the deck")


def init_writes_any_example(t):
    listed = t.run_well("init", "--list").out.splitlines()
    t.equal(t.files(), [], "files of --list")
    decks = {path.stem: path for path in (ROOT / "inputs").rglob("*.toml") if path.stem != "continue"}
    t.equal({line.split()[0] for line in listed}, set(decks), "names of --list")
    for line in listed:
        name, title = line.split(maxsplit=1)
        t.run_well("init", name)
        t.equal(t.read(f"{name}.toml"), decks[name].read_text(encoding="utf-8"), name)
        t.contains(t.read(f"{name}.toml"), f'title = "{title}"\n')
    t.run_well("init", "mine", "--example", "wca")
    t.equal(t.read("mine"), decks["wca"].read_text(encoding="utf-8"), "an example in a file of another name")


def init_replaces_nothing_unasked(t):
    (t.dir / "first.toml").write_text("mine\n", encoding="utf-8")
    (t.dir / "folder.toml").mkdir()
    (t.dir / "link.toml").symlink_to("nowhere")
    told = t.expect(2, t.run("init")).err + t.expect(2, t.run("init", "folder.toml")).err + t.expect(2, t.run("init", "link.toml")).err
    told += t.expect(2, t.run("init", "argon-846")).err + t.expect(2, t.run("init", "--example", "?")).err
    told += t.expect(4, t.run("init", "nowhere/deck.toml")).err
    t.golden(told)
    t.equal(t.read("first.toml"), "mine\n", "first.toml")
    t.equal(t.files(), ["first.toml", "folder.toml", "link.toml"], "files")
    t.run_well("init", "--force")
    t.check(t.read("first.toml") != "mine\n", "first.toml was kept with --force")


def man_page(t):
    page = t.run_well("help", "--man").out
    for command in commands_of(t):
        t.contains(page, f".SS {command}\n")
        for option in re.findall(r"^  (?:-\w,)?(--[\w-]+)", t.run_well(command, "--help").out, flags=re.M):
            of_command = page.split(f".SS {command}\n")[1].split("\n.SS ")[0]
            t.contains(of_command, option.replace("-", "\\-"))
    (t.dir / "ljmd.1").write_text(page, encoding="utf-8")
    return page


def man_page_without_warnings(t):
    man_page(t)
    warned = t.command([need("groff"), "-man", "-ww", "-z", "-Tutf8", "ljmd.1"])
    t.equal((warned.code, warned.err), (0, ""), "warnings of groff")
    shown = t.command([need("groff"), "-man", "-Tascii", "-P-cbou", "-rLL=80n", "ljmd.1"]).out
    t.check(max(map(len, shown.splitlines())) <= 80, "a line of the page is longer than the screen")
    t.contains(shown, "      --walltime TIME")


def man_page_for_mandoc(t):
    man_page(t)
    linted = t.command([need("mandoc"), "-T", "lint", "-W", "warning", "ljmd.1"])
    # a date would change with every build
    t.equal([line for line in linted.out.splitlines() if "missing date" not in line], [], "warnings of mandoc")


def with_program(t):
    """The environment in which a shell finds `ljmd`."""
    environment = clean_environment()
    return {**environment, "PATH": f"{Path(t.ljmd).parent}:{environment['PATH']}"}


class Shell:
    """An interactive shell on a pseudo-terminal, in which `ljmd` prints its arguments."""

    def __init__(self, t, command, setup):
        self.ours, theirs = pty.openpty()
        self.shell = subprocess.Popen(command, cwd=t.dir, stdin=theirs, stdout=theirs, stderr=theirs, start_new_session=True,
                                      env={**with_program(t), "TERM": "dumb", "HOME": str(t.dir), "PS1": "", "HISTFILE": ""})
        os.close(theirs)
        self.count = 0
        self.completed(setup + "\n: ")

    def completed(self, keys):
        """Type keys and a line end; the arguments that `ljmd` is called with."""
        self.count += 1
        mark = f"end-{self.count}."
        os.write(self.ours, (keys + f"\necho end-$(({self.count})).\n").encode())
        seen = b""
        while mark.encode() not in seen:  # what is typed, and echoed, has the number in $(( ))
            if not select.select([self.ours], [], [], waiting.PATIENCE)[0]:
                raise Failure(f"the shell hangs after {keys!r}: {seen!r}")
            seen += os.read(self.ours, 65536)
        arguments = re.findall(r"<([^<>\r\n]*)>(?=[<\r\n])", seen.decode().replace("printf '<%s>'", ""))
        return arguments

    def close(self):
        self.shell.kill()
        self.shell.wait()
        os.close(self.ours)


PRINTS = "ljmd() { printf '\\n'; printf '<%s>' \"$@\"; echo; }"
ALL = "\x1b*"  # readline: insert all completions


def files_to_complete(t):
    (t.dir / "my deck.toml").write_text("")
    (t.dir / "results.csv").write_text("")
    (t.dir / "runs").mkdir()
    for shell in ("bash", "fish", "zsh"):
        (t.dir / f"_ljmd.{shell}").write_text(t.run_well("completion", shell).out)


def bash_completes(t):
    files_to_complete(t)
    shell = Shell(t, [need("bash"), "--norc", "--noprofile", "-i"],
                  f"bind 'set enable-bracketed-paste off'; {PRINTS}; source _ljmd.bash")
    try:
        for keys, expected in (
                ("ljmd resu\t", ["resume"]),
                (f"ljmd c{ALL}", ["check", "compare", "completion"]),
                ("ljmd run --wall\t", ["run", "--walltime"]),
                ("ljmd run m\t", ["run", "my deck.toml"]),
                ("ljmd run res\t", ["run", "res"]),
                ("ljmd check --set system.dens\t0.8", ["check", "--set", "system.density=0.8"]),
                ("ljmd check --quiet --precision m\t m\t", ["check", "--quiet", "--precision", "mixed", "my deck.toml"]),
                ("ljmd run --out=ru\t", ["run", "--out=runs/"]),
                ("ljmd resume --steps +5 ru\t", ["resume", "--steps", "+5", "runs/"]),
                (f"ljmd compare --with {ALL}", ["compare", "--with", "gsl", "lammps", "openmm"]),
                ("ljmd analyze runs struc\t", ["analyze", "runs", "structure_factor"]),
                ("ljmd help reprod\t", ["help", "reproduce"]),
                ("ljmd export --to ext\t", ["export", "--to", "extxyz"]),
                (f"ljmd version --{ALL}", ["version", "--help"]),
                ("ljmd run --walltime \t2h", ["run", "--walltime", "2h"])):
            t.equal(shell.completed(keys), expected, repr(keys))
    finally:
        shell.close()


def zsh_completes(t):
    files_to_complete(t)
    (t.dir / "_ljmd.zsh").rename(t.dir / "_ljmd")
    shell = Shell(t, [need("zsh"), "-f", "-i"],
                  f"unsetopt prompt_cr prompt_sp; PS1=; fpath=($PWD $fpath); autoload -Uz compinit; compinit -D -u; {PRINTS}")
    try:
        for keys, expected in (
                ("ljmd resu\t", ["resume"]),
                ("ljmd run --wall\t2h", ["run", "--walltime", "2h"]),
                ("ljmd run m\t", ["run", "my deck.toml"]),
                ("ljmd check --set system.dens\t0.8", ["check", "--set", "system.density=0.8"]),
                ("ljmd analyze runs struc\t", ["analyze", "runs", "structure_factor"]),
                ("ljmd compare --with gs\t", ["compare", "--with", "gsl"])):
            t.equal(shell.completed(keys), expected, repr(keys))
    finally:
        shell.close()


def fish_completes(t):
    files_to_complete(t)
    fish = need("fish")
    for line, expected in (
            ("ljmd resu", ["resume"]), ("ljmd run --wall", ["--walltime"]), ("ljmd run --precision m", ["mixed"]),
            ("ljmd check --set system.dens", ["system.density="]), ("ljmd compare --with ", ["gsl", "lammps", "openmm"]),
            ("ljmd analyze runs struc", ["structure_factor"]), ("ljmd resume ru", ["runs/"]), ("ljmd help reprod", ["reproduce"]),
            ("ljmd run m", ["my deck.toml"])):
        result = t.expect(0, t.command([fish, "--no-config", "-c", f"source _ljmd.fish; complete -C {line!r}"],
                                       env={**with_program(t), "HOME": str(t.dir)}))
        t.equal((result.err, [found.split("\t")[0] for found in result.out.splitlines()]), ("", expected), repr(line))


def no_other_shell(t):
    t.golden(t.expect(2, t.run("completion", "tcsh")).err)


def cases():
    return [Case(test.__name__.replace("_", " "), test)
            for test in (help_of_commands, help_of_no_command, version, verify_knows_the_digits_of_this_version_on_every_level, init_writes_the_deck_of_the_readme,
                         init_writes_any_example, init_replaces_nothing_unasked, man_page, man_page_without_warnings,
                         man_page_for_mandoc, bash_completes, zsh_completes, fish_completes, no_other_shell)]
