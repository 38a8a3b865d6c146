#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "deck/checked_run.hpp"
#include "ljmd/detail/options/units.hpp"

namespace ljmd {

/// The options of the commands that take a deck.
struct DeckOptions {
    std::string deck;
    std::vector<std::string> settings{};  ///< arguments of --set
    bool force = false;
    bool quiet = false;
    bool json = false;
    std::string precision{};  ///< replaces the deck's unless empty
    std::string simd{};       ///< SIMD level to use; empty: LJMD_SIMD, else the highest
    int threads = 0;          ///< 0: OMP_NUM_THREADS, or 1

    void add_to(CLI::App& command, bool deck_is_required = true);

    /// The settings of --set and of the other options. @throws InputError  --simd or LJMD_SIMD is wrong
    [[nodiscard]] std::vector<std::string> all_settings() const;

    /// @throws InputError with all mistakes of the deck
    [[nodiscard]] Deck load(Diagnostics& diagnostics) const;

    /// The start of a deck after all checks, and the threads that the system has granted. Prints the warnings.
    [[nodiscard]] CheckedRun checked(const Deck& deck, Diagnostics& diagnostics,
                                     const std::shared_ptr<Ranks>& ranks = nullptr) const;
};

/// --threads of a command. @param threads  0 if it is not given
CLI::Option* add_threads(
    CLI::App& command, int& threads,
    const std::string& meaning = "threads to share the work, 1 or OMP_NUM_THREADS by default; no result depends on it");

/// --simd of a command. @param simd  empty if it is not given
CLI::Option* add_simd(CLI::App& command, std::string& simd);

/// --jobs of a command that makes several runs. @param jobs  0 if it is not given
CLI::Option* add_jobs(CLI::App& command, int& jobs, const std::string& meaning);

/// --walltime of a command. @param of  what is stopped, with a colon; empty: the run
CLI::Option* add_walltime(CLI::App& command, std::string& walltime, const std::string& of = "");

/// Check of options that take a number in reduced units: says what to write instead of "120 K".
[[nodiscard]] CLI::Validator reduced(const std::string& unit, Dimension dimension);

}  // namespace ljmd
