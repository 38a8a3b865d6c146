#!/usr/bin/env python3
"""Checks that no test waits for a time, or judges by one.

    check_waits.py ROOT          check the tree at ROOT
    check_waits.py --self-test   check that violations are caught, on made-up trees

What is fast enough on one machine is too slow on a busy one, and what lasts long enough here has ended there. Tests wait by
`until()` of tests/waiting.py, for what the program does; limits after which something hangs are waiting.PATIENCE.
"""

import re
import sys

import lint

# file -> why it may know a time
ALLOWED = {
    "tests/waiting.py": "the waiting itself",
    "tests/python/alarm.py": "outlasts the moments in which a function is called again, by the same clock; the rest waits by until()",
    "tests/faults/faulty_runs.py": "kills at a random moment; each moment has to do",
    "tests/faults/kill_test.py": "how long a run takes, to kill another at a random moment of it",
    "tests/report/browser/harness.mjs": "the waiting itself, in a browser",
    "tests/cli/signals_test.cpp": "outlasts the second in which two signals are one, by the same clock",
    "tests/execution/thread_team_test.cpp": "how long threads wait is what is tested, by their processor time",
    "tests/io/files/process_test.cpp": "waits for a file, in a child that ends by itself",
    "tests/io/files/scratch_directory_test.cpp": "waits for a folder to go, up to half a minute",
}
# Tests that measure: what they print is no verdict, or a ratio of runs beside each other.
FOLDERS_ALLOWED = ("tests/benchmarks/",)

PYTHON = [
    (re.compile(r"\b(?:time\.)?sleep\("), "wait by waiting.until()"),
    (re.compile(r"\btime\.(?:time|monotonic|perf_counter)(?:_ns)?\(|\bperf_counter\("), "judge by what was done, not by a time"),
    (re.compile(r"\btimeout=\d|\b(?:wait|join|communicate)\(\d|(?<!\.)\bselect\.select\([^()]*\], \d"), "give waiting.PATIENCE"),
    (re.compile(r"\balarm\(|\bsetitimer\("), "wait by waiting.until()"),
    (re.compile(r"""["'(;&| ]sleep \d"""), "let a program wait for a pipe, which the test closes"),
]
CPP = [
    (re.compile(r"\bsleep_(?:for|until)\(|\bu?sleep\(|\bnanosleep\("), "let the program say when"),
    (re.compile(r"\bwait_for\(\s*(?:std::chrono|\w+,)|\bwait_until\("), "wait for what comes, without a time"),
    (re.compile(r"\b(?:steady|system|high_resolution)_clock::now\("), "judge by what was done, not by a time"),
]
SCRIPT = [(re.compile(r"\bsetTimeout\(|\btimeout: *\d|\bDate\.now\("), "wait by until() of harness.mjs")]
RULES = {".py": PYTHON, ".cpp": CPP, ".hpp": CPP, ".mjs": SCRIPT, ".js": SCRIPT, ".sh": PYTHON[-1:]}


def check(root):
    complaints = []
    for path in sorted((root / "tests").rglob("*")):
        name = path.relative_to(root).as_posix()
        if name in ALLOWED or name.startswith(FOLDERS_ALLOWED) or name == "tests/lints/check_waits.py" or not path.is_file():
            continue
        rules = RULES.get(path.suffix)
        if rules is None:
            continue
        text = path.read_text(encoding="utf-8")
        if path.suffix in (".cpp", ".hpp"):
            text = lint.without_comments(text)
        for number, line in enumerate(text.splitlines(), 1):
            for pattern, advice in rules:
                if found := pattern.search(line):
                    complaints.append(f"{name}:{number}: {found.group()}: {advice}")
    return complaints


SOUND = {
    "tests/cli/x.py": "waiting.until(path.exists, 'the file', process)\nprocess.wait(timeout=waiting.PATIENCE)\n",
    "tests/cli/x_test.cpp": "// sleep_for() would not do\nCHECK(told == 1);\n",
    "tests/waiting.py": "time.sleep(0.002)\n",
    "tests/benchmarks/x.py": "began = time.monotonic()\n",
}
VIOLATIONS = [
    ("tests/cli/y.py", "time.sleep(0.5)"),
    ("tests/cli/y.py", "began = time.monotonic()"),
    ("tests/cli/y.py", "end = time.time() + 5"),
    ("tests/cli/y.py", "process.communicate(timeout=60)"),
    ("tests/cli/y.py", "thread.join(3)"),
    ("tests/cli/y.py", "t.shell('sleep 2.5')"),
    ("tests/cli/y.py", "signal.alarm(3)"),
    ("tests/io/y_test.cpp", "std::this_thread::sleep_for(std::chrono::milliseconds(300));"),
    ("tests/io/y_test.cpp", "::usleep(1000);"),
    ("tests/io/y_test.cpp", "const auto began = std::chrono::steady_clock::now();"),
    ("tests/report/browser/y.mjs", "await new Promise((resolve) => setTimeout(resolve, 100));"),
    ("tests/report/browser/y.mjs", "await page.waitForSelector('svg', { timeout: 60000 });"),
]


def self_test():
    return lint.self_test(check, SOUND, [(name, text + "\n", name) for name, text in VIOLATIONS])


if __name__ == "__main__":
    sys.exit(lint.main(sys.argv[1:], __doc__, check, self_test))
