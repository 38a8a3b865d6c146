#include "observables/interface/film.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "observables/interface/pressure_profile.hpp"
#include "observables/statistics/known_quantities.hpp"

namespace ljmd {

namespace {

constexpr double thinnest = 2.0;           // [sigma], of half the liquid and of the vapour
constexpr double smallest_contrast = 0.5;  // of the density of the liquid

constexpr const char* no_tail =
    "the tail correction is that of a homogeneous fluid: use a shifted potential, or tail = false";
constexpr const char* no_film = "no layer of liquid and layer of vapour can be told apart";
/// They depend on how many atoms are in the liquid.
constexpr std::array<std::string_view, 4> follow_exchange{"potential_energy", "total_energy", "heat_capacity_cv",
                                                          "liquid_density"};

constexpr const char* one_atom = "a single atom has no pressure";

}  // namespace

Film::Film(const Interaction& interaction, const Box& box, Index axis, Index layers, Every every)
    : potential_(interaction.potential),
      has_tail_(interaction.tail.energy(1.0) != 0.0),
      edge_(box.edges()[axis]),
      axis_(axis),
      layers_(layers),
      every_(every),
      means_(3 * layers + 2, Covariance::diagonal),
      densities_(layers / 2, Covariance::full) {}

double Film::bytes(Index layers, Index samples) {
    return BlockingAccumulator::bytes(3 * layers + 2, Covariance::diagonal, samples) +
           BlockingAccumulator::bytes(layers / 2, Covariance::full, samples);
}

void Film::sample(const State& state, const Evaluation& evaluation) {
    ++samples_;
    if (state.count() < 2) {
        return;
    }
    const PressureProfile profile = pressure_profile(state, potential_, axis_, film_centre(state, axis_), layers_);
    const double normal = evaluation.virial(axis_, axis_);
    const double tangential = 0.5 * (evaluation.virial.trace() - normal);
    Eigen::VectorXd found(means_.width());
    found << profile.density, profile.normal, profile.tangential,
        0.5 * edge_ * (normal - tangential) / state.box().volume(), profile.normal.mean();
    means_.add(found);
    const Index half = layers_ / 2;
    densities_.add(0.5 * (profile.density.tail(half) + profile.density.head(half).reverse()));
}

Estimate Film::mean_density(Index first, Index last) const {
    Eigen::VectorXd weights = Eigen::VectorXd::Zero(densities_.width());
    weights.segment(first, last - first).setConstant(1.0 / static_cast<double>(last - first));
    return densities_.estimate(weights.dot(densities_.mean()), weights);
}

std::optional<double> Film::surface() const {
    const Eigen::VectorXd density = densities_.mean();
    const Index half = density.size();
    const auto enough = static_cast<Index>(std::ceil(thinnest / thickness()));
    if (half < 2 * enough) {
        return std::nullopt;
    }
    const double middle = density.head(enough).mean();
    const double end = density.tail(enough).mean();
    if (!(middle - end > smallest_contrast * middle)) {
        return std::nullopt;
    }
    const double level = 0.5 * (middle + end);
    Index outside = 1;
    while (outside < half && density[outside] > level) {
        ++outside;
    }
    // The layer in the middle may be thin by chance, where few samples are no film.
    if (outside == half || !(density[outside - 1] > level)) {
        return std::nullopt;
    }
    const double above = density[outside - 1];
    const double below = density[outside];
    return static_cast<double>(outside) - 0.5 + (above - level) / (above - below);
}

std::vector<DataTable> Film::tables() const {
    if (means_.samples() == 0) {
        return {};
    }
    DataTable table{"film",
                    {"z", "density", "density_standard_error", "normal_pressure", "normal_pressure_standard_error",
                     "tangential_pressure", "tangential_pressure_standard_error"},
                    {}};
    const Index half = layers_ / 2;
    for (Index k = 0; k < layers_; ++k) {
        std::vector<double> row{thickness() * (static_cast<double>(k - half) + 0.5)};
        for (const Index column : {k, layers_ + k, 2 * layers_ + k}) {
            const Estimate found = means_.estimate(column);
            row.push_back(found.mean);
            row.push_back(found.standard_error);
        }
        table.rows.push_back(std::move(row));
    }
    return {table};
}

std::vector<ObservableAverage> Film::observables() const {
    if (samples_ == 0) {
        return {};
    }
    ObservableAverage tension = average_of("surface_tension");
    ObservableAverage pressure = average_of("normal_pressure");
    ObservableAverage liquid = average_of("liquid_density", std::nullopt, no_film);
    ObservableAverage vapour = average_of("vapour_density", std::nullopt, no_film);
    if (means_.samples() == 0) {
        for (ObservableAverage* each : {&tension, &pressure, &liquid, &vapour}) {
            each->remark = one_atom;
        }
        return {tension, pressure, liquid, vapour};
    }
    if (const std::optional<double> at = surface()) {
        const auto half = static_cast<double>(densities_.width());
        const auto inner = static_cast<Index>(std::floor(0.5 * *at));
        const auto outer = static_cast<Index>(std::ceil(0.5 * (*at + half)));
        const auto is_thick = [&](double layers) { return layers * thickness() >= thinnest; };
        if (is_thick(*at) && inner > 0) {
            liquid.estimate = mean_density(0, inner);
            liquid.remark.clear();
        }
        if (is_thick(half - *at) && outer < densities_.width()) {
            vapour.estimate = mean_density(outer, densities_.width());
            vapour.remark.clear();
        }
    }
    if (has_tail_ || !liquid.estimate || !vapour.estimate) {
        tension.remark = has_tail_ ? no_tail : no_film;
        pressure.remark = tension.remark;
    } else {
        tension.estimate = means_.estimate(3 * layers_);
        pressure.estimate = means_.estimate(3 * layers_ + 1);
    }
    return {tension, pressure, liquid, vapour};
}

void mark_slow_exchange(std::vector<ObservableAverage>& averages) {
    const auto vapour = std::ranges::find(averages, "vapour_density", &ObservableAverage::name);
    if (vapour == averages.end() || !vapour->estimate || vapour->estimate->converged) {
        return;
    }
    for (ObservableAverage& average : averages) {
        if (average.estimate && std::ranges::find(follow_exchange, average.name) != follow_exchange.end()) {
            average.estimate->converged = false;
        }
    }
}

}  // namespace ljmd
