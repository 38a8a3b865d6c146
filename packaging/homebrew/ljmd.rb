class Ljmd < Formula
  desc "Molecular dynamics of the Lennard-Jones fluid, with error bars"
  homepage "https://TO-BE-GIVEN"
  url "https://TO-BE-GIVEN/archive/refs/tags/v1.0.0.tar.gz"
  sha256 "TO-BE-GIVEN"
  license "GPL-3.0-or-later"

  depends_on "cli11" => :build
  depends_on "cmake" => [:build, :test]
  depends_on "esbuild" => :build
  depends_on "ninja" => :build
  depends_on "nlohmann-json" => :build
  depends_on "pkgconf" => :build
  depends_on "pybind11" => :build
  depends_on "eigen@3" # in the public headers; version 5 does not count as 3.4
  depends_on "fftw"
  depends_on "fmt"
  depends_on "gsl"
  depends_on "hdf5"
  depends_on :linux # calls pipe2() and memfd_create(), which macOS does not have
  depends_on "numpy"
  depends_on "open-mpi"
  depends_on "python-matplotlib"
  depends_on "python@3.14"
  depends_on "tomlplusplus"
  depends_on "xxhash"
  depends_on "zlib-ng-compat"

  def python3
    which("python3.14")
  end

  def install
    site_packages = Language::Python.site_packages(python3)
    args = %W[
      -DBUILD_SHARED_LIBS=ON
      -DLJMD_BUILD_PYTHON=ON
      -DLJMD_BUILD_TESTS=OFF
      -DLJMD_MINIFY=ON
      -DLJMD_MPI=ON
      -DLJMD_OPENMM=OFF
      -DLJMD_PYTHON=#{python3}
      -DLJMD_PYTHON_SITE=#{site_packages}
      -DLJMD_USE_CCACHE=OFF
    ]
    system "cmake", "-S", ".", "-B", "build", "-G", "Ninja", *args, *std_cmake_args
    system "cmake", "--build", "build"
    system "cmake", "--install", "build"
    pkgshare.install "packaging/consumer", "tests/consumer/main.cpp", "docs/examples/argon.cpp"
  end

  test do
    system bin/"ljmd", "verify"
    system bin/"ljmd", "check", pkgshare/"inputs/examples/first.toml"
    system python3, "-c", "import ljmd; print(ljmd.eos(temperature=1.5, density=0.5).pressure)"

    (testpath/"tests/consumer").install_symlink pkgshare/"main.cpp"
    (testpath/"docs/examples").install_symlink pkgshare/"argon.cpp"
    system "cmake", "-S", pkgshare/"consumer", "-B", "consumer", "-DROOT=#{testpath}", "-DEXPECTED_VERSION=#{version}",
           "-DCMAKE_PREFIX_PATH=#{prefix};#{Formula["eigen@3"].opt_prefix}"
    system "cmake", "--build", "consumer"
    system "consumer/in_memory"
    assert_match(/pressure = .* \+- /, shell_output("consumer/argon 200"))
  end
end
