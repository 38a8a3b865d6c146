#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/document.hpp"
#include "deck/deck.hpp"
#include "deck/fluid.hpp"
#include "study/sweep_record.hpp"

namespace ljmd {

inline constexpr Index max_replicas = 10'000;

/// Seed of a replica: the first 53 bits of XXH3 (64 bits) of its number in 8 bytes, with the seed of the deck as the
/// seed of the hash. Replicas of decks with seeds 1 and 2 thus share no seed, as 1, 2, 3 and 2, 3, 4 would.
/// @param number  from 1
[[nodiscard]] std::uint64_t replica_seed(std::uint64_t seed, Index number);

/// The runs of a deck with so many seeds: a sweep over `system.seed`. A stage that ends when errors are reached is to
/// reach errors larger by sqrt(replicas) in each of them, so that the merged ones are those wanted.
/// @param deck  of a fluid; `settings` are those it was loaded with
[[nodiscard]] SweepPlan replica_plan(const Deck& deck, const std::vector<std::string>& settings, Index replicas);

/// Why all replicas of a deck would be the same run: nothing in it is drawn at random; empty if something is.
[[nodiscard]] std::string why_all_the_same(const Deck& deck, const Start& start);

/// The results of finished replicas, merged: see merged_mean(). An observable that has no value in one of them has
/// none: those in which the fluctuations were small enough for one would be a choice. Remarks are the runs' remarks,
/// each once, with the number of runs that have it. Where the error of a run is a guess, so is the error from the
/// scatter of fewer than 16 runs. Runs of different lengths are told. Data, in results.json: title, kind "replicas",
/// replicas, seeds, observables as in the results of a run, and in each standard_error_within and
/// standard_error_between; doubts and warnings. Text, on the screen and in results.txt: the table of a run.
/// @param runs  of the plan, all finished  @throws DataError  results of a run are missing or damaged
[[nodiscard]] Document replicas_report(const Deck& deck, const std::vector<ChildRun>& runs,
                                       const std::filesystem::path& directory);

/// The files that write_replicas() writes.
[[nodiscard]] std::vector<std::string> replica_output_names();

/// Write results.json, results.txt and the merged tables of the runs into their directory. @throws FileError
void write_replicas(const Document& report, const std::vector<ChildRun>& runs, const OpenDirectory& directory);

}  // namespace ljmd
