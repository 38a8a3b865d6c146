#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "ljmd/core/archive.hpp"
#include "ljmd/core/section.hpp"
#include "ljmd/model/state.hpp"

namespace ljmd {

/// A result as columns of numbers, to be written as a file of its own.
struct DataTable {
    std::string name;                  ///< of the file, without suffix
    std::vector<std::string> columns;  ///< header
    std::vector<std::vector<double>> rows;
};

/// Something measured on configurations during the sampled stages of a run. Sampling never changes the state.
class Analysis {
  public:
    virtual ~Analysis() = default;

    /// @return true when a configuration at this step of the run is wanted
    [[nodiscard]] virtual bool due(Index step) const = 0;
    virtual void sample(const State& state) = 0;
    [[nodiscard]] virtual Index samples() const = 0;

    /// What has been found so far. @pre samples() > 0
    [[nodiscard]] virtual DataTable result() const = 0;

    /// All that sampling has changed.
    virtual void archive(Archive& a) = 0;
};

/// A kind of analysis that [analysis] can ask for. One file in src/observables/analyses each.
struct AnalysisMethod {
    std::string name;  ///< the key in [analysis]
    std::string meaning;
    std::vector<Key> keys;
    /// Reasons why the values in the section do not fit the system: (key, message). Empty when all is well.
    std::function<std::vector<std::pair<std::string, std::string>>(const Section&, const Box&)> check;
    std::function<std::unique_ptr<Analysis>(const Section&, const State&)> make;
};

/// Every analysis there is, in alphabetical order.
[[nodiscard]] std::vector<AnalysisMethod> all_analyses();

}  // namespace ljmd
