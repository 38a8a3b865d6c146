#include "fuzz_target.hpp"
#include "io/tables/json_text.hpp"
#include "io/tables/pair_table_file.hpp"
#include "ljmd/core/errors.hpp"
#include "run/given/given_record.hpp"

using namespace ljmd;

// given-potential.json, whose record has the checksum that it has itself, and the potential made of it.
LJMD_FUZZ_TARGET(pair_table) {
    const std::filesystem::path& path = fuzz::file_of(data, size);
    try {
        const std::string checksum = parse_json(fuzz::text_of(data, size)).at("checksum").text();
        const TabulatedPair table = read_pair_table(path, checksum);
        fuzz::require(checksum_of(table) == checksum, "a table was read that was changed");
        static_cast<void>(given_potential(table).known()(1.0));
        ++fuzz::inputs_accepted;
    } catch (const DataError&) {
    } catch (const InputError&) {
    }
    return 0;
}
