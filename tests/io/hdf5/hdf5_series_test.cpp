#include "../../../src/io/hdf5/hdf5_output.hpp"
#include "io/output_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;

TEST_CASE("an entry that comes in parts is that of one append, byte for byte") {
    const TemporaryFolder folder;
    std::vector<double> numbers(3 * 10);
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        numbers[k] = 0.5 * static_cast<double>(k);
    }
    const auto written = [&](const std::string& name, hsize_t part) {
        Hdf5Output::Series series{.name = "r", .entry = {10, 3}, .type = H5T_NATIVE_DOUBLE};
        Hdf5Output output(folder / name);
        output.create_series(series, {1, 4, 3});
        output.start_appending();
        for (int frame = 0; frame < 2; ++frame) {
            if (part == 0) {
                output.append(series, numbers.data());
                continue;
            }
            output.append_in_parts(series, [&](const Hdf5Output::WritePart& write) {
                for (hsize_t first = 0; first < 10; first += part) {
                    write(first, std::min<hsize_t>(part, 10 - first), numbers.data() + 3 * first);
                }
            });
        }
        output.close();
        return content_of(folder / name);
    };
    const std::string whole = written("whole", 0);
    CHECK(whole.size() > 2 * 30 * sizeof(double));
    CHECK(written("chunks", 4) == whole);
    CHECK(written("other pieces", 3) == whole);
}
