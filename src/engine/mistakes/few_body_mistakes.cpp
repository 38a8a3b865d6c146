#include "engine/mistakes/few_body_mistakes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <set>
#include <utility>

#include "engine/few_body_system.hpp"
#include "engine/mistakes/keys_of_mistakes.hpp"
#include "integrators/integrator.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/options/description.hpp"
#include "observables/few_body/few_body_analysis.hpp"

namespace ljmd {

namespace {

std::string count(std::size_t components) {
    return fmt::format("{} component{}", components, components == 1 ? "" : "s");
}

Mistake of_body(std::size_t body, std::string key, std::string message, std::string hint = {}) {
    return {"body", "", body, std::move(message), false, {std::move(key)}, std::move(hint)};
}

/// Collects what is wrong with a whole specification, in words.
class Sentences {
  public:
    void add(const std::vector<Mistake>& mistakes) {
        std::ranges::transform(mistakes, std::back_inserter(all), in_words);
    }
    /// The sentence of what `choose` throws.
    void add_thrown(const std::string& where, const std::function<void()>& choose) {
        try {
            choose();
        } catch (const InputError& error) {
            all.push_back(fmt::format("{}: {}", where, error.what()));
        }
    }

    std::vector<std::string> all;
};

void judge_stages(const FewBodySpec& spec, Sentences& sentences) {
    for (const Stage& stage : spec.stages) {
        const std::string where = fmt::format("stage '{}'", stage.name);
        sentences.add_thrown(where, [&] { static_cast<void>(completed(stage)); });
        const bool of_a_fluid =
            stage.temperature || stage.thermostat || stage.barostat || stage.total_energy || !stage.until.empty();
        if (of_a_fluid) {
            sentences.all.push_back(where +
                                    ": few bodies have no temperature, thermostat, barostat or total energy, "
                                    "and their stages end after a number of steps");
        }
    }
    sentences.add(stage_mistakes(spec.stages));
    if (!spec.analyses.empty()) {
        sentences.add(few_body_sampling_mistakes(spec.stages));
    }
}

}  // namespace

std::vector<Mistake> dimension_mistakes(const std::vector<BodyStart>& bodies) {
    std::vector<Mistake> found;
    std::size_t dimensions = 0;
    for (std::size_t k = 0; k < bodies.size(); ++k) {
        for (const auto member : {&BodyStart::position, &BodyStart::velocity}) {
            const std::size_t components = (bodies[k].*member).size();
            dimensions = dimensions == 0 ? components : dimensions;
            if (components != 0 && components != dimensions) {
                found.push_back(of_body(k, key(member),
                                        fmt::format("'{}' of body {} has {}, but the first vector has {}", key(member),
                                                    k + 1, count(components), dimensions),
                                        fmt::format("all vectors of all bodies have {}", count(dimensions))));
            }
        }
    }
    return found;
}

std::vector<Mistake> force_mistakes(const std::vector<BodyStart>& bodies, const FewBodyForceMethod& force) {
    const std::size_t dimensions = bodies.front().position.size();
    const auto fits = [&](int limit) { return static_cast<std::size_t>(limit); };
    if (dimensions >= fits(force.min_dimensions) && dimensions <= fits(force.max_dimensions)) {
        return {};
    }
    return {of_body(0, key(&BodyStart::position),
                    fmt::format("'position' has {}, but force '{}' moves a coordinate of {}", count(dimensions),
                                force.name, count(fits(force.max_dimensions))))};
}

std::vector<Mistake> start_mistakes(const std::vector<BodyStart>& bodies, const ChosenFewBodyForce& force) {
    const auto problem = force.options->check(few_body_start(bodies, *force.options));
    if (!problem) {
        return {};
    }
    return {of_body(static_cast<std::size_t>(problem->body), key(&BodyStart::position), problem->message)};
}

std::vector<Mistake> few_body_analysis_mistakes(const std::vector<Choice>& analyses,
                                                const std::vector<BodyStart>& bodies, const ChosenFewBodyForce& force) {
    const FewBodyTarget target{static_cast<Index>(bodies.size()), static_cast<int>(bodies.front().position.size()),
                               force};
    std::vector<Mistake> all;
    for (const Choice& analysis : analyses) {
        for (const auto& [key, message] : chosen_few_body_analysis(analysis).options->check(target)) {
            std::vector<std::string> keys;
            if (!key.empty()) {
                keys.push_back(key);
            }
            all.push_back({"analysis", analysis.name, 0, message, false, std::move(keys), {}});
        }
    }
    return all;
}

std::vector<std::string> mistakes(const FewBodySpec& spec) {
    Sentences sentences;
    sentences.add_thrown("force", [&] { static_cast<void>(chosen_few_body_force(spec.force)); });
    for (std::size_t k = 0; k < spec.bodies.size(); ++k) {
        BodyStart body = spec.bodies[k];
        Description description;
        body.describe(description);
        const std::string name = fmt::format("body {}", k + 1);
        sentences.add_thrown(
            name, [&] { static_cast<void>(checked_settings(name, description.keys(), description.values())); });
    }
    if (spec.bodies.empty()) {
        sentences.all.emplace_back("bodies: at least one is needed");
    }
    std::set<std::string> names;
    for (const Choice& analysis : spec.analyses) {
        const std::string where = "analysis " + analysis.name;
        sentences.add_thrown(where, [&] { static_cast<void>(chosen_few_body_analysis(analysis)); });
        if (!names.insert(analysis.name).second) {
            sentences.all.push_back(where + ": it is there twice");
        }
    }
    if (spec.stages.empty()) {
        sentences.all.emplace_back("stages: at least one is needed; one of 0 steps evaluates the start");
    }
    if (spec.sample_every < 1) {
        sentences.all.emplace_back("sample_every: it must be at least 1");
    }
    judge_stages(spec, sentences);
    // Each rule rests on those before it.
    const auto add_if_none = [&](const std::function<std::vector<Mistake>()>& rule) {
        if (sentences.all.empty()) {
            sentences.add(rule());
        }
    };
    add_if_none([&] { return dimension_mistakes(spec.bodies); });
    add_if_none([&] { return force_mistakes(spec.bodies, find_few_body_force(spec.force.name)); });
    add_if_none([&] { return start_mistakes(spec.bodies, chosen_few_body_force(spec.force)); });
    add_if_none(
        [&] { return few_body_analysis_mistakes(spec.analyses, spec.bodies, chosen_few_body_force(spec.force)); });
    return sentences.all;
}

}  // namespace ljmd
