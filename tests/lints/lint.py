"""What the lints share: sources without comments, made-up trees that hold one violation each, the command line."""

import re
import sys
import tempfile
from pathlib import Path


def sources(root):
    """The C++ files of src/ and include/."""
    return sorted([*(root / "src").rglob("*.[ch]pp"), *(root / "include").rglob("*.[ch]pp")])


def without_comments(text):
    """The text with comments blanked, line by line; strings that hold // or /* do not occur where lints look."""
    text = re.sub(r"/\*.*?\*/", lambda match: re.sub(r"[^\n]", " ", match.group()), text, flags=re.S)
    return re.sub(r"//[^\n]*", "", text)


def complaints_about(check, files):
    """The complaints about a made-up tree, {name: text}."""
    with tempfile.TemporaryDirectory() as folder:
        for name, text in files.items():
            (Path(folder) / name).parent.mkdir(parents=True, exist_ok=True)
            (Path(folder) / name).write_text(text, encoding="utf-8")
        return check(Path(folder))


def self_test(check, sound, violations, more_failures=()):
    """Whether a lint finds nothing in the tree `sound`, and each violation when it is added.

    violations: (file, its text, what exactly one complaint must say). @return the exit code
    """
    failures = list(more_failures)
    if complaints := complaints_about(check, sound):
        failures.append(f"a sound tree gave {complaints}")
    for name, text, expected in violations:
        complaints = complaints_about(check, {**sound, name: text})
        if sum(expected in complaint for complaint in complaints) != 1:
            failures.append(f"{name} with {text!r}: expected one '{expected}', got {complaints}")
    print("\n".join(failures) or f"{len(violations)} violations caught")
    return 1 if failures else 0


def broken_in(sound):
    """@return broken(file, old, new, expected): a violation for self_test(), the sound text with each `old` replaced, or the first `most`"""
    def broken(name, old, new, expected, most=-1):
        assert old in sound[name], f"{name} has no {old!r}"
        return name, sound[name].replace(old, new, most), expected
    return broken


def report(complaints):
    """Print what was found. @return the exit code"""
    print("\n".join(complaints) or "no violation")
    return 1 if complaints else 0


def main(arguments, usage, check, self_test_of_it):
    """Run a lint as its usage says."""
    if arguments == ["--self-test"]:
        return self_test_of_it()
    if len(arguments) != 1:
        print(usage)
        return 2
    return report(check(Path(arguments[0])))
