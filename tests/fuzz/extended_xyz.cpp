#include "configuration_promises.hpp"
#include "ljmd/io/configuration_reader.hpp"

using namespace ljmd;

// By the reader of all formats, so that the other two are recognised here, too. With units, files in SI units are read.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr double sigma = 3.405e-10;
    constexpr double epsilon = 1.654e-21;
    constexpr double mass = 6.6335e-26;
    try {
        fuzz::check_promises(read_configuration(fuzz::file_of(data, size), SubstanceUnits(sigma, epsilon, mass)));
    } catch (const DataError&) {
    }
    return 0;
}
