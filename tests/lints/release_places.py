"""Where the version stands beside cmake/VERSION, and how what only a person can give is marked."""

import re

# What a person gives before the first release: names, ORCID, DOI, addresses, checksums of tarballs.
PLACEHOLDER = "TO-BE-GIVEN"

# (file, pattern whose group is the version); the first match counts
PLACES = [
    ("CITATION.cff", re.compile(r"^version: ([\w.]+)$", re.M)),
    ("codemeta.json", re.compile(r'^  "version": "([\w.]+)",?$', re.M)),
    (".zenodo.json", re.compile(r'^  "version": "([\w.]+)",?$', re.M)),
    ("packaging/conda-forge/recipe.yaml", re.compile(r'^  version: "([\w.]+)"$', re.M)),
    ("packaging/spack/package.py", re.compile(r'^    version\("([\w.]+)"', re.M)),
    ("packaging/spack/package.py", re.compile(r'^    url = ".*/v([\w.]+)\.tar\.gz"$', re.M)),
    ("packaging/homebrew/ljmd.rb", re.compile(r'^  url ".*/v([\w.]+)\.tar\.gz"$', re.M)),
    ("packaging/container/Containerfile", re.compile(r'image\.version="([\w.]+)"')),
]


def version(root):
    return (root / "cmake/VERSION").read_text(encoding="utf-8").strip()


def check_versions(root, folder):
    """Complaints about the files whose names begin with `folder`, or do not begin with packaging/ where it is empty."""
    complaints = []
    wanted = version(root)
    for name, pattern in PLACES:
        if name.startswith("packaging/") != bool(folder):
            continue
        path = root / name
        found = pattern.search(path.read_text(encoding="utf-8")) if path.exists() else None
        if found is None:
            complaints.append(f"{name}: no version by {pattern.pattern}")
        elif found[1] != wanted:
            complaints.append(f"{name}: version {found[1]}, but cmake/VERSION has {wanted}")
    return complaints


def write_versions(root):
    """Writes the version of cmake/VERSION to all other places. @return what was changed"""
    changed = []
    for name, pattern in PLACES:
        text = (root / name).read_text(encoding="utf-8")
        found = pattern.search(text)
        if found is not None and found[1] != version(root):
            (root / name).write_text(text[:found.start(1)] + version(root) + text[found.end(1):], encoding="utf-8")
            changed.append(name)
    return changed
