// A gas in a field U_0 cos(2 pi x/L), with its energy beside an ideal gas's: -U_0 I_1(U_0/T)/I_0(U_0/T).
#include <ljmd/ljmd.hpp>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <numbers>

class Wave : public ljmd::ExternalForce {
  public:
    explicit Wave(double amplitude) : amplitude_(amplitude) {}

    [[nodiscard]] std::string name() const override { return "wave"; }

    ljmd::ExternalEnergy compute(const ljmd::AtomPositions& atoms, bool /*energy*/, Eigen::Matrix3Xd& forces) override {
        const double k = 2.0 * std::numbers::pi / atoms.edges()[0];
        const Eigen::ArrayXd phase = k * atoms.positions().row(0).transpose().array();
        forces.row(0) = (amplitude_ * k * phase.sin()).matrix().transpose();
        return {.energy = amplitude_ * phase.cos().sum()};
    }

  private:
    double amplitude_;
};

int main(int, char** arguments) {
    const ljmd::Index steps = arguments[1] != nullptr ? std::atol(arguments[1]) : 20000;
    constexpr double temperature = 1.5;
    constexpr double amplitude = 2.0;
    ljmd::FluidSpec gas{.start = ljmd::LatticeStart{.lattice = ljmd::Lattice::fcc, .cells = 5},
                        .density = 0.005,
                        .temperature = temperature,
                        .external = std::make_shared<Wave>(amplitude)};
    gas.stages = {{.name = "settle",
                   .time_step = 0.01,
                   .steps = steps / 4,
                   .temperature = temperature,
                   .thermostat = ljmd::thermostat("langevin", {{"time", 2.0}})}};
    gas.stages.push_back(gas.stages.front());
    gas.stages.back().name = "production";
    gas.stages.back().steps = steps;
    gas.stages.back().sample = true;
    const ljmd::RunResult result = ljmd::Simulation(gas).run();
    const ljmd::Estimate energy = result.observable("external_energy").estimate.value();
    const double b = amplitude / temperature;
    std::cout << "external energy = " << energy.mean << " +- " << energy.standard_error << " per atom, of an ideal gas "
              << -amplitude * std::cyl_bessel_i(1.0, b) / std::cyl_bessel_i(0.0, b) << '\n';
}
