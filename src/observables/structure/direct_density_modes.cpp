#include <cmath>
#include <numbers>

#include "execution/loops.hpp"
#include "observables/structure/density_modes.hpp"

namespace ljmd {

namespace {

using Complex = std::complex<double>;

class DirectDensityModes : public DensityModes {
  public:
    DirectDensityModes(const Box& box, const Numbers& largest) : edges_(box.edges()), largest_(largest) {}

    void prepare(const State& state) override {
        const Index atoms = state.count();
        const auto r = state.positions();
        for (Index a = 0; a < 3; ++a) {
            Eigen::MatrixXcd& powers = powers_[static_cast<std::size_t>(a)];
            powers.resize(atoms, largest_[static_cast<std::size_t>(a)] + 1);
            for_each_index(state.execution(), atoms, [&](Index i) {
                const Complex once = std::polar(1.0, -2.0 * std::numbers::pi * r(a, i) / edges_[a]);
                Complex power = 1.0;
                for (Index n = 0; n < powers.cols(); ++n) {
                    powers(i, n) = power;
                    power *= once;
                }
            });
        }
    }

    void get(Index n_x, Index n_y, std::vector<Complex>& rod) const override {
        const Eigen::VectorXcd in_plane = power(0, n_x).cwiseProduct(power(1, n_y));
        for (std::size_t n_z = 0; n_z < rod.size(); ++n_z) {
            rod[n_z] = in_plane.cwiseProduct(powers_[2].col(static_cast<Index>(n_z))).sum();
        }
    }

  private:
    /// exp(-2 pi i n r_a/L_a) for all atoms.
    [[nodiscard]] Eigen::VectorXcd power(std::size_t a, Index n) const {
        const auto column = powers_[a].col(std::abs(n));
        return n < 0 ? Eigen::VectorXcd(column.conjugate()) : Eigen::VectorXcd(column);
    }

    Vec3 edges_;
    Numbers largest_;
    std::array<Eigen::MatrixXcd, 3> powers_;  ///< (atoms, n + 1) for each direction
};

}  // namespace

std::unique_ptr<DensityModes> direct_density_modes(const Box& box, const DensityModes::Numbers& largest) {
    return std::make_unique<DirectDensityModes>(box, largest);
}

}  // namespace ljmd
