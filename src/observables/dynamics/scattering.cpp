#include "observables/dynamics/scattering.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "execution/loops.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/core/archived_count.hpp"
#include "ljmd/detail/core/elementary.hpp"
#include "observables/transport/centre_frame.hpp"
#include "observables/transport/time_origins.hpp"

namespace ljmd {

namespace {

std::vector<WaveVector> joined(const std::vector<WaveShell>& shells) {
    std::vector<WaveVector> all;
    for (const WaveShell& shell : shells) {
        all.insert(all.end(), shell.vectors.begin(), shell.vectors.end());
    }
    return all;
}

Index width_of(const std::vector<WaveShell>& shells, Index times) {
    return static_cast<Index>(shells.size()) * times;
}

/// Windows for each shell. @param of_vector  real series of a wave vector
std::vector<CorrelationWindows> windows(const std::vector<WaveShell>& shells, Index of_vector, Index lags,
                                        Index window) {
    std::vector<CorrelationWindows> all;
    all.reserve(shells.size());
    for (const WaveShell& shell : shells) {
        all.emplace_back(of_vector * static_cast<Index>(shell.vectors.size()), lags, window);
    }
    return all;
}

/// Two unit vectors that are orthogonal to k and to each other.
std::pair<Vec3, Vec3> transverse_directions(const Vec3& k) {
    Index least = 0;
    for (Index axis = 1; axis < 3; ++axis) {
        if (std::abs(k[axis]) < std::abs(k[least])) {
            least = axis;
        }
    }
    const Vec3 first = k.cross(Vec3::Unit(least)).normalized();
    return {first, k.cross(first).normalized()};
}

}  // namespace

Scattering::Scattering(Index atoms, double density, std::vector<WaveShell> shells, const LagTimes& lags, Index window,
                       Index origins)
    : atoms_(atoms),
      density_(density),
      shells_(std::move(shells)),
      vectors_(joined(shells_)),
      lags_(lags),
      every_(lags.every),
      frames_between_origins_(frames_between_origins(lags, origins)),
      cosines_(lags.count + 1),
      densities_(windows(shells_, 2, lags.count, window)),
      longitudinal_(windows(shells_, 2, lags.count, window)),
      transverse_(windows(shells_, 4, lags.count, window)),
      means_(functions * width_of(shells_, lags.count + 1), Covariance::diagonal),
      self_(width_of(shells_, lags.count + 1), Covariance::diagonal),
      collective_(width_of(shells_, collective_width(lags))),
      halves_(width_of(shells_, 2)) {}

Scattering::Phases Scattering::phases_of(const Eigen::Matrix3Xd& positions, const Vec3& edges,
                                         const Execution& execution) const {
    std::array<Eigen::MatrixXd, 3> powers;  // columns 2 n and 2 n + 1: real and imaginary part of the n-th power
    for (std::size_t axis = 0; axis < 3; ++axis) {
        Index most = 0;
        for (const WaveVector& vector : vectors_) {
            most = std::max(most, std::abs(vector.numbers[axis]));
        }
        powers[axis].resize(atoms_, 2 * (most + 1));
    }
    for_each_index(execution, Index{3}, [&](Index axis) {
        Eigen::MatrixXd& of_axis = powers[static_cast<std::size_t>(axis)];
        of_axis.col(0).setOnes();
        of_axis.col(1).setZero();
        for (Index i = 0; of_axis.cols() > 2 && i < atoms_; ++i) {
            const SineAndCosine once = of_turns(positions(axis, i) / edges[axis]);
            of_axis(i, 2) = once.cosine;
            of_axis(i, 3) = -once.sine;
        }
        for (Index n = 2; 2 * n < of_axis.cols(); ++n) {
            const auto re = of_axis.col(2 * n - 2).array();
            const auto im = of_axis.col(2 * n - 1).array();
            of_axis.col(2 * n) = re * of_axis.col(2).array() - im * of_axis.col(3).array();
            of_axis.col(2 * n + 1) = re * of_axis.col(3).array() + im * of_axis.col(2).array();
        }
    });
    Phases phases(atoms_, 2 * static_cast<Index>(vectors_.size()));
    for_each_index(execution, static_cast<Index>(vectors_.size()), [&](Index v) {
        auto re = phases.col(2 * v).array();
        auto im = phases.col(2 * v + 1).array();
        re.setOnes();
        im.setZero();
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Index n = vectors_[static_cast<std::size_t>(v)].numbers[axis];
            const auto c = powers[axis].col(2 * std::abs(n)).array();
            const auto s = powers[axis].col(2 * std::abs(n) + 1).array();
            const double sign = n < 0 ? -1.0 : 1.0;
            const Eigen::ArrayXd before = re;
            re = before * c - sign * im * s;
            im = sign * before * s + im * c;
        }
    });
    return phases;
}

void Scattering::sample(const State& state, const Evaluation& /*evaluation*/) {
    ++samples_;
    const Execution& execution = state.execution();
    Phases phases = phases_of(positions_about_centre(state), state.box().edges(), execution);
    add_modes(phases, velocities_about_centre(state), execution);
    add_self(std::move(phases), execution);
    ++frames_;
}

void Scattering::add_modes(const Phases& phases, const Eigen::Matrix3Xd& velocities, const Execution& execution) {
    // Of each vector the real and the imaginary part of rho, of j along k, and of j along two directions across k.
    Eigen::MatrixXd modes(8, static_cast<Index>(vectors_.size()));
    const Eigen::MatrixX3d by_axis = velocities.transpose();
    for_each_index(execution, modes.cols(), [&](Index v) {
        const WaveVector& vector = vectors_[static_cast<std::size_t>(v)];
        const auto [first, second] = transverse_directions(vector.k);
        for (Index part = 0; part < 2; ++part) {
            const auto phase = phases.col(2 * v + part);
            const Vec3 current(phase.dot(by_axis.col(0)), phase.dot(by_axis.col(1)), phase.dot(by_axis.col(2)));
            modes(part, v) = phase.sum();
            modes(2 + part, v) = current.dot(vector.k);  // times k: the factor k^2 of C_L is in it
            modes(4 + part, v) = vector.length * current.dot(first);
            modes(6 + part, v) = vector.length * current.dot(second);
        }
    });
    const Index times = lags_.count + 1;
    Eigen::VectorXd found(means_.width());
    bool is_complete = false;
    Index begin = 0;
    for (std::size_t shell = 0; shell < shells_.size(); ++shell) {
        const auto count = static_cast<Index>(shells_[shell].vectors.size());
        const auto add = [&](CorrelationWindows& window, Index row, Index rows) {
            return window.add(Eigen::VectorXd(modes.block(row, begin, rows, count).reshaped()), execution);
        };
        const auto density = add(densities_[shell], 0, 2);
        const auto longitudinal = add(longitudinal_[shell], 2, 2);
        const auto transverse = add(transverse_[shell], 4, 4);
        begin += count;
        if (!density) {
            continue;
        }
        is_complete = true;
        const double to_mean = 1.0 / (static_cast<double>(count) * static_cast<double>(atoms_));
        const Eigen::VectorXd f = to_mean * *density;
        found.segment(functions * static_cast<Index>(shell) * times, functions * times) << f, to_mean * *longitudinal,
            0.5 * to_mean * *transverse, smoothed_spectrum(f);
    }
    if (is_complete) {
        means_.add(found);
        add_to_modes(found);
    }
}

/// S(k, w) at w = pi n/t_max.
Eigen::VectorXd Scattering::smoothed_spectrum(const Eigen::VectorXd& correlation) const {
    AlignedVector<double> windowed(static_cast<std::size_t>(correlation.size()));
    for (Index lag = 0; lag < correlation.size(); ++lag) {
        const double w = std::cos(0.5 * std::numbers::pi * static_cast<double>(lag) / static_cast<double>(lags_.count));
        windowed[static_cast<std::size_t>(lag)] = correlation[lag] * w * w;
    }
    AlignedVector<double> transformed(windowed.size());
    cosines_(windowed, transformed);
    return lags_.spacing / (2.0 * std::numbers::pi) *
           Eigen::Map<const Eigen::VectorXd>(transformed.data(), correlation.size());
}

void Scattering::add_self(Phases phases, const Execution& execution) {
    if (frames_ % frames_between_origins_ == 0) {
        origins_.push_back({phases, Eigen::MatrixXd(static_cast<Index>(shells_.size()), 0)});
    }
    Eigen::VectorXd of_vectors(static_cast<Index>(vectors_.size()));
    for (Origin& origin : origins_) {
        for_each_index(execution, of_vectors.size(), [&](Index v) {
            of_vectors[v] = phases.col(2 * v).dot(origin.phases.col(2 * v)) +
                            phases.col(2 * v + 1).dot(origin.phases.col(2 * v + 1));
        });
        const Index passed = origin.found.cols();
        origin.found.conservativeResize(Eigen::NoChange, passed + 1);
        Index begin = 0;
        for (std::size_t shell = 0; shell < shells_.size(); ++shell) {
            const auto count = static_cast<Index>(shells_[shell].vectors.size());
            double sum = 0.0;
            for (Index v = begin; v < begin + count; ++v) {
                sum += of_vectors[v];
            }
            origin.found(static_cast<Index>(shell), passed) =
                sum / (static_cast<double>(count) * static_cast<double>(atoms_));
            begin += count;
        }
    }
    if (origins_.front().found.cols() <= lags_.count) {
        return;
    }
    const Eigen::MatrixXd& whole = origins_.front().found;
    self_.add(Eigen::VectorXd(whole.transpose().reshaped()));
    Eigen::MatrixXd halves(2, whole.rows());
    halves << whole.col(lags_.count / 2).transpose(), whole.col(lags_.count).transpose();
    halves_.add(Eigen::VectorXd(halves.reshaped()));
    origins_.erase(origins_.begin());
}

void Scattering::interrupt() {
    for (auto* all : {&densities_, &longitudinal_, &transverse_}) {
        for (CorrelationWindows& window : *all) {
            window.interrupt();
        }
    }
    origins_.clear();
    frames_ = 0;
}

std::vector<DataTable> Scattering::tables() const {
    std::vector<DataTable> all;
    const Index times = lags_.count + 1;
    DataTable self{"fskt", {"k", "time", "F_s", "F_s_standard_error"}, {}};
    DataTable whole{
        "fkt", {"k", "time", "F", "F_standard_error", "C_L", "C_L_standard_error", "C_T", "C_T_standard_error"}, {}};
    DataTable spectrum{"skw", {"k", "angular_frequency", "S_kw", "S_kw_standard_error"}, {}};
    for (std::size_t shell = 0; shell < shells_.size(); ++shell) {
        const double k = shells_[shell].k;
        for (Index lag = 0; lag < times; ++lag) {
            const Index place = static_cast<Index>(shell) * times;
            const auto of = [&](Index function) { return means_.estimate(functions * place + function * times + lag); };
            if (self_.samples() > 0) {
                const Estimate f_s = self_.estimate(place + lag);
                self.rows.push_back({k, lags_.time(lag), f_s.mean, f_s.standard_error});
            }
            if (means_.samples() > 0) {
                const Estimate f = of(0);
                const Estimate c_l = of(1);
                const Estimate c_t = of(2);
                const Estimate s = of(3);
                whole.rows.push_back({k, lags_.time(lag), f.mean, f.standard_error, c_l.mean, c_l.standard_error,
                                      c_t.mean, c_t.standard_error});
                spectrum.rows.push_back({k, std::numbers::pi * static_cast<double>(lag) / lags_.time(lags_.count),
                                         s.mean, s.standard_error});
            }
        }
    }
    if (!whole.rows.empty()) {
        all.push_back(std::move(whole));
    }
    if (!self.rows.empty()) {
        all.push_back(std::move(self));
    }
    if (!spectrum.rows.empty()) {
        all.push_back(std::move(spectrum));
    }
    if (auto table = modes()) {
        all.push_back(std::move(*table));
    }
    return all;
}

void Scattering::archive(Archive& a) {
    a(samples_, frames_);
    for (auto* all : {&densities_, &longitudinal_, &transverse_}) {
        for (CorrelationWindows& window : *all) {
            window.archive(a);
        }
    }
    a(origins_, means_, self_, collective_, halves_);
    require_count(samples_);
    require_count(frames_);
    require_origins(
        origins_, frames_, frames_between_origins_, lags_.count,
        [&](const Origin& origin, Index age) {
            return origin.phases.rows() == atoms_ && origin.phases.cols() == 2 * static_cast<Index>(vectors_.size()) &&
                   origin.found.rows() == static_cast<Index>(shells_.size()) && origin.found.cols() == age;
        },
        "this scattering");
}

}  // namespace ljmd
