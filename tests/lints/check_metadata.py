#!/usr/bin/env python3
"""Checks that all that describes ljmd for others describes the same: CITATION.cff, codemeta.json, .zenodo.json, pyproject.toml, the changelog.

    check_metadata.py ROOT                   check the tree at ROOT
    check_metadata.py --write-version ROOT   write the version of cmake/VERSION to these files and to the recipes in packaging/
    check_metadata.py --self-test            check that violations are caught, on the files with one mistake each

Title, abstract, licence, keywords, version, authors and addresses are compared. What only a person can give is TO-BE-GIVEN in each of
them, or in none. The newest heading of the changelog names the version, or is "Unreleased".
"""

import json
import re
import sys
from pathlib import Path

import yaml

import lint
import release_places
from release_places import PLACEHOLDER

CITATION, CODEMETA, ZENODO = "CITATION.cff", "codemeta.json", ".zenodo.json"
LICENCE = "GPL-3.0-or-later"


def read(root, name):
    return (root / name).read_text(encoding="utf-8")


def facts(root):
    """What the three files say: {fact: {file: value}}."""
    citation = yaml.safe_load(read(root, CITATION))
    codemeta = json.loads(read(root, CODEMETA))
    zenodo = json.loads(read(root, ZENODO))
    doi = re.search(r"^(?:# )?doi: (.*)$", read(root, CITATION), re.M)
    return {
        "title": {CITATION: citation.get("title"), CODEMETA: codemeta.get("name"), ZENODO: zenodo.get("title")},
        "abstract": {CITATION: citation.get("abstract"), CODEMETA: codemeta.get("description"), ZENODO: zenodo.get("description")},
        "licence": {"LICENSE": LICENCE, CITATION: citation.get("license"), ZENODO: zenodo.get("license"),
                    CODEMETA: codemeta.get("license", "").removeprefix("https://spdx.org/licenses/")},
        "keywords": {CITATION: citation.get("keywords"), CODEMETA: codemeta.get("keywords"), ZENODO: zenodo.get("keywords")},
        "authors": {
            CITATION: [f"{each.get('family-names')}, {each.get('given-names')}" for each in citation.get("authors", [])],
            CODEMETA: [f"{each.get('familyName')}, {each.get('givenName')}" for each in codemeta.get("author", [])],
            ZENODO: [each.get("name") for each in zenodo.get("creators", [])]},
        "repository": {CITATION: citation.get("repository-code"), CODEMETA: codemeta.get("codeRepository")},
        "DOI": {CITATION: doi and doi[1], CODEMETA: codemeta.get("identifier", "").removeprefix("https://doi.org/")},
        "date of release": {CITATION: citation.get("date-released") and str(citation["date-released"]),
                            CODEMETA: codemeta.get("datePublished"), ZENODO: zenodo.get("publication_date")},
    }


def check_changelog(root):
    heading = re.search(r"^## \[?([\w.]+)\]?", read(root, "CHANGELOG.md"), re.M)
    if heading is None:
        return ["CHANGELOG.md: no version"]
    if heading[1] not in (release_places.version(root), "Unreleased"):
        return [f"CHANGELOG.md: the newest version is {heading[1]}, but cmake/VERSION has {release_places.version(root)}"]
    return []


def check_placeholders(root):
    """One marked form: whoever looks for it finds all that is to be given."""
    complaints = []
    for name in (CITATION, CODEMETA, ZENODO):
        for number, line in enumerate(read(root, name).splitlines(), 1):
            if found := re.search(r"example\.(?:com|org)|\bTODO\b|\bTBD\b|\bFIXME\b|0000-0000|to-be-|\bXXX", line):
                complaints.append(f"{name}:{number}: {found.group()}: write {PLACEHOLDER}")
    return complaints


def check(root):
    try:
        found = facts(root)
    except (json.JSONDecodeError, yaml.YAMLError) as error:
        return [f"cannot be read: {str(error).splitlines()[0]}"]
    complaints = []
    for fact, values in found.items():
        first = next(iter(values.values()))
        for name, value in values.items():
            if value != first:
                complaints.append(f"{name}: {fact} {value!r}, but {next(iter(values))} has {first!r}")
            elif not value and fact != "date of release":
                complaints.append(f"{name}: no {fact}")
    if "GNU GENERAL PUBLIC LICENSE" not in read(root, "LICENSE")[:200] or "Version 3" not in read(root, "LICENSE")[:200]:
        complaints.append("LICENSE: not that of GPL version 3")
    if LICENCE not in read(root, "pyproject.toml"):
        complaints.append(f"pyproject.toml: no licence {LICENCE}")
    return complaints + check_placeholders(root) + check_changelog(root) + release_places.check_versions(root, "")


ROOT = Path(__file__).resolve().parents[2]


def self_test():
    names = [CITATION, CODEMETA, ZENODO, "LICENSE", "pyproject.toml", "cmake/VERSION"]
    sound = {name: read(ROOT, name) for name in names}
    version = sound["cmake/VERSION"].strip()
    sound["CHANGELOG.md"] = f"# Changelog\n\n## [{version}] - 2026-12-24\n\n## [0.0.1]\n"

    broken = lint.broken_in(sound)
    unreleased = lint.complaints_about(check, {**sound, "CHANGELOG.md": "## [Unreleased]\n\n## [0.0.1]\n"})
    return lint.self_test(check, sound, [
        broken(CITATION, f"version: {version}", "version: 99.0", "CITATION.cff: version 99.0"),
        broken(CODEMETA, f'"version": "{version}"', '"version": "99.0"', "codemeta.json: version 99.0"),
        broken(ZENODO, f'"version": "{version}"', '"version": "99.0"', ".zenodo.json: version 99.0"),
        broken(ZENODO, '"title": "ljmd', '"title": "LJMD', "title"),
        broken(CODEMETA, "of 1967", "of 1968", "abstract"),
        broken(CODEMETA, "GPL-3.0-or-later", "GPL-3.0-only", "licence"),
        broken(ZENODO, '"statistical mechanics"', '"fluids"', "keywords"),
        broken(CITATION, "    given-names: TO-BE-GIVEN", "    given-names: Somebody", "codemeta.json: authors"),
        broken(CITATION, "repository-code: https://TO-BE-GIVEN", "repository-code: https://somewhere", "repository"),
        broken(CITATION, "# doi: TO-BE-GIVEN", "doi: 10.5281/zenodo.1", "DOI"),
        broken(CITATION, f"version: {version}", f"version: {version}\ndate-released: 2026-12-24", "codemeta.json: date of release"),
        broken(CITATION, "# orcid: https://orcid.org/TO-BE-GIVEN", "orcid: https://orcid.org/0000-0000-0000-0000", "write TO-BE-GIVEN"),
        broken(CODEMETA, '"version"', "version", "cannot be read"),
        broken("CHANGELOG.md", f"[{version}]", "[99.0]", "newest version is 99.0"),
        broken("CHANGELOG.md", "## ", "", "newest version is 0.0.1", most=1),
        broken("pyproject.toml", "GPL-3.0-or-later", "MIT", "pyproject.toml") if sound["pyproject.toml"].count("GPL-3.0-or-later") == 1
        else ("pyproject.toml", "[project]\n", "pyproject.toml"),
        broken("LICENSE", "Version 3", "Version 2", "LICENSE"),
    ], [f"an unreleased version gave {unreleased}"] if unreleased else [])


def main(arguments):
    if len(arguments) == 2 and arguments[0] == "--write-version":
        print("\n".join(release_places.write_versions(Path(arguments[1]))) or "nothing to change")
        return 0
    return lint.main(arguments, __doc__, check, self_test)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
