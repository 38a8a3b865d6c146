#include <algorithm>

#include "cli/command_line.hpp"
#include "cli/signals.hpp"
#include "cli/streams.hpp"
#include "io/hdf5/hdf5_exit.hpp"

int main(int argc, char** argv) {
    ljmd::forget_inherited_signals();
    ljmd::prepare_standard_streams();
    ljmd::leave_hdf5_files_at_exit();
    return ljmd::run_command_line({argv + std::min(argc, 1), argv + argc});
}
