#include "io/formats/row_writer.hpp"

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include "catch.hpp"

#include "execution/test_execution.hpp"
#include "io/files/scratch_directory.hpp"

using namespace ljmd;

namespace {

std::string written(std::size_t rows, int threads) {
    const ScratchDirectory directory;
    {
        OutputFile file(directory.path() / "rows");
        write_rows(file, test::with_threads(threads), rows, [](std::size_t k, fmt::memory_buffer& text) {
            fmt::format_to(fmt::appender(text), "{}", k);
            append_vector({0.5 * static_cast<double>(k), 0.1, -1e300}, text);
            text.push_back('\n');
        });
        file.close();
    }
    std::ifstream file(directory.path() / "rows");
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST_CASE("rows are written in their order by any number of threads") {
    for (const std::size_t rows :
         {std::size_t{0}, std::size_t{1}, std::size_t{255}, std::size_t{256}, std::size_t{3000}}) {
        std::string expected;
        for (std::size_t k = 0; k < rows; ++k) {
            expected += fmt::format("{0} {1} 0.1 -1e+300\n", k, 0.5 * static_cast<double>(k));
        }
        for (const int threads : {1, 2, 3}) {
            CAPTURE(rows, threads);
            CHECK(written(rows, threads) == expected);
        }
    }
}

TEST_CASE("a row that cannot be made is an error of the writer") {
    const ScratchDirectory directory;
    OutputFile file(directory.path() / "rows");
    CHECK_THROWS_AS(write_rows(file, test::with_threads(2), 2000,
                               [](std::size_t k, fmt::memory_buffer&) {
                                   if (k == 1500) {
                                       throw std::runtime_error("no");
                                   }
                               }),
                    std::runtime_error);
}
