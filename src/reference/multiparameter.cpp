#include "reference/multiparameter.hpp"

namespace ljmd {

Taylor residual_helmholtz(const MultiparameterForm& form, const Taylor& temperature, const Taylor& density) {
    const Taylor tau = form.reducing_temperature / temperature;
    const Taylor delta = density / form.reducing_density;
    Taylor sum;
    for (const auto& [n, t, d] : form.power) {
        sum += n * pow(tau, t) * pow(delta, d);
    }
    for (const auto& [n, t, d, l] : form.exponential) {
        sum += n * pow(tau, t) * pow(delta, d) * exp(-pow(delta, l));
    }
    for (const auto& [n, t, d, eta, beta, gamma, epsilon] : form.gaussian) {
        const Taylor from_density = delta - epsilon;
        const Taylor from_temperature = tau - gamma;
        sum += n * pow(tau, t) * pow(delta, d) *
               exp(-eta * from_density * from_density - beta * from_temperature * from_temperature);
    }
    return sum;
}

}  // namespace ljmd
