"""Files under names that a caller gives: whose file is replaced, and what a failure leaves. docs/reliability.md has the table."""

import os
import resource
import stat
import unittest
from dataclasses import dataclass
from typing import Callable

import ljmd
from cases import Case, small_deck

try:
    from ase.build import bulk
    import ljmd.ase
except ImportError:
    bulk = None

NOBODY = 65534


@dataclass
class Output:
    write: Callable  # of a path, with force
    replaces_older: bool


def outputs(folder):
    run = small_deck().run(folder / "run", progress=False)
    found = {"Deck.save": Output(lambda path, **more: small_deck().save(path, **more), False),
             "Run.report": Output(run.report, True)}
    if bulk is not None:
        atoms = bulk("Ar", "fcc", a=5.3, cubic=True).repeat(4)
        found["to_deck"] = Output(lambda path, **more: ljmd.ase.to_deck(atoms, path, cutoff=8.5, sigma=3.405, epsilon=0.01, temperature=1.0,
                                                                       **more), True)
    return found


def tree(folder):
    """What is there: of files the bytes, of links where they lead to."""
    found = {}
    for path in sorted(folder.rglob("*")):
        kind = path.lstat().st_mode
        found[str(path)] = os.readlink(path) if stat.S_ISLNK(kind) else path.read_bytes() if stat.S_ISREG(kind) else kind
    return found


class Outputs(Case):
    def setUp(self):
        super().setUp()
        self.outputs = outputs(self.folder)
        self.path = self.folder / "named"

    def refused(self, output, error=ljmd.InputError, *texts, **more):
        before = tree(self.folder)
        self.assertRaisesText(error, str(self.path), *texts, of=lambda: output.write(self.path, **more))
        self.assertEqual(tree(self.folder), before)

    def each(self):
        """Every output, with nothing at its name."""
        for name, output in self.outputs.items():
            with self.subTest(name):
                self.path.unlink(missing_ok=True)
                yield output

    def test_what_others_have_written_is_replaced_by_force_alone(self):
        for output in self.each():
            self.path.write_text("mine")
            self.refused(output, ljmd.InputError, "is there already", "choose another name, or replace it")
            output.write(self.path, force=True)
            self.assertNotEqual(self.path.read_bytes(), b"mine")
            self.assertEqual(self.path.stat().st_mode & 0o777, 0o666 & ~umask())
            self.assertRaisesText(ljmd.InputError, "force", of=lambda: output.write(self.path, force="yes"))

    def test_older_files_of_ljmd(self):
        for output in self.each():
            output.write(self.path)
            if output.replaces_older:
                output.write(self.path)
            else:
                self.refused(output, ljmd.InputError, "is there already")

    def test_a_link_is_never_followed(self):
        precious = self.folder / "precious"
        precious.write_text("mine")
        os.mkfifo(self.folder / "pipe")
        for output in self.each():
            for target in (precious, self.folder / "nowhere", self.folder / "pipe", self.folder):
                self.path.unlink(missing_ok=True)
                self.path.symlink_to(target)
                self.refused(output)
                if not target.exists() or target.is_file():
                    output.write(self.path, force=True)
                    self.assertFalse(self.path.is_symlink())
                else:
                    self.refused(output, force=True)
            self.assertEqual(precious.read_text(), "mine")
            self.assertFalse((self.folder / "nowhere").exists())

    def test_directories_and_pipes_are_in_the_way(self):
        for output in self.each():
            for make, take_away in ((os.mkdir, os.rmdir), (os.mkfifo, os.unlink)):
                make(self.path)
                for more in ({}, {"force": True}):
                    self.refused(output, ljmd.InputError, "is in the way", "choose another name", **more)
                take_away(self.path)
            self.assertRaisesText(ljmd.InputError, "is empty", of=lambda: output.write(""))

    def test_a_full_disk_leaves_the_old_file(self):
        before = resource.getrlimit(resource.RLIMIT_FSIZE)
        for output in self.each():
            output.write(self.path)
            for limit in (0, 100):
                resource.setrlimit(resource.RLIMIT_FSIZE, (limit, before[1]))
                try:
                    self.refused(output, ljmd.FileError, "File too large", force=True)
                finally:
                    resource.setrlimit(resource.RLIMIT_FSIZE, before)

    def test_a_folder_without_permission(self):
        """In a process of its own, which is nobody's where this one is root's."""
        self.folder.chmod(0o755)
        for folder in (self.folder, self.folder / "run"):
            self.path = folder / "named"
            self.path.write_text("mine")
            folder.chmod(0o555)
        self.addCleanup(self.folder.chmod, 0o700)
        self.addCleanup((self.folder / "run").chmod, 0o700)
        tree_before = tree(self.folder)
        process = os.fork()
        if process == 0:
            code = 1
            try:
                if os.geteuid() == 0:
                    os.setgroups([])
                    os.setgid(NOBODY)
                    os.setuid(NOBODY)
                for output in self.outputs.values():
                    self.assertRaisesText(ljmd.InputError, "is there already", of=lambda: output.write(self.path))
                    self.assertRaisesText(ljmd.FileError, "Permission denied", of=lambda: output.write(self.path, force=True))
                code = 0
            finally:
                os._exit(code)
        self.assertEqual(os.waitstatus_to_exitcode(os.waitpid(process, 0)[1]), 0)
        self.assertEqual(tree(self.folder), tree_before)

    def test_an_older_file_is_told_by_its_mark_at_either_end(self):
        from ljmd import _output

        self.path.write_bytes(b"x" * 200_000 + b"drawn by ljmd")
        _output.write_text(self.path, "drawn by ljmd" + "x" * 200_000, mark=b"drawn by ljmd")
        _output.write_text(self.path, "x" * 100_000 + "drawn by ljmd" + "x" * 100_000, mark=b"drawn by ljmd")
        self.assertRaisesText(ljmd.InputError, "was not written by ljmd", of=lambda: _output.write_text(self.path, "", mark=b"drawn by ljmd"))

    def test_what_is_put_there_meanwhile_stays(self):
        from ljmd import _output

        def write():
            with _output.replacing(self.path) as growing:
                growing.write_text("ours")
                self.path.write_text("mine")

        self.assertRaisesText(ljmd.InputError, "is there already", of=write)
        self.assertEqual(self.path.read_text(), "mine")
        self.assertEqual(list(self.folder.glob(".ljmd-*")), [])


def umask():
    found = os.umask(0o022)
    os.umask(found)
    return found


if __name__ == "__main__":
    unittest.main()
