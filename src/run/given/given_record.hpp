#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "deck/given_parts.hpp"
#include "ljmd/detail/core/data.hpp"
#include "ljmd/engine/observer.hpp"
#include "ljmd/forces/external_force.hpp"

namespace ljmd {

/// The table of a pair potential that a program gave to a run.
inline constexpr const char* pair_table_name = "given-potential.json";

/// A potential as a program gives it to a run. @throws InputError as PairPotential::custom(), or a bad `switch_start`
[[nodiscard]] GivenPotential given_potential(const PairPotential& potential);
[[nodiscard]] GivenPotential given_potential(TabulatedPair table);

[[nodiscard]] std::vector<ObserverRecord> records_of(const std::vector<Observer*>& observers);

/// Of an external force; empty if there is none.
[[nodiscard]] std::string name_of(const std::shared_ptr<ExternalForce>& external);

/// `given` in run.json: null if a program gave nothing.
[[nodiscard]] Data given_data(const GivenParts& given);

/// What run.json says, with the potential of its table. A potential without a table, or with one that cannot be read,
/// is missing (GivenPotential::missing).
/// @param directory  of the run  @throws WrongData
[[nodiscard]] GivenParts given_parts(const Data& given, const std::filesystem::path& directory);

/// "the pair potential 'soft' and the observables 'fastest' (every 10 steps), 'slowest' (every 5 steps)"
[[nodiscard]] std::string in_words(const GivenParts& given);

/// How the run is resumed: 'ljmd resume DIR', or what the program that began it calls.
[[nodiscard]] std::string how_to_resume(const GivenParts& given, const std::filesystem::path& directory);

/// What a program gives to a run that it resumes.
struct GivenAgain {
    std::string by = {};  ///< its language; empty: the command line, which can give nothing
    std::optional<PairPotential> potential = {};
    std::vector<Observer*> observers = {};
    std::shared_ptr<ExternalForce> external = {};
};

/// The parts of a run that is resumed: as in its record, with the potential that is given again, if one is.
/// @throws CheckpointError  they are not those that the run was begun with, or the potential is missing
[[nodiscard]] GivenParts resumed_parts(GivenParts recorded, const GivenAgain& again,
                                       const std::filesystem::path& directory);

}  // namespace ljmd
