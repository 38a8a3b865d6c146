#include <fmt/format.h>

#include "ljmd/observables/few_body/few_body_analysis.hpp"
#include "ljmd/observables/few_body/zero_crossings.hpp"

namespace ljmd {

namespace {

using Messages = std::vector<std::pair<std::string, std::string>>;

Messages check(const Section& section, const FewBodyTarget& target) {
    Messages messages;
    if (section.integer("body") > target.bodies) {
        messages.emplace_back("body", fmt::format("'body' in oscillation is {}, but the last body is {}",
                                                  section.integer("body"), target.bodies));
    }
    if (section.integer("component") > target.dimensions) {
        messages.emplace_back("component", fmt::format("'component' in oscillation is {}, but the last component is {}",
                                                       section.integer("component"), target.dimensions));
    }
    return messages;
}

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

}  // namespace

/// Oscillation of a coordinate about zero: its zero crossings, the period from them, and the amplitude.
FewBodyAnalysisMethod oscillation() {
    return {.name = "oscillation",
            .meaning = "passages of a coordinate through zero, with period and amplitude: oscillation.csv",
            .keys = {Key::integer("body").at_least(1).defaults_to(std::int64_t{1}).meaning("counted from 1"),
                     Key::integer("component")
                         .at_least(1)
                         .at_most(3)
                         .defaults_to(std::int64_t{1})
                         .meaning("of its position, counted from 1")},
            .check = check,
            .make = [](const Section& section, const FewBodyTarget&) -> std::unique_ptr<FewBodyAnalysis> {
                return std::make_unique<Oscillation>(section.integer("body") - 1, section.integer("component") - 1);
            }};
}

}  // namespace ljmd
