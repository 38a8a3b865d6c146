// A program of somebody else that uses HDF5 and GSL itself, beside a run with an H5MD trajectory: GSL's errors reach
// its own handler, and a file that it leaves to HDF5 to close, when the program ends, is whole.
//
//     host write FILE, then host check FILE
#include <gsl/gsl_errno.h>
#include <hdf5.h>
#include <ljmd/ljmd.hpp>

#include <array>
#include <filesystem>
#include <iostream>
#include <string>

namespace {

constexpr std::array<double, 3> numbers{1.5, -2.0, 0.25};
int errors_of_gsl = 0;

void count(const char* /*reason*/, const char* /*file*/, int /*line*/, int /*code*/) {
    ++errors_of_gsl;
}

bool write(const std::string& path) {
    gsl_set_error_handler(&count);
    const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    const hsize_t length = numbers.size();
    const hid_t space = H5Screate_simple(1, &length, nullptr);
    const hid_t data = H5Dcreate2(file, "numbers", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    H5Dwrite(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data());

    ljmd::FluidSpec liquid{.start = ljmd::LatticeStart{.cells = 3},
                           .density = 0.8,
                           .temperature = 1.0,
                           .potential = ljmd::PairPotential::lennard_jones("switched", {2.0, 1.5}),
                           .tail = true};
    liquid.stages = {{.name = "production", .time_step = 0.004, .steps = 20, .sample = true}};
    const std::filesystem::path directory = path + ".run";
    ljmd::run_in_directory(
        liquid, directory,
        {.files = {.trajectory = ljmd::TrajectoryOutput{.format = "h5md", .every = 10}}, .replace = true});
    gsl_error("of the program", __FILE__, __LINE__, GSL_EDOM);
    return errors_of_gsl == 1 && std::filesystem::exists(directory / "trajectory.h5md");
}

bool check(const std::string& path) {
    std::array<double, 3> found{};
    const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    const hid_t data = H5Dopen2(file, "numbers", H5P_DEFAULT);
    return H5Dread(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, found.data()) >= 0 && found == numbers;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        std::cerr << "usage: host write|check FILE\n";
        return 2;
    }
    return (argv[1] == std::string("write") ? write(argv[2]) : check(argv[2])) ? 0 : 1;
}
