#pragma once

#include <string>

#include "report/run_facts.hpp"

namespace ljmd {

/// A paragraph for the methods section of a publication: what was simulated, how long, how it was measured, with which
/// program.
[[nodiscard]] std::string methods_paragraph(const RunFacts& facts);

/// How to cite the program, as BibTeX; CITATION.cff has the same.
[[nodiscard]] std::string bibtex_of(const std::string& version);

}  // namespace ljmd
