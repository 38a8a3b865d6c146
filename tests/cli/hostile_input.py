"""Files that are no decks: refused at once, whatever their size and content."""

import os
import random
import resource

from harness import DECK, Case, Skip

MEMORY = 500e6  # bytes; nothing here may take more


def refused(make):
    """The case of a file `deck.toml` that make(path) creates."""
    def test(t):
        make(t.dir / "deck.toml")
        result = t.expect(2, t.run("run", "deck.toml"))
        t.equal(result.out, "", "stdout")
        t.equal(t.files(), ["deck.toml"] if os.path.lexists(t.dir / "deck.toml") else [], "files")
        t.golden(result.err)
        taken = 1024 * resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
        t.check(taken < MEMORY, f"{taken / 1e6:.0f} MB of memory taken")
    return test


def text(content):
    return lambda path: path.write_bytes(content if isinstance(content, bytes) else content.encode())


def a_gigabyte(path):
    """Sparse: it takes no disk."""
    with open(path, "wb") as file:
        file.write(DECK.encode())
        file.truncate(10**9)


def just_too_large(path):
    path.write_bytes(DECK.encode() + b"#" * (2**20 + 1 - len(DECK)))


def fifo(path):
    os.mkfifo(path)


def link_to_itself(path):
    path.symlink_to(path)


def the_largest_deck_runs(t):
    t.deck()
    with open(t.dir / "deck.toml", "ab") as file:
        file.write(b"#" * (2**20 - len(DECK)))
    t.run_well("check", "deck.toml")


def devices(t):
    """A device gives no end of zeros, or nothing; neither is a deck."""
    for device in ("/dev/zero", "/dev/null"):
        result = t.expect(2, t.run("run", device))
        t.contains(result.err, f"error: {device}: is a device or a socket, not a regular file\n")


def unreadable(t):
    if os.geteuid() == 0:
        raise Skip("root reads every file")
    t.deck()
    (t.dir / "deck.toml").chmod(0)
    t.contains(t.expect(2, t.run("run", "deck.toml")).err, "deck.toml: cannot be read: Permission denied")


def every_cut_of_a_deck(t):
    """A deck that ends anywhere is refused with a clear message, or is a whole deck that happens to be shorter."""
    for length in range(0, len(DECK), 7):
        (t.dir / "deck.toml").write_text(DECK[:length])
        result = t.run("check", "deck.toml")
        if result.code not in (0, 2) or (result.code == 2 and "error: deck.toml" not in result.err):
            t.expect(2, result)


def a_flipped_byte(t):
    """No change of one byte crashes the program, or makes it call itself faulty."""
    generator = random.Random(1967)
    for _ in range(150):
        data = bytearray(DECK.encode())
        data[generator.randrange(len(data))] = generator.randrange(256)
        (t.dir / "deck.toml").write_bytes(data)
        result = t.run("check", "deck.toml")
        if result.code not in (0, 2, 3):
            (t.dir / "deck.toml").write_bytes(data)
            t.expect(2, result)


def cases():
    files = [("a missing file", lambda path: None), ("a directory", os.mkdir), ("an empty file", text("")),
             ("nothing but comments", text("# nothing\n\n# at all\n")), ("a gigabyte", a_gigabyte),
             ("just too large", just_too_large), ("a program", text(b"\x7fELF\x02\x01\x01\x00\xff\xfe" * 100)), ("a NUL byte", text(b"title = \"a\0b\"\n")),
             ("invalid UTF-8", text(b"title = \"gr\xfc\xdfe\"\n")), ("a lone surrogate", text(b"title = \"\xed\xa0\x80\"\n")),
             ("an overlong slash", text(b"title = \"\xc0\xaf\"\n")), ("UTF-16", text("title = 'a'".encode("utf-16"))),
             ("brackets 10000 deep", text("a = " + "[" * 10_000 + "]" * 10_000)),
             ("tables 10000 deep", text("a = " + "{a = " * 10_000 + "1" + "}" * 10_000)),
             ("a key 10000 deep", text("a" + ".a" * 10_000 + " = 1\n")),
             ("a header 10000 deep", text("[a" + ".a" * 10_000 + "]\n")), ("a FIFO", fifo), ("a link to itself", link_to_itself),
             ("a carriage return alone", text("title = 'a'\rtitle = 'b'\n")), ("JSON", text('{"system": {"density": 0.8}}\n')),
             ("an escape sequence in the text", text("\x1b[31mtitle = 'a'\n"))]
    return [Case(name, refused(make)) for name, make in files] + [
        Case(test.__name__.replace("_", " "), test)
        for test in (the_largest_deck_runs, devices, unreadable, every_cut_of_a_deck, a_flipped_byte)]
