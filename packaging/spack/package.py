# Copyright Spack Project Developers. See COPYRIGHT file for details.
#
# SPDX-License-Identifier: (Apache-2.0 OR MIT)

import os

from spack_repo.builtin.build_systems.cmake import CMakePackage, generator
from spack_repo.builtin.build_systems.python import PythonExtension

from spack.package import *


class Ljmd(CMakePackage, PythonExtension):
    """Molecular dynamics of the Lennard-Jones fluid: a program, C++ libraries and a Python
    package. Results have standard errors, resumed runs end with the same bytes, and every
    processor computes the same digits."""

    homepage = "https://TO-BE-GIVEN"
    url = "https://TO-BE-GIVEN/archive/refs/tags/v1.0.0.tar.gz"
    git = "https://TO-BE-GIVEN.git"

    maintainers("TO-BE-GIVEN")

    license("GPL-3.0-or-later", checked_by="TO-BE-GIVEN")

    version("1.0.0", sha256="TO-BE-GIVEN")

    variant("python", default=False, description="Build the Python package")
    variant("openmm", default=False, description="Build the cross-check against OpenMM")
    variant("mpi", default=False, description="Share one run among processes by MPI")

    generator("ninja")

    depends_on("c", type="build")  # CMake looks for HDF5 by a program in C
    depends_on("cxx", type="build")
    depends_on("cmake@3.25:", type="build")
    depends_on("pkgconfig", type="build")

    # headers only
    depends_on("cli11", type="build")
    depends_on("nlohmann-json@3:", type="build")
    depends_on("tomlplusplus@3:", type="build")

    depends_on("eigen@3.4:3")
    depends_on("fftw@3.3:")
    depends_on("fmt")
    depends_on("gsl@2.7:")
    depends_on("hdf5@1.10.7:1 ~mpi")
    depends_on("xxhash")
    depends_on("zlib-api")

    depends_on("mpi", when="+mpi")
    depends_on("openmm@7.7:", when="+openmm")

    with when("+python"):
        extends("python")
        depends_on("python@3.9:", type=("build", "link", "run"))
        depends_on("py-pybind11@2.10:", type="build")
        depends_on("py-numpy@1.20:", type=("build", "run"))
        depends_on("py-h5py", type="run")
        depends_on("py-matplotlib", type="run")

    conflicts("%gcc@:10", msg="std::from_chars of a double needs GCC 11 or later")
    # pipe2() and memfd_create() are not there
    conflicts("platform=darwin")
    conflicts("platform=windows")

    @property
    def import_modules(self):
        return ["ljmd"] if self.spec.satisfies("+python") else []

    def cmake_args(self):
        args = [
            self.define("BUILD_SHARED_LIBS", True),
            self.define("LJMD_BUILD_TESTS", False),
            self.define("LJMD_USE_CCACHE", False),
            self.define("LJMD_MINIFY", False),  # by esbuild, which Spack does not have
            self.define_from_variant("LJMD_OPENMM", "openmm"),
            self.define_from_variant("LJMD_MPI", "mpi"),
            self.define_from_variant("LJMD_BUILD_PYTHON", "python"),
        ]
        if self.spec.satisfies("+python"):
            args.append(self.define("LJMD_PYTHON", python.path))
            args.append(
                self.define("LJMD_PYTHON_SITE", os.path.relpath(python_platlib, self.prefix))
            )
        return args

    @run_after("install")
    def copy_test_sources(self):
        cache_extra_test_sources(
            self,
            [
                join_path("packaging", "consumer"),
                join_path("tests", "consumer", "main.cpp"),
                join_path("docs", "examples", "argon.cpp"),
            ],
        )

    def test_verify(self):
        """the installed program computes the digits of its version"""
        ljmd = which(self.prefix.bin.ljmd, required=True)
        ljmd("verify")

    def test_consumer(self):
        """a project finds the libraries by find_package, and runs"""
        root = self.test_suite.current_test_cache_dir
        cmake = which(self.spec["cmake"].prefix.bin.cmake, required=True)
        with working_dir("consumer", create=True):
            cmake(
                join_path(root, "packaging", "consumer"),
                self.define("ROOT", root),
                self.define("EXPECTED_VERSION", str(self.version)),
                self.define("CMAKE_PREFIX_PATH", [self.prefix, self.spec["eigen"].prefix]),
            )
            cmake("--build", ".")
            which(join_path(".", "in_memory"), required=True)()
            which(join_path(".", "argon"), required=True)("200")
