#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "observables/few_body/closest_approach.hpp"
#include "observables/few_body/few_body_analysis.hpp"
#include "observables/few_body/orbital_elements.hpp"
#include "observables/few_body/turning_points.hpp"

namespace ljmd {

namespace {

constexpr double resolved_path = 0.5;        // in a step, in units of the distance; as for closest_approach
constexpr double resolved_path_alone = 1.0;  // farther the ellipse breaks; up to here it only turns and breathes
constexpr double significance = 3.0;         // standard errors
constexpr double interpolation = 1e-6;       // relative error of what lies within steps

constexpr const char* step_error =
    "alone, the two move on an ellipse that does not change: what differs from that of the start is the error of the "
    "time step";

/// Whether the path goes round a point that attracts without a limit.
bool is_attracted(const FewBodyTarget& target, std::optional<Index> about) {
    const auto mu = target.force.options->gravitational_parameter(1.0, about ? std::optional(1.0) : std::nullopt);
    return target.force.plugin.has_polar_angle || (mu && *mu > 0.0);
}

class Orbit : public FewBodyAnalysis {
  public:
    Orbit(Index body, std::optional<Index> about, const FewBodyTarget& target)
        : body_(body),
          about_(about),
          force_(target.force.options),
          attracted_(is_attracted(target, about)),
          alone_(target.bodies == 1 ||
                 (about && target.bodies == 2 && !(force_->gravitational_parameter(1.0, std::nullopt) > 0.0))) {
        if (attracted_ && !alone_) {
            encounters_.emplace();
        }
    }

    void sample(const FewBodySample& now) override {
        const State& state = now.state;
        if (encounters_) {
            encounters_->add(state);
        }
        const std::vector<Index> index_of = state.index_of();
        const Index i = index_of[static_cast<std::size_t>(body_)];
        Vec3 r = state.positions().col(i);
        Vec3 v = state.velocities().col(i);
        std::optional<double> other_mass;
        if (about_) {
            const Index j = index_of[static_cast<std::size_t>(*about_)];
            r -= state.positions().col(j);
            v -= state.velocities().col(j);
            other_mass = state.masses()[static_cast<std::size_t>(j)];
        }
        if (now.angle) {
            points_.add_radial(state.time, r[0], v[0], now.angle->value, now.angle->rate);
            return;
        }
        points_.add(state.time, r, v);
        const auto mu = force_->gravitational_parameter(state.masses()[static_cast<std::size_t>(i)], other_mass);
        // Bodies at the same place, or out of the range of numbers, have no ellipse. Their next force ends the run.
        if (mu && *mu > 0.0 && r.norm() > 0.0) {
            last_ = orbital_elements(r, v, *mu);
            first_ = first_ ? first_ : last_;
        }
    }

    [[nodiscard]] std::vector<Finding> findings() const override {
        const std::optional<Unresolved> lost = first_unresolved();
        std::vector<Finding> found;
        const auto add_mean = [&](const char* name, const std::optional<IntervalMean>& mean, double of_ellipse,
                                  double unit) {
            if (lost) {
                found.push_back({name, std::nan(""), std::nullopt, lost->remark});
            } else if (mean) {
                const double error = std::isfinite(mean->standard_error) ? mean->standard_error : 0.0;
                const double least = std::max(significance * error, interpolation * unit);
                found.push_back({name, mean->mean, mean->standard_error, remark_on(mean->mean - of_ellipse, least)});
            }
        };
        const double period = first_ ? first_->period : std::nan("");
        add_mean("period", points_.period(), period, period);
        add_mean("precession", points_.precession(), 0.0, 1.0);
        for (const Apsis kind : {Apsis::pericentre, Apsis::apocentre}) {
            const auto& all = points_.passages();
            const auto passage = std::ranges::find(all, kind, &Passage::kind);
            if (passage == all.end()) {
                continue;
            }
            const bool near = kind == Apsis::pericentre;
            const char* name = near ? "first_pericentre" : "first_apocentre";
            if (lost && passage->time >= lost->time) {
                found.push_back({name, std::nan(""), std::nullopt, lost->remark});
            } else {
                const double exact = !first_ ? std::nan("") : near ? first_->pericentre : first_->apocentre;
                found.push_back({name, passage->distance, std::nullopt,
                                 remark_on(passage->distance - exact, interpolation * exact)});
            }
        }
        if (first_) {
            add_elements(found, "_at_start", *first_, {}, "");
            add_elements(found, "_at_end", *last_, lost, remark_on(change_of_ellipse(), interpolation));
        }
        return found;
    }

    [[nodiscard]] std::optional<DataTable> table() const override {
        const std::optional<Unresolved> lost = first_unresolved();
        DataTable table{"orbit", {"apocentre", "time", "distance", "angle"}, {}};
        for (const Passage& passage : points_.passages()) {
            if (lost && passage.time >= lost->time) {
                break;
            }
            table.rows.push_back(
                {passage.kind == Apsis::apocentre ? 1.0 : 0.0, passage.time, passage.distance, passage.angle});
        }
        return table;
    }

    void archive(Archive& a, const State& now) override {
        points_.archive(a, now.time);
        a(first_, last_);
        if (encounters_) {
            encounters_->archive(a, now);
        }
    }

  private:
    /// An encounter that steps do not resolve, from which on the motion is wrong.
    struct Unresolved {
        double time;
        std::string remark;
    };

    [[nodiscard]] std::optional<Unresolved> first_unresolved() const {
        std::optional<Unresolved> first;
        if (encounters_ && encounters_->first_unresolved()) {
            const Approach& approach = *encounters_->first_unresolved();
            first = {approach.time, unresolved_encounter(approach)};
        }
        const double limit = alone_ ? resolved_path_alone : resolved_path;
        for (const Passage& passage : points_.passages()) {
            if (first && first->time <= passage.time) {
                break;
            }
            if (attracted_ && passage.kind == Apsis::pericentre && passage.path_in_step > limit * passage.distance) {
                const std::string who = about_ ? fmt::format("bodies {} and {} meet", *about_ + 1, body_ + 1)
                                               : fmt::format("body {} and the centre meet", body_ + 1);
                return Unresolved{passage.time,
                                  unresolved_encounter(who, passage.time, passage.path_in_step / passage.distance)};
            }
        }
        return first;
    }

    /// @param difference  from what the ellipse of the start has; NaN if that is not known
    [[nodiscard]] std::string remark_on(double difference, double least) const {
        return attracted_ && alone_ && std::abs(difference) > least ? step_error : "";
    }

    /// Of energy and direction from start to end, relative.
    [[nodiscard]] double change_of_ellipse() const {
        const double energy = last_->specific_energy / first_->specific_energy - 1.0;
        const double turned =
            std::remainder(last_->argument_of_pericentre - first_->argument_of_pericentre, 2.0 * std::numbers::pi);
        return std::max(std::abs(energy), first_->eccentricity * std::abs(turned));
    }

    static void add_elements(std::vector<Finding>& found, const std::string& when, const OrbitalElements& elements,
                             const std::optional<Unresolved>& lost, const std::string& remark) {
        const std::vector<std::pair<const char*, double>> values{
            {"specific_energy", elements.specific_energy},
            {"specific_angular_momentum", elements.angular_momentum.norm()},
            {"semi_major_axis", elements.semi_major_axis},
            {"eccentricity", elements.eccentricity},
            {"kepler_period", elements.period},
            {"argument_of_pericentre", elements.argument_of_pericentre}};
        for (const auto& [name, value] : values) {
            found.push_back({name + when, lost ? std::nan("") : value, std::nullopt, lost ? lost->remark : remark});
        }
    }

    Index body_;
    std::optional<Index> about_;
    std::shared_ptr<const FewBodyForceOptions> force_;
    bool attracted_;                             ///< towards a point, without a limit: encounters must be resolved
    bool alone_;                                 ///< nothing else attracts the two, or the body and the centre
    std::optional<ClosestApproach> encounters_;  ///< of all bodies, unless alone_
    TurningPoints points_;
    std::optional<OrbitalElements> first_;
    std::optional<OrbitalElements> last_;
};

struct OrbitOptions : FewBodyAnalysisOptions {
    Index body = 0;
    std::optional<Index> about = {};

    void describe(Description& description) override {
        description.required_integer("body", body).at_least(1).meaning("whose orbit, counted from 1");
        description.integer("about", about)
            .at_least(1)
            .optional("the origin")
            .meaning("the body that it goes round, counted from 1");
    }
    [[nodiscard]] Misfits check(const FewBodyTarget& target) const override {
        Misfits misfits;
        const auto beyond = [&](const char* key, Index number) {
            return fmt::format("'{}' in orbit is {}, but the last body is {}", key, number, target.bodies);
        };
        const FewBodyForceMethod& force = target.force.plugin;
        if (body > target.bodies) {
            misfits.emplace_back("body", beyond("body", body));
        } else if (force.has_polar_angle && body > 1) {
            misfits.emplace_back(
                "body",
                fmt::format("'body' in orbit is {}, but force '{}' has the angle of body 1 alone", body, force.name));
        }
        if (!about) {
            return misfits;
        }
        if (force.has_polar_angle) {
            misfits.emplace_back(
                "about",
                fmt::format("'about' in orbit has no meaning for force '{}', whose coordinate is a distance already",
                            force.name));
        } else if (*about > target.bodies) {
            misfits.emplace_back("about", beyond("about", *about));
        } else if (*about == body) {
            misfits.emplace_back("about", "'about' in orbit is the body itself");
        }
        return misfits;
    }
    [[nodiscard]] std::unique_ptr<FewBodyAnalysis> make(const FewBodyTarget& target) const override {
        return std::make_unique<Orbit>(body - 1, about ? std::optional(*about - 1) : std::nullopt, target);
    }
};

}  // namespace

/// Orbit of one body about another or about the origin: all apsides, the period and the apsidal precession from them,
/// and, if the force is an inverse-square attraction, the osculating elements at start and end.
FewBodyAnalysisMethod orbit() {
    return {.name = "orbit",
            .meaning = "apsides of one body's path, with period and precession, and its orbital elements: orbit.csv",
            .options = [] { return std::make_unique<OrbitOptions>(); }};
}

}  // namespace ljmd
