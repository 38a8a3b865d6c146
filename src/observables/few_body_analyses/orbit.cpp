#include <fmt/format.h>

#include "ljmd/observables/few_body/few_body_analysis.hpp"
#include "ljmd/observables/few_body/orbital_elements.hpp"
#include "ljmd/observables/few_body/turning_points.hpp"

namespace ljmd {

namespace {

class Orbit : public FewBodyAnalysis {
  public:
    Orbit(Index body, std::optional<Index> about, std::shared_ptr<const FewBodyForceOptions> force)
        : body_(body), about_(about), force_(std::move(force)) {}

    void sample(const FewBodySample& now) override {
        const State& state = now.state;
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
        // Bodies at one place, or out of the range of numbers, have no ellipse. Their next force ends the run.
        if (mu && *mu > 0.0 && r.norm() > 0.0) {
            last_ = orbital_elements(r, v, *mu);
            first_ = first_ ? first_ : last_;
        }
    }

    [[nodiscard]] std::vector<Finding> findings() const override {
        std::vector<Finding> found;
        const auto add_mean = [&](const char* name, const std::optional<IntervalMean>& mean) {
            if (mean) {
                found.push_back({name, mean->mean, mean->standard_error});
            }
        };
        add_mean("period", points_.period());
        add_mean("precession", points_.precession());
        for (const Apsis kind : {Apsis::pericentre, Apsis::apocentre}) {
            for (const Passage& passage : points_.passages()) {
                if (passage.kind == kind) {
                    found.push_back({kind == Apsis::pericentre ? "first_pericentre" : "first_apocentre",
                                     passage.distance, std::nullopt});
                    break;
                }
            }
        }
        add_elements(found, "_at_start", first_);
        add_elements(found, "_at_end", last_);
        return found;
    }

    [[nodiscard]] std::optional<DataTable> table() const override {
        DataTable table{"orbit", {"apocentre", "time", "distance", "angle"}, {}};
        for (const Passage& passage : points_.passages()) {
            table.rows.push_back(
                {passage.kind == Apsis::apocentre ? 1.0 : 0.0, passage.time, passage.distance, passage.angle});
        }
        return table;
    }

    void archive(Archive& a, const State& now) override {
        points_.archive(a, now.time);
        a(first_, last_);
    }

  private:
    static void add_elements(std::vector<Finding>& found, const std::string& when,
                             const std::optional<OrbitalElements>& elements) {
        if (elements) {
            found.push_back({"specific_energy" + when, elements->specific_energy, std::nullopt});
            found.push_back({"specific_angular_momentum" + when, elements->angular_momentum.norm(), std::nullopt});
            found.push_back({"semi_major_axis" + when, elements->semi_major_axis, std::nullopt});
            found.push_back({"eccentricity" + when, elements->eccentricity, std::nullopt});
            found.push_back({"kepler_period" + when, elements->period, std::nullopt});
            found.push_back({"argument_of_pericentre" + when, elements->argument_of_pericentre, std::nullopt});
        }
    }

    Index body_;
    std::optional<Index> about_;
    std::shared_ptr<const FewBodyForceOptions> force_;
    TurningPoints points_;
    std::optional<OrbitalElements> first_;
    std::optional<OrbitalElements> last_;
};

struct Options : FewBodyAnalysisOptions {
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
        return std::make_unique<Orbit>(body - 1, about ? std::optional(*about - 1) : std::nullopt,
                                       target.force.options);
    }
};

}  // namespace

/// Orbit of one body about another or about the origin: all apsides, the period and the apsidal precession from them,
/// and, if the force is an inverse-square attraction, the osculating elements at start and end.
FewBodyAnalysisMethod orbit() {
    return {.name = "orbit",
            .meaning = "apsides of one body's path, with period and precession, and its orbital elements: orbit.csv",
            .options = [] { return std::make_unique<Options>(); }};
}

}  // namespace ljmd
