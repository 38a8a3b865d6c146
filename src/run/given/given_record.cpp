#include "run/given/given_record.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <xxhash.h>

#include <utility>

#include "core/text.hpp"
#include "engine/mistakes/mistakes.hpp"
#include "io/files/shell_word.hpp"
#include "io/tables/json_file.hpp"
#include "io/tables/pair_table_file.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/engine/stage.hpp"
#include "potentials/potential_identity.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_observers = 1000;

Data potential_data(const GivenPotential& potential) {
    Data table = nullptr;
    if (potential.table) {
        table = {{"file", pair_table_name},
                 {"error", potential.table->error},
                 {"force_error", potential.table->force_error}};
    }
    return {{"name", potential.name},
            {"truncation", potential.truncation},
            {"cutoff", potential.cutoff.radius},
            {"switch_start", potential.cutoff.switch_start},
            {"checksum", potential.checksum},
            {"table", table}};
}

/// Read the table of a potential, or say why that is impossible.
void read_table(GivenPotential& potential, const fs::path& path) {
    try {
        potential = given_potential(read_pair_table(path, potential.checksum));
    } catch (const Error& why) {
        potential.bad_table = true;
        potential.missing =
            fmt::format("the pair potential {} of this run is not known: {}", in_quotes(potential.name), why.what());
    }
}

GivenPotential potential_of(const Data& data, const std::string& by, const fs::path& directory) {
    GivenPotential potential{.name = data.at("name").text(),
                             .truncation = data.at("truncation").text(),
                             .cutoff = {data.at("cutoff").number(), data.at("switch_start").number()},
                             .checksum = data.at("checksum").text()};
    const Data& table = data.at("table");
    if (table.is_null()) {
        potential.missing = fmt::format("the pair potential {} of this run is a formula of the {} program that made it",
                                        in_quotes(potential.name), by);
    } else if (table.at("file").text() != pair_table_name) {
        throw WrongData(fmt::format("the table of its potential is not {}", pair_table_name));
    } else {
        read_table(potential, directory / pair_table_name);
    }
    return potential;
}

Data observer_data(const ObserverRecord& observer) {
    return {{"name", observer.name},
            {"unit", observer.unit},
            {"every", observer.every > 0 ? Data(observer.every) : Data(nullptr)},
            {"energy", observer.energy}};
}

ObserverRecord observer_of(const Data& data) {
    const Data& every = data.at("every");
    return {.name = data.at("name").text(),
            .unit = data.at("unit").text(),
            .every = every.is_null() ? 0 : integer_of(every, "every", 1, max_steps),
            .energy = data.at("energy").flag()};
}

/// "the observables 'fastest' (every 10 steps), ..."; "no observables"
std::string in_words(const std::vector<ObserverRecord>& observers) {
    if (observers.empty()) {
        return "no observables";
    }
    std::vector<std::string> words;
    for (const ObserverRecord& observer : observers) {
        std::vector<std::string> details;
        if (observer.every > 0) {
            details.push_back(fmt::format("every {} steps", observer.every));
        }
        if (observer.energy) {
            details.emplace_back("with energy");
        }
        if (!observer.unit.empty()) {
            details.push_back(printable(observer.unit, 60));
        }
        words.push_back(fmt::format("{}{}", observer.name.empty() ? "(unnamed)" : in_quotes(observer.name),
                                    details.empty() ? "" : fmt::format(" ({})", fmt::join(details, ", "))));
    }
    return fmt::format("the observable{} {}", observers.size() == 1 ? "" : "s", fmt::join(words, ", "));
}

/// "the external force 'wave'"; "no external force"
std::string force_in_words(const std::string& name) {
    return name.empty() ? "no external force" : fmt::format("the external force {}", in_quotes(name));
}

void require_same(const GivenPotential& recorded, const GivenPotential& again) {
    const bool same = recorded.potential ? identity(*recorded.potential) == identity(again.known())
                                         : recorded.checksum == again.checksum;
    if (!same) {
        throw CheckpointError(
            fmt::format("the run was begun with the pair potential {}, {} at {}, and another one is "
                        "given: {}, {} at {}, or one with other values",
                        in_quotes(recorded.name), recorded.truncation, recorded.cutoff.radius, in_quotes(again.name),
                        again.truncation, again.cutoff.radius));
    }
}

}  // namespace

GivenPotential given_potential(const PairPotential& potential) {
    const std::string text = identity(potential);
    return {.name = potential.formula(),
            .truncation = potential.truncation(),
            .cutoff = potential.cutoff(),
            .checksum = fmt::format("xxh3:{:016x}", XXH3_64bits(text.data(), text.size())),
            .potential = potential};
}

GivenPotential given_potential(TabulatedPair table) {
    for (const Mistake& mistake : potential_mistakes(table.truncation, table.cutoff, false)) {
        throw InputError(in_words(mistake));
    }
    GivenPotential given = given_potential(table.potential());
    given.checksum = checksum_of(table);
    given.table = std::move(table);
    return given;
}

std::vector<ObserverRecord> records_of(const std::vector<Observer*>& observers) {
    std::vector<ObserverRecord> records;
    records.reserve(observers.size());
    for (const Observer* observer : observers) {
        records.push_back(observer->record());
    }
    return records;
}

std::string name_of(const std::shared_ptr<ExternalForce>& external) {
    return external ? external->name() : "";
}

Data given_data(const GivenParts& given) {
    if (given.empty()) {
        return nullptr;
    }
    Data observers = Data::list();
    for (const ObserverRecord& observer : given.observers) {
        observers.push_back(observer_data(observer));
    }
    return {{"by", given.by},
            {"potential", given.potential ? potential_data(*given.potential) : Data(nullptr)},
            {"observables", observers},
            {"external_force", given.external.empty() ? Data(nullptr) : Data(given.external)}};
}

GivenParts given_parts(const Data& given, const fs::path& directory) {
    GivenParts parts;
    if (given.is_null()) {
        return parts;
    }
    parts.by = given.at("by").text();
    if (const Data& potential = given.at("potential"); !potential.is_null()) {
        parts.potential = potential_of(potential, parts.by, directory);
    }
    if (given.at("observables").size() > max_observers) {
        throw WrongData(fmt::format("it has more than {} observables", max_observers));
    }
    for (const Data& observer : given.at("observables").items()) {
        parts.observers.push_back(observer_of(observer));
    }
    if (const Data& external = given.at("external_force"); !external.is_null()) {
        parts.external = external.text();
    }
    return parts;
}

std::string in_words(const GivenParts& given) {
    std::vector<std::string> words;
    if (given.potential) {
        words.push_back(fmt::format("the pair potential {}", in_quotes(given.potential->name)));
    }
    if (!given.external.empty()) {
        words.push_back(force_in_words(given.external));
    }
    if (!given.observers.empty()) {
        words.push_back(in_words(given.observers));
    }
    return fmt::format("{}", fmt::join(words, " and "));
}

std::string how_to_resume(const GivenParts& given, const fs::path& directory) {
    if (given.empty()) {
        return fmt::format("ljmd resume {}", shell_word(directory));
    }
    if (given.by != "Python") {
        return fmt::format("resume_in_directory({}, ...) in the program that began it",
                           string_literal(directory.string()));
    }
    std::vector<std::string> names;
    for (const ObserverRecord& observer : given.observers) {
        names.push_back(printable(observer.name, 60));
    }
    return fmt::format("ljmd.resume({}{}{}) in Python", string_literal(directory.string()),
                       names.empty() ? "" : fmt::format(", observables=[{}]", fmt::join(names, ", ")),
                       given.external.empty() ? "" : fmt::format(", external={}", printable(given.external, 60)));
}

GivenParts resumed_parts(GivenParts recorded, const GivenAgain& again, const fs::path& directory) {
    const std::string how = how_to_resume(recorded, directory);
    if (again.by.empty() && !recorded.empty()) {
        throw CheckpointError(
            fmt::format("{} was run with {} of a program in {}, which the command line does not "
                        "have\n  to go on: {}",
                        directory.string(), in_words(recorded), printable(recorded.by, 60), how));
    }
    if (const auto given = records_of(again.observers); given != recorded.observers) {
        throw CheckpointError(fmt::format("{} was begun with {}; given: {}\n  to go on: {}", directory.string(),
                                          in_words(recorded.observers), in_words(given), how));
    }
    if (const std::string given = name_of(again.external); given != recorded.external) {
        throw CheckpointError(fmt::format("{} was begun with {}; given: {}\n  to go on: {}", directory.string(),
                                          force_in_words(recorded.external), force_in_words(given), how));
    }
    if (again.potential) {
        if (!recorded.potential) {
            throw CheckpointError(
                fmt::format("{} was run with the potential of its deck, and another one is given", directory.string()));
        }
        GivenPotential given = given_potential(*again.potential);
        require_same(*recorded.potential, given);
        recorded.potential->potential = std::move(given.potential);
    }
    if (recorded.potential && !recorded.potential->potential) {
        throw CheckpointError(recorded.potential->missing +
                              (recorded.potential->bad_table ? "" : fmt::format("\n  to go on: {}", how)));
    }
    return recorded;
}

}  // namespace ljmd
