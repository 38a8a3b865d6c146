#include "io/tables/pair_table_file.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <limits>

#include "io/files/replacement_file.hpp"
#include "io/tables/exact_json.hpp"
#include "io/tables/json_file.hpp"
#include "io/tables/json_text.hpp"

namespace ljmd {

namespace {

constexpr const char* format_name = "ljmd pair table";
constexpr std::int64_t version = 1;

/// All but the checksum.
Data values_of(const TabulatedPair& pair) {
    return {{"format", format_name},
            {"version", version},
            {"name", pair.name},
            {"truncation", pair.truncation},
            {"cutoff", pair.cutoff.radius},
            {"switch_start", pair.cutoff.switch_start},
            {"error", pair.error},
            {"force_error", pair.force_error},
            {"first", pair.first},
            {"energies", pair.energies}};
}

/// An error that whoever made the table does not know is null.
double error_of(const Data& value) {
    return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.number();
}

TabulatedPair pair_of(const Data& data) {
    const Data* format = data.find("format");
    if (format == nullptr || !(*format == Data(format_name))) {
        throw WrongData("it is another file");
    }
    if (!(data.at("version") == Data(version))) {
        throw WrongData(fmt::format("it has version {}, and this program reads version {}",
                                    to_json_line(data.at("version")), version));
    }
    TabulatedPair pair{.name = data.at("name").text(),
                       .truncation = data.at("truncation").text(),
                       .cutoff = {data.at("cutoff").number(), data.at("switch_start").number()},
                       .first = data.at("first").number(),
                       .energies = {},
                       .error = error_of(data.at("error")),
                       .force_error = error_of(data.at("force_error"))};
    for (const Data& energy : data.at("energies").items()) {
        pair.energies.push_back(energy.number());
    }
    return pair;
}

}  // namespace

std::string checksum_of(const TabulatedPair& pair) {
    const std::string text = to_exact_json(values_of(pair));
    return fmt::format("xxh3:{:016x}", XXH3_64bits(text.data(), text.size()));
}

void write_pair_table(const OutputPlace& place, const TabulatedPair& pair) {
    Data all = values_of(pair);
    all["checksum"] = checksum_of(pair);
    write_file_atomically(place, to_exact_json(all) + "\n");
}

TabulatedPair read_pair_table(const std::filesystem::path& path, const std::string& checksum) {
    return read_json(path, "the table of a pair potential", [&](const Data& data) {
        TabulatedPair pair = pair_of(data);
        const std::string found = checksum_of(pair);
        if (data.at("checksum").text() != found) {
            throw WrongData("it is damaged: its values do not have its checksum");
        }
        if (found != checksum) {
            throw WrongData(fmt::format("it is another one: its checksum is {}, not {}", found, checksum));
        }
        return pair;
    });
}

}  // namespace ljmd
