#include "ljmd/observables/closest_approach.hpp"

#include <fmt/format.h>

#include "ljmd/observables/few_body_analysis.hpp"

namespace ljmd {

namespace {

class Closest : public FewBodyAnalysis {
  public:
    void sample(const FewBodySample& now) override { approach_.add(now.state); }

    [[nodiscard]] std::vector<Finding> findings() const override {
        const auto& closest = approach_.closest();
        if (!closest) {
            return {};
        }
        return {{"distance", closest->distance, std::nullopt},
                {"time", closest->time, std::nullopt},
                {"first_body", static_cast<double>(closest->first), std::nullopt},
                {"second_body", static_cast<double>(closest->second), std::nullopt}};
    }

    [[nodiscard]] std::optional<DataTable> table() const override { return std::nullopt; }

    void archive(Archive& a, const State& now) override { approach_.archive(a, now); }

  private:
    ClosestApproach approach_;
};

}  // namespace

/// How near any two bodies came to each other, when, and which.
FewBodyAnalysisMethod closest_approach() {
    return {.name = "closest_approach",
            .meaning =
                "the smallest distance between any two bodies, when, and which; fixed steps must resolve the encounter",
            .keys = {},
            .check =
                [](const Section& section, const FewBodyTarget& target) {
                    std::vector<std::pair<std::string, std::string>> messages;
                    if (target.bodies < 2) {
                        messages.emplace_back("", fmt::format("{} needs two bodies", section.title()));
                    }
                    return messages;
                },
            .make = [](const Section&, const FewBodyTarget&) -> std::unique_ptr<FewBodyAnalysis> {
                return std::make_unique<Closest>();
            }};
}

}  // namespace ljmd
