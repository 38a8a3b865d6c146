#include "observables/few_body/closest_approach.hpp"

#include <fmt/format.h>

#include <cmath>

#include "observables/few_body/few_body_analysis.hpp"

namespace ljmd {

namespace {

class Closest : public FewBodyAnalysis {
  public:
    explicit Closest(bool attracted) : attracted_(attracted) {}

    void sample(const FewBodySample& now) override { approach_.add(now.state); }

    [[nodiscard]] std::vector<Finding> findings() const override {
        const auto& closest = approach_.closest();
        if (!closest) {
            return {};
        }
        const auto& unresolved = approach_.first_unresolved();
        if (attracted_ && unresolved) {
            std::vector<Finding> found;
            for (const char* name : {"distance", "time", "first_body", "second_body"}) {
                found.push_back({name, std::nan(""), std::nullopt, unresolved_encounter(*unresolved)});
            }
            return found;
        }
        return {{"distance", closest->distance, std::nullopt},
                {"time", closest->time, std::nullopt},
                {"first_body", static_cast<double>(closest->first), std::nullopt},
                {"second_body", static_cast<double>(closest->second), std::nullopt}};
    }

    [[nodiscard]] std::optional<DataTable> table() const override { return std::nullopt; }

    void archive(Archive& a, const State& now) override { approach_.archive(a, now); }

  private:
    bool attracted_;  ///< the force grows without limit as bodies approach, so encounters must be resolved
    ClosestApproach approach_;
};

struct ClosestApproachOptions : FewBodyAnalysisOptions {
    [[nodiscard]] Misfits check(const FewBodyTarget& target) const override {
        return target.bodies < 2 ? Misfits{{"", "closest_approach needs two bodies"}} : Misfits{};
    }
    [[nodiscard]] std::unique_ptr<FewBodyAnalysis> make(const FewBodyTarget& target) const override {
        return std::make_unique<Closest>(target.force.plugin.attracts);
    }
};

}  // namespace

/// Closest approach of any two bodies: distance, time and bodies.
FewBodyAnalysisMethod closest_approach() {
    return {.name = "closest_approach",
            .meaning =
                "the smallest distance between any two bodies, when, and which; fixed steps must resolve the encounter",
            .options = [] { return std::make_unique<ClosestApproachOptions>(); }};
}

}  // namespace ljmd
