// A measurement of one's own, with an error bar: the mean speed of the atoms, which Maxwell's distribution gives.
#include <ljmd/ljmd.hpp>

#include <cmath>
#include <iostream>
#include <numbers>

class MeanSpeed : public ljmd::Observer {
  public:
    [[nodiscard]] bool needs(ljmd::Index step) const override { return step % 10 == 0; }

    void sample(const ljmd::Snapshot& snapshot) override {
        const double speed = snapshot.velocities().colwise().norm().mean();
        series_.add(Eigen::VectorXd::Constant(1, speed));
    }

    // Optional: lets a simulation with this observer be continued from a checkpoint.
    void archive(ljmd::Archive& a) override { a(series_); }

    [[nodiscard]] ljmd::Estimate estimate() const { return series_.estimate(0); }

  private:
    ljmd::BlockingAccumulator series_{1, ljmd::Covariance::diagonal};  // errors of a correlated series
};

int main() {
    constexpr double temperature = 1.5;
    ljmd::FluidSpec gas{.start = ljmd::LatticeStart{.lattice = ljmd::Lattice::fcc, .cells = 4},
                        .density = 0.3,
                        .temperature = temperature};
    gas.stages = {{.name = "production",
                   .time_step = 0.004,
                   .steps = 5000,
                   .temperature = temperature,
                   .sample = true,
                   .thermostat = ljmd::thermostat("langevin", {{"time", 0.5}})}};
    ljmd::Simulation simulation(gas);
    MeanSpeed speed;
    simulation.add(speed);
    simulation.run();
    const ljmd::Estimate found = speed.estimate();
    std::cout << "mean speed = " << found.mean << " +- " << found.standard_error
              << ", Maxwell: " << std::sqrt(8.0 * temperature / std::numbers::pi) << '\n';
}
