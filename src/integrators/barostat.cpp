#include "integrators/barostat.hpp"

#include "ljmd/options/choice.hpp"

namespace ljmd {

BarostatMethod find_barostat(const std::string& name) {
    return find_plugin(all_barostats(), name, "barostat");
}

ChosenBarostat chosen_barostat(const Choice& choice) {
    return chosen(all_barostats(), choice, "barostat");
}

}  // namespace ljmd
