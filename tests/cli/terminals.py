"""The program on a terminal, at several widths and while the width changes: one line of progress that fits, and nothing
of it left over. Both kinds of terminals see the same bytes: one that wraps its lines anew when it is made narrower, and
one that cuts them off."""

import codecs
import fcntl
import os
import pty
import re
import select
import signal
import struct
import subprocess
import termios

from emulator import Terminal, columns_of
from harness import ARGON, DECK, STARS, Case, Failure, clean_environment, on_a_terminal
import waiting

LINE = re.compile(r"\r\x1b\[\?7l([^\r]+?)\x1b\[J\x1b\[\?7h\r")  # a line of progress as the program writes it
SOME = 8  # lines of progress before an interruption
LONG = DECK.replace("steps = 40", "steps = 2000")


class Program:
    """ljmd with stdout and stderr on a pseudo-terminal of some width."""

    def __init__(self, t, columns, *arguments):
        self.ours, self.theirs = pty.openpty()
        self.terminals = [Terminal(columns, reflows=reflows) for reflows in (False, True)]
        self.decoder = codecs.getincrementaldecoder("utf-8")()
        self.seen = ""
        self.set_size(columns)
        self.program = subprocess.Popen([t.ljmd, *arguments], cwd=t.dir, stdin=subprocess.DEVNULL, stdout=self.theirs,
                                        stderr=self.theirs, env=clean_environment(), start_new_session=True)
        os.close(self.theirs)

    def set_size(self, columns):
        fcntl.ioctl(self.ours, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))

    def read_to_line_end(self):
        while not self.seen.endswith(("\r", "\n")):
            self.read()

    def resize(self, columns):
        """Between two lines: a terminal does not do it in the midst of what it reads."""
        self.read_to_line_end()
        self.set_size(columns)
        for terminal in self.terminals:
            terminal.resize(columns)

    def read(self):
        """@return whether the program is still there"""
        if not select.select([self.ours], [], [], waiting.PATIENCE)[0]:
            self.program.kill()
            raise Failure("hangs on a terminal")
        try:
            data = os.read(self.ours, 512)
        except OSError:  # Linux: the other end is closed
            data = b""
        text = self.decoder.decode(data)
        self.seen += text
        for terminal in self.terminals:
            terminal.feed(text)
        return bool(data)

    def wait_for(self, size):
        """Until so many bytes can be read; they are not."""
        def there():
            return struct.unpack("i", fcntl.ioctl(self.ours, termios.FIONREAD, bytes(4)))[0]

        waiting.until(lambda: there() >= size, f"{size} bytes on the terminal", self.program)

    def progress(self):
        return LINE.findall(self.seen)

    def run(self, widths=()):
        """To the end; after every second line of progress the terminal gets the next width. @return exit code"""
        widths = list(widths)
        lines = 0
        while self.read():
            if widths and len(self.progress()) >= lines + 2:
                lines = len(self.progress())
                self.resize(widths.pop(0))
        os.close(self.ours)
        return self.program.wait()


def width_of(text):
    return sum(map(columns_of, text))


def without_progress(t, *arguments):
    """What the same command prints where there is no terminal, in one stream, without lines of progress and without warnings
    about results that the table says, too."""
    result = t.run(*arguments, capture_output=False, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    lines = [line for line in result.out.splitlines(keepends=True) if not re.match(r"\[.*steps/s", line)]
    return "".join(line for line in lines if not line.startswith("warning: "))  # they stand in the table, too


def fits(columns):
    def test(t):
        t.deck(text=LONG.replace("[system]", ARGON + "\n[system]"))
        expected = without_progress(t, "run", "deck.toml")
        program = Program(t, columns, "run", "deck.toml", "--force")
        t.equal(program.run(), 0, "exit code")
        lines = program.progress()
        t.check(len(lines) >= 5, f"{len(lines)} lines of progress: {program.seen!r}")
        for line in lines:
            t.check(width_of(line) < columns, f"{width_of(line)} columns of {columns}: {line!r}")
            t.check(re.match(r"\[(melt|production)\]  +\d+ %  .*ETA [\d:?]+  T [\d.]+", line), f"line of progress: {line!r}")
        if columns >= 80:
            for part in (r"[\d.e+]+ steps/s", r"U/N -?[\d.]+", r"p -?[\d.]+"):
                t.check(all(re.search(part, line) for line in lines), f"no {part} in {lines}")
        t.check(("atom-steps/s" in lines[0]) == (columns == 200), f"rate of atoms at {columns} columns: {lines[0]!r}")
        for terminal in program.terminals:
            t.equal(terminal.text(), expected, f"what is left on the screen of {columns} columns")
        if columns == 80:
            table = expected[expected.index("observable"):expected.index("files:")]
            t.check(max(map(len, table.splitlines())) <= 80, f"the table is wider than the screen:\n{table}")
    return test


def doubts_stand_once(t):
    """On a terminal below the table, where results go to a file on the terminal, in files and pipes in both places."""
    t.deck()
    piped = t.run("run", "deck.toml")
    said = re.findall(r"^warning: (.*)$", piped.err, flags=re.M)
    t.check(any(f"  warning: {one[:40]}" in piped.out for one in said), f"no doubt that stands in both: {piped.err!r}")
    for arguments, beside in ((("--force",), False), (("--force", "--json"), True)):
        program = Program(t, 200, "run", "deck.toml", *arguments)
        t.equal(program.run(), 0, "exit code")
        for one in said:
            t.equal(f"warning: {one}\n" in program.terminals[0].text(), beside, f"{one!r} as a message with {arguments}")
    with open(t.dir / "results", "w", encoding="utf-8") as results:
        code, _, seen = on_a_terminal(t, "run", "deck.toml", "--force", stdout=results)
    t.equal(code, 0, "exit code")
    t.check(all(one in seen for one in said), f"not said beside a file: {seen!r}")


def studies(t):
    """Tables of sweeps fit a terminal; one that is wide enough and a pipe get the same."""
    t.deck()
    sweep = ("sweep", "deck.toml", "--grid", "system.temperature=0.9:1.1:2,system.density=0.7:0.8:2", "--quiet", "--out", "s")
    piped = t.run(*sweep).out
    t.check(max(map(len, piped.splitlines())) > 100, f"the table is narrow:\n{piped}")
    for arguments, expected in ((sweep, piped), (("info", "s"), t.run("info", "s").out)):
        for columns in (80, 200):
            program = Program(t, columns, *arguments)
            t.equal(program.run(), 0, "exit code")
            for terminal in program.terminals:
                rows = terminal.text().splitlines()
                t.check(max(map(len, rows)) <= columns, f"wider than {columns} columns:\n{terminal.text()}")
                if columns == 200:
                    t.equal(terminal.text(), expected, "the table on a wide terminal")
    narrow = Program(t, 80, *sweep)
    t.equal(narrow.run(), 0, "exit code")
    t.check(re.search(r"-\d\.\d+\(\d+\)", narrow.terminals[0].text()), f"no short errors:\n{narrow.terminals[0].text()}")


def resized(t):
    """Made narrower, wider, narrower while lines are written. Lines that the program wrote before it could know stay
    on one row, and the rest of lines that were wrapped is removed."""
    t.deck(("cells = 3", "cells = 6"), text=LONG)
    expected = without_progress(t, "run", "deck.toml")
    program = Program(t, 200, "run", "deck.toml", "--force")
    t.equal(program.run([40, 120, 60, 200, 35, 80]), 0, "exit code")
    cut, wrapped = program.terminals
    t.equal(wrapped.text(), expected, "what is left on a terminal that wraps")
    found, wanted = cut.text().splitlines(), expected.splitlines()
    t.equal(len(found), len(wanted), f"lines on a terminal that cuts:\n{cut.text()}")
    for one, other in zip(found, wanted):  # of a line in two rows both may have been cut
        rest = iter(other)
        t.check(all(character in rest for character in one), f"{one!r} is no part of {other!r}")


def the_width_is_asked_each_time(t):
    t.deck(("cells = 3", "cells = 5"), text=LONG.replace("steps = 2000", "steps = 200000"))
    program = Program(t, 200, "run", "deck.toml")
    while len(program.progress()) < 3:
        t.check(program.read(), "the run has ended")
    t.check(width_of(program.progress()[-1]) > 80, f"a long line is expected: {program.progress()[-1]!r}")
    program.read_to_line_end()
    program.wait_for(400)  # lines of the old width are on their way
    program.resize(40)
    before = len(program.progress())
    while width_of(program.progress()[-1]) >= 40:
        t.check(program.read(), "the run has ended")
        t.check(len(program.progress()) < before + 60, f"the width is not asked for: {program.progress()[-1]!r}")
    t.check(len(program.progress()) > before + 1, "no line of the old width has come")
    for terminal in program.terminals:
        t.equal([row for row in terminal.rows_shown() if "ETA" in row], [row for row in terminal.rows_shown() if "%" in row],
                "rows with progress")
        t.check(sum("%" in row for row in terminal.rows_shown()) <= 1, f"rows: {terminal.rows_shown()}")
    program.program.send_signal(signal.SIGINT)
    t.equal(program.run(), 130, "exit code")
    for terminal in program.terminals:
        t.check(not re.search(r"ETA|steps/s", terminal.text()), f"left over:\n{terminal.text()}")
        t.check(re.search(r"^(stopped|interrupted|SIGINT).*", terminal.text().splitlines()[-1], flags=re.I) or
                "resume" in terminal.text(), f"the message:\n{terminal.text()}")


def an_error_takes_the_place_of_progress(t):
    t.deck(("density = 0.8442", "density = 0.5"), ("temperature = 1.0", "temperature = 20.0"),
           ("time_step = 0.004\nsteps = 20", "time_step = 0.05\nsteps = 2000"),
           ('thermostat = { type = "rescale", every = 5 }\n', ""))
    program = Program(t, 60, "run", "deck.toml", "--force")
    t.equal(program.run(), 5, "exit code")
    t.check(program.progress(), "no progress")
    for terminal in program.terminals:
        t.check(re.search(r"^error: step", terminal.text(), flags=re.M), f"the error does not begin a line:\n{terminal.text()}")
        t.check("ETA" not in terminal.text(), f"left over:\n{terminal.text()}")


def names_of_any_width(t):
    """A stage with a long name of wide characters, and one with a name of combining ones."""
    t.deck(('name = "melt"', 'name = "熔化和平衡阶段熔化和平衡阶段熔化和平衡阶段"'), ('name = "production"', 'name = "e\u0301tat e\u0301tat e\u0301tat e\u0301tat"'),
           ("steps = 20\n", "steps = 200\n"))
    for columns in (10, 40, 80):
        program = Program(t, columns, "run", "deck.toml", "--force", "--out", "out")
        t.equal(program.run(), 0, "exit code")
        t.check(len(program.progress()) >= 5, "no progress")
        for line in program.progress():
            t.check(width_of(line) < columns, f"{width_of(line)} columns of {columns}: {line!r}")
        for terminal in program.terminals:
            t.check("ETA" not in terminal.text() and not re.search(r"\d %$", terminal.text(), flags=re.M),
                    f"left over at {columns} columns:\n{terminal.text()}")


def few_bodies(t):
    t.deck(("steps = 100", "steps = 5000"), text=STARS)
    for arguments in (("run", "deck.toml", "--force"), ("compare", "deck.toml", "--with", "gsl")):
        expected = without_progress(t, *arguments)
        program = Program(t, 40, *arguments)
        t.equal(program.run(), 0, "exit code")
        t.check(all(width_of(line) < 40 for line in program.progress()), f"lines: {program.progress()}")
        if arguments[0] == "run":
            t.check(any(re.search(r"E -0\.375", line) for line in program.progress()), f"no energy: {program.progress()}")
        for terminal in program.terminals:
            t.equal(terminal.text(), expected, f"what is left of {arguments[0]}")


def no_progress_on_a_dumb_terminal(t):
    t.deck()
    code, _, seen = on_a_terminal(t, "run", "deck.toml", stdout=subprocess.DEVNULL, TERM="dumb")
    t.equal(code, 0, "exit code")
    t.check("\x1b" not in seen and "steps/s" in seen, f"on a dumb terminal: {seen!r}")


def cases():
    return [Case(f"a run on a terminal of {columns} columns", fits(columns)) for columns in (40, 80, 200)] + \
        [Case(test.__name__.replace("_", " "), test)
         for test in (doubts_stand_once, studies, resized, the_width_is_asked_each_time, an_error_takes_the_place_of_progress, names_of_any_width, few_bodies,
                      no_progress_on_a_dumb_terminal)]
