#pragma once

#include "ljmd/detail/observables/analysis.hpp"
#include "report/page_content.hpp"
#include "report/run_facts.hpp"

namespace ljmd {

[[nodiscard]] bool has_column(const DataTable& table, const std::string& name);

/// The rows of a table that a page shows: every n-th one, at most `most`, always the first.
[[nodiscard]] DataTable thinned(const DataTable& table, std::size_t most);

/// A table of a run for the page, with these columns as far as it has them; all if none are named.
[[nodiscard]] PageTable page_table(const DataTable& table, const std::string& title, const std::string& file,
                                   const std::vector<std::string>& columns = {}, std::size_t most = 2000);

/// Add the time series of a fluid: temperature, potential energy, pressure, change of the conserved energy, density,
/// each with averages over blocks of the sampled rows. @throws DataError
void add_history(PageContent& page, const RunFacts& facts);

/// Add the blocking curves of the sampled rows: how the error of a mean grows with the length of the blocks.
/// @throws DataError
void add_blocking_curves(PageContent& page, const RunFacts& facts);

/// Add the tables of the analyses in the directory, or in its folder `analysis`: g(r), S(k), displacement, velocities.
void add_analyses(PageContent& page, const RunFacts& facts);

/// Add the wall time by phase, if the record has it.
void add_phases(PageContent& page, const RunFacts& facts);

}  // namespace ljmd
