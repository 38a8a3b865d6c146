#include <fmt/format.h>

#include "observables/few_body/few_body_analysis.hpp"
#include "observables/few_body/zero_crossings.hpp"

namespace ljmd {

namespace {

class Oscillation : public FewBodyAnalysis {
  public:
    Oscillation(Index body, Index component) : body_(body), component_(component) {}

    void sample(const FewBodySample& now) override {
        const Index i = now.state.index_of()[static_cast<std::size_t>(body_)];
        crossings_.add(now.state.time, now.state.positions()(component_, i), now.state.velocities()(component_, i));
    }

    [[nodiscard]] std::vector<Finding> findings() const override {
        std::vector<Finding> found;
        if (const auto period = crossings_.period()) {
            found.push_back({"period", period->mean, period->standard_error});
        }
        found.push_back({"amplitude", crossings_.amplitude(), std::nullopt});
        return found;
    }

    [[nodiscard]] std::optional<DataTable> table() const override {
        DataTable table{"oscillation", {"upward", "time"}, {}};
        for (const ZeroCrossing& crossing : crossings_.crossings()) {
            table.rows.push_back({crossing.direction == Direction::upward ? 1.0 : 0.0, crossing.time});
        }
        return table;
    }

    void archive(Archive& a, const State& now) override { crossings_.archive(a, now.time); }

  private:
    Index body_;
    Index component_;
    ZeroCrossings crossings_;
};

struct OscillationOptions : FewBodyAnalysisOptions {
    Index body = 1;
    Index component = 1;

    void describe(Description& description) override {
        description.integer("body", body).at_least(1).meaning("counted from 1");
        description.integer("component", component).at_least(1).at_most(3).meaning("of its position, counted from 1");
    }
    [[nodiscard]] Misfits check(const FewBodyTarget& target) const override {
        Misfits misfits;
        if (body > target.bodies) {
            misfits.emplace_back(
                "body", fmt::format("'body' in oscillation is {}, but the last body is {}", body, target.bodies));
        }
        if (component > target.dimensions) {
            misfits.emplace_back(
                "component", fmt::format("'component' in oscillation is {}, but the last component is {}", component,
                                         target.dimensions));
        }
        return misfits;
    }
    [[nodiscard]] std::unique_ptr<FewBodyAnalysis> make(const FewBodyTarget& /*target*/) const override {
        return std::make_unique<Oscillation>(body - 1, component - 1);
    }
};

}  // namespace

/// Oscillation of a coordinate about zero: its zero crossings, the period from them, and the amplitude.
FewBodyAnalysisMethod oscillation() {
    return {.name = "oscillation",
            .meaning = "passages of a coordinate through zero, with period and amplitude: oscillation.csv",
            .options = [] { return std::make_unique<OscillationOptions>(); }};
}

}  // namespace ljmd
