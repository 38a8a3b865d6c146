#!/usr/bin/env python3
"""Checks that the recipes in packaging/ say what the build says.

    check_packaging.py ROOT          check the tree at ROOT
    check_packaging.py --self-test   check that violations are caught, on the recipes with one mistake each

- Dependencies are those of tools/packages and cmake/LjmdDependencies.cmake, with its oldest versions.
- Options -D ... are known to CMakeLists.txt and cmake/: CMake ignores a name that it does not know.
- The version is that of cmake/VERSION, the licence GPL-3.0-or-later, and licence files are there.
- Recipes can be parsed: YAML, Python, and Ruby where it is installed.

packaging/debian is built and judged by Debian's own tools, and not looked at here.
"""

import ast
import re
import shutil
import subprocess
import sys
from pathlib import Path

import yaml

import lint
import release_places

CONDA = "packaging/conda-forge/recipe.yaml"
SPACK = "packaging/spack/package.py"
BREW = "packaging/homebrew/ljmd.rb"
CONTAINER = "packaging/container/Containerfile"
CONSUMER = "packaging/consumer/CMakeLists.txt"
LICENCE = "GPL-3.0-or-later"

# What cmake/LjmdDependencies.cmake looks for -> Debian's package, by which tools/packages names the others; None: not a package
LIBRARIES = {
    "Eigen3": "libeigen3-dev", "GSL": "libgsl-dev", "fmt": "libfmt-dev", "fftw3": "libfftw3-dev", "libxxhash": "libxxhash-dev",
    "nlohmann_json": "nlohmann-json3-dev", "tomlplusplus": "libtomlplusplus-dev", "hdf5": "libhdf5-dev", "hdf5-serial": "libhdf5-dev",
    "HDF5": "libhdf5-dev", "ZLIB": "zlib1g-dev", "CLI11": "libcli11-dev", "OpenMM": "libopenmm-dev", "MPI": "libopenmpi-dev",
    "esbuild": "esbuild", "PkgConfig": "pkg-config", "Threads": None, "ccache": None,
}
# Debian's package -> its name in Spack, which tools/packages does not know
SPACK_NAMES = {
    "g++": "cxx", "cmake": "cmake", "pkg-config": "pkgconfig", "libeigen3-dev": "eigen", "libgsl-dev": "gsl", "libfftw3-dev": "fftw",
    "libtomlplusplus-dev": "tomlplusplus", "libcli11-dev": "cli11", "libfmt-dev": "fmt", "nlohmann-json3-dev": "nlohmann-json",
    "libhdf5-dev": "hdf5", "zlib1g-dev": "zlib-api", "libopenmm-dev": "openmm", "libopenmpi-dev": "mpi", "libxxhash-dev": "xxhash",
    "python3-dev": "python", "pybind11-dev": "py-pybind11", "python3-numpy": "py-numpy", "python3-h5py": "py-h5py",
    "python3-matplotlib": "py-matplotlib",
}
# recipe -> a name of tools/packages -> what the recipe calls it
OTHER_NAMES = {
    CONDA: {"matplotlib": "matplotlib-base"},
    BREW: {"eigen": "eigen@3", "python": "python@3.14", "zlib": "zlib-ng-compat"},
}
# recipe -> name -> why the recipe has it not, or has it beside those of tools/packages
WITHOUT = {
    CONDA: {"git": "a tarball has no commit"},
    SPACK: {"git": "a tarball has no commit", "ninja-build": "generator() brings it", "esbuild": "Spack does not have it"},
    BREW: {"git": "a tarball has no commit", "gcc": "Homebrew has a compiler of its own"},
    CONTAINER: {"git": "COPY brings no commit", "libopenmm-dev": "the program alone", "libopenmpi-dev": "the program alone",
                "python3-dev": "the program alone", "pybind11-dev": "the program alone", "python3-numpy": "the program alone",
                "python3-h5py": "the program alone", "python3-matplotlib": "the program alone", "libopenmm-plugins": "the program alone"},
}
BESIDE = {
    CONDA: {"c-compiler": "CMake looks for HDF5 by a program in C"},
    SPACK: {"c": "CMake looks for HDF5 by a program in C"},
    BREW: {"linux": "not a package"},
}
# (library in LjmdDependencies.cmake or its like, name in Spack, name in conda-forge)
OLDEST = [
    (r"cmake_minimum_required\(VERSION ([\d.]+)", "cmake", "cmake"), (r"find_package\(Eigen3 ([\d.]+)", "eigen", "eigen"),
    (r"find_package\(GSL ([\d.]+)", "gsl", "gsl"), (r"fftw3>=([\d.]+)", "fftw", "fftw"), (r"hdf5>=([\d.]+)", "hdf5", "hdf5"),
    (r"find_package\(OpenMM ([\d.]+)", "openmm", "openmm"), (r"find_package\(nlohmann_json ([\d.]+)", "nlohmann-json", "nlohmann_json"),
    (r"find_package\(tomlplusplus ([\d.]+)", "tomlplusplus", "tomlplusplus"), (r"find_package\(Python3 ([\d.]+)", "python", "python"),
    (r"find_package\(pybind11 ([\d.]+)", "py-pybind11", "pybind11"),
]
CMAKE_OWN = {"CMAKE_BUILD_TYPE", "CMAKE_PREFIX_PATH", "EXPECTED_VERSION", "ROOT"}


def read(root, name):
    return (root / name).read_text(encoding="utf-8")


def packages(root):
    """Rows of tools/packages as dicts."""
    table = re.search(r"^table='\n(.*?)^'", read(root, "tools/packages"), re.M | re.S)[1]
    return [dict(zip(("when", "apt", CONDA, BREW), line.split())) for line in table.splitlines()]


def libraries(root):
    """What LjmdDependencies.cmake looks for."""
    text = re.sub(r"#.*", "", read(root, "cmake/LjmdDependencies.cmake"))
    found = set(re.findall(r"find_package\((\w+)", text))
    for module in re.findall(r"pkg_(?:check|search)_modules?\(([^)]*)\)", text):
        found.update(re.sub(r">=.*", "", word) for word in module.split()[1:] if word not in ("REQUIRED", "QUIET", "IMPORTED_TARGET"))
    found.update(re.findall(r"find_program\(\w+ (\w+)", text))
    return found


def strings(node):
    """All strings in a parsed YAML document."""
    if isinstance(node, str):
        return [node]
    return [text for each in (node.values() if isinstance(node, dict) else node if isinstance(node, list) else []) for text in strings(each)]


def conda_requirements(recipe):
    """Names -> the requirements, as they stand there."""
    found = {}
    for output in recipe["outputs"]:
        wanted = output["requirements"]
        for text in strings([wanted.get(place, []) for place in ("build", "host", "run")]):
            compiler = re.match(r"\$\{\{ compiler\(.(\w+).\) \}\}", text)
            if compiler:
                found.setdefault(f"{compiler[1]}-compiler", []).append(text)
            elif not text.startswith("$"):
                found.setdefault(text.split()[0], []).append(text)
    return found


def spack_requirements(tree):
    found = {}
    for call in ast.walk(tree):
        if isinstance(call, ast.Call) and getattr(call.func, "id", "") in ("depends_on", "extends"):
            text = call.args[0].value
            found.setdefault(re.split(r"[@+~ ]", text)[0], []).append(text)
    return found


def container_packages(text):
    """Those of the first stage, in which the program is built."""
    installed = re.search(r"install --yes --no-install-recommends(.*?)&&", text.replace("\\\n", " "), re.S)
    return {word: [word] for word in installed[1].split()} if installed else {}


def wanted_names(root, recipe):
    """Names that the recipe should have -> Debian's, and all that tools/packages knows for it."""
    rows = packages(root)
    needed = {LIBRARIES[name] for name in libraries(root) if LIBRARIES.get(name)}

    def name_of(row):
        name = SPACK_NAMES.get(row["apt"], "-") if recipe == SPACK else row["apt"] if recipe == CONTAINER else row[recipe]
        return OTHER_NAMES.get(recipe, {}).get(name, name)

    without = WITHOUT.get(recipe, {})
    all_names = {name_of(row) for row in rows} - {"-"}
    wanted = {name_of(row): row["apt"] for row in rows if row["when"] == "use" or row["apt"] in needed}
    wanted = {name: apt for name, apt in wanted.items() if name != "-" and name not in without and apt not in without}
    return wanted, all_names | set(BESIDE.get(recipe, {}))


def check_names(root, recipe, found):
    wanted, known = wanted_names(root, recipe)
    complaints = [f"{recipe}: no {name}, which tools/packages and cmake/LjmdDependencies.cmake have" for name in sorted(wanted) if name not in found]
    return complaints + [f"{recipe}: {name} is not in tools/packages" for name in sorted(found) if name not in known]


def check_oldest(root, recipe, found, column, pattern):
    """Where a recipe names an oldest version, it is that of CMake."""
    cmake = read(root, "CMakeLists.txt") + read(root, "cmake/LjmdDependencies.cmake") + read(root, "cmake/LjmdPython.cmake")
    complaints = []
    for expression, *names in OLDEST:
        oldest = re.search(expression, cmake)
        for text in found.get(names[column], []):
            stated = re.search(pattern, text)
            if stated and oldest and stated[1] != oldest[1]:
                complaints.append(f"{recipe}: {text}: CMake asks for {oldest[1]}")
    return complaints


def known_options(root):
    text = "".join(read(root, path.relative_to(root)) for path in [root / "CMakeLists.txt", *sorted((root / "cmake").glob("*.cmake"))])
    options = set(re.findall(r"(?:option\(|set\()(\w+)[^)]*?(?:CACHE|\"|\b(?:ON|OFF)\))", text)) | {"BUILD_SHARED_LIBS"}
    return options | {f"LJMD_{name}" for name in re.findall(r'"([A-Z_]+):', text)} | CMAKE_OWN


def check_options(root, recipe, text):
    used = re.findall(r"-D ?(\w+)=|define(?:_from_variant)?\(\s*\"(\w+)\"|define\(\"(\w+)\"", text)
    known = known_options(root)
    return [f"{recipe}: CMake knows no {name}" for name in sorted({"".join(each) for each in used} - known)]


def check_sums(recipe, text):
    """A checksum is one, or is still to be given, as the address is."""
    sums = re.findall(r"sha256\W+([\w-]+)", text)
    wrong = [each for each in sums if not re.fullmatch(rf"[0-9a-f]{{64}}|{release_places.PLACEHOLDER}", each)]
    return [f"{recipe}: {each} is no sha256" for each in wrong] + ([] if sums else [f"{recipe}: no sha256"])


def check_conda(root):
    text = read(root, CONDA)
    try:
        recipe = yaml.safe_load(text)
    except yaml.YAMLError as error:
        return [f"{CONDA}: {str(error).splitlines()[0]}"]
    complaints = check_names(root, CONDA, conda_requirements(recipe)) + check_options(root, CONDA, text) + check_sums(CONDA, text)
    complaints += check_oldest(root, CONDA, conda_requirements(recipe), 1, r">=([\d.]+)")
    about = recipe["about"]
    if about.get("license") != LICENCE:
        complaints.append(f"{CONDA}: licence {about.get('license')}")
    complaints += [f"{CONDA}: no file {name}" for name in about["license_file"] if not (root / name).exists()]
    sources = [name for output in recipe["outputs"] for test in output.get("tests", []) for name in test.get("files", {}).get("source", [])]
    return complaints + [f"{CONDA}: no file {name}" for name in sources if not (root / name).exists()]


def check_spack(root):
    text = read(root, SPACK)
    try:
        tree = ast.parse(text)
    except SyntaxError as error:
        return [f"{SPACK}:{error.lineno}: {error.msg}"]
    classes = [node for node in tree.body if isinstance(node, ast.ClassDef)]
    complaints = [] if [node.name for node in classes] == ["Ljmd"] else [f"{SPACK}: not the one class Ljmd"]
    complaints += check_names(root, SPACK, spack_requirements(tree)) + check_options(root, SPACK, text) + check_sums(SPACK, text)
    complaints += check_oldest(root, SPACK, spack_requirements(tree), 0, r"@([\d.]+)")
    variants = {call.args[0].value for call in ast.walk(tree) if isinstance(call, ast.Call) and getattr(call.func, "id", "") == "variant"}
    used = re.findall(r'define_from_variant\("\w+", "(\w+)"\)|when="[+~](\w+)"|when\("\+(\w+)"\)|satisfies\("\+(\w+)"\)', text)
    complaints += [f"{SPACK}: no variant {name}" for name in sorted({"".join(each) for each in used} - variants)]
    return complaints + ([] if f'license("{LICENCE}"' in text else [f"{SPACK}: no licence {LICENCE}"])


def check_brew(root):
    text = read(root, BREW)
    lines = [re.sub(r"\s#(?!\{).*", "", line).strip() for line in text.splitlines()]
    opened = sum(bool(re.match(r"(class|def|if|unless)\b", line)) + line.endswith(" do") for line in lines)
    complaints = [] if opened == lines.count("end") else [f"{BREW}: {opened} blocks, {lines.count('end')} times `end`"]
    if shutil.which("ruby") and not complaints:
        said = subprocess.run(["ruby", "-c", root / BREW], capture_output=True, text=True, check=False)
        complaints += [f"{BREW}: {said.stderr.splitlines()[0]}"] if said.returncode else []
    found = {name: [name] for name in re.findall(r'^\s*depends_on [":]([\w@+.-]+)', text, re.M)}
    complaints += check_names(root, BREW, found) + check_options(root, BREW, text) + check_sums(BREW, text)
    installed = re.search(r"pkgshare\.install (.*)", text)
    complaints += [f"{BREW}: no file {name}" for name in re.findall(r'"([^"]+)"', installed[1] if installed else "") if not (root / name).exists()]
    return complaints + ([] if f'license "{LICENCE}"' in text else [f"{BREW}: no licence {LICENCE}"])


def check_container(root):
    text = read(root, CONTAINER)
    complaints = check_names(root, CONTAINER, container_packages(text)) + check_options(root, CONTAINER, text)
    for line in re.findall(r"^COPY (?!--from)(.*)$", text, re.M):
        complaints += [f"{CONTAINER}: no file {name}" for name in line.split()[:-1] if not (root / name).exists()]
    users = re.findall(r"^USER (\w+)$", text, re.M)
    complaints += [] if users and users[-1] != "root" else [f"{CONTAINER}: the program runs as root"]
    return complaints + ([] if f'licenses="{LICENCE}"' in text else [f"{CONTAINER}: no licence {LICENCE}"])


def check_consumer(root):
    text = read(root, CONSUMER)
    return [f"{CONSUMER}: no file {name}" for name in re.findall(r"\$\{ROOT\}/([\w/.]+)", text) if not (root / name).exists()]


def check(root):
    unknown = sorted(libraries(root) - set(LIBRARIES))
    complaints = [f"cmake/LjmdDependencies.cmake: {name}: name its package in LIBRARIES of check_packaging.py" for name in unknown]
    for one in (check_conda, check_spack, check_brew, check_container, check_consumer):
        complaints += one(root)
    return complaints + release_places.check_versions(root, "packaging/")


ROOT = Path(__file__).resolve().parents[2]


def self_test():
    names = [CONDA, SPACK, BREW, CONTAINER, CONSUMER, "CMakeLists.txt", "cmake/VERSION", "tools/packages", "LICENSE",
             "tests/consumer/main.cpp", "docs/examples/argon.cpp", *(f"cmake/{path.name}" for path in (ROOT / "cmake").glob("*.cmake"))]
    sound = {name: read(ROOT, name) for name in names}
    sound.update({f"{name}/x": "" for name in ("include", "src", "inputs", "analysis")})
    sound["src/report/web/dist/THIRD-PARTY-LICENSES"] = ""

    broken = lint.broken_in(sound)
    version = sound["cmake/VERSION"].strip()
    return lint.self_test(check, sound, [
        broken(CONDA, "        - xxhash\n", "", "no xxhash"),
        broken(CONDA, "        - xxhash\n", "        - xxhash\n        - libxml2\n", "libxml2 is not in tools/packages"),
        broken(CONDA, "context:", "context: [", "recipe.yaml: while parsing"),
        broken(CONDA, "-DLJMD_MPI=ON", "-DLJMD_MIP=ON", "no LJMD_MIP"),
        broken(CONDA, "license: GPL-3.0-or-later", "license: MIT", "licence MIT"),
        broken(CONDA, "    - LICENSE\n", "    - COPYING\n", "no file COPYING"),
        broken(CONDA, "openmm >=7.7\n      run:", "openmm >=8\n      run:", "CMake asks for 7.7"),
        broken(CONDA, f'version: "{version}"', 'version: "99.0"', "version 99.0"),
        broken(CONDA, f"sha256: {release_places.PLACEHOLDER}", "sha256: 1234", "1234 is no sha256"),
        broken(SPACK, '    depends_on("gsl@2.7:")\n', "", "no gsl"),
        broken(SPACK, "gsl@2.7:", "gsl@2.6:", "CMake asks for 2.7"),
        broken(SPACK, 'depends_on("xxhash")', 'depends_on("xxhash"', "was never closed"),
        broken(SPACK, 'variant("mpi"', 'variant("mpich"', "no variant mpi"),
        broken(SPACK, f'version("{version}"', 'version("99.0"', "version 99.0"),
        broken(SPACK, 'license("GPL-3.0-or-later"', 'license("GPL-2.0-only"', "no licence"),
        broken(BREW, '  depends_on "fftw"\n', "", "no fftw"),
        broken(BREW, '"fftw"', '"fftw"\n  depends_on "libxml2"', "libxml2 is not in tools/packages"),
        broken(BREW, "  test do\n", "  test\n", "blocks"),
        broken(BREW, f"v{version}.tar.gz", "v99.0.tar.gz", "version 99.0"),
        broken(CONTAINER, "libgsl-dev ", "", "no libgsl-dev"),
        broken(CONTAINER, "COPY inputs", "COPY decks", "no file decks"),
        broken(CONTAINER, "USER ljmd", "USER root", "as root"),
        broken(CONSUMER, "examples/argon.cpp", "examples/neon.cpp", "no file docs/examples/neon.cpp"),
        broken("cmake/LjmdDependencies.cmake", "find_package(CLI11 REQUIRED)", "find_package(CLI11 REQUIRED)\n    find_package(Boost REQUIRED)",
               "Boost: name its package"),
        broken("tools/packages", "use   libcli11-dev        cli11           cli11\n", "", "recipe.yaml: cli11 is not in"),
    ])


if __name__ == "__main__":
    sys.exit(lint.main(sys.argv[1:], __doc__, check, self_test))
