#define CATCH_CONFIG_RUNNER
#include <catch2/catch.hpp>

#include "ljmd/io/hdf5/hdf5_exit.hpp"

int main(int argc, char** argv) {
    ljmd::leave_hdf5_files_at_exit();  // as the program does: tests make writing fail
    return Catch::Session().run(argc, argv);
}
