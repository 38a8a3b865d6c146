#pragma once

/// What programs use whose runs are in memory: `#include <ljmd/engine.hpp>`, and link ljmd::engine.
#include "ljmd/core/build_info.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/engine/choices.hpp"
#include "ljmd/engine/configuration_evaluator.hpp"
#include "ljmd/engine/few_body_simulation.hpp"
#include "ljmd/engine/observer.hpp"
#include "ljmd/engine/simulation.hpp"
#include "ljmd/execution/execution.hpp"
#include "ljmd/forces/external_force.hpp"
#include "ljmd/observables/statistics/blocking.hpp"
#include "ljmd/potentials/second_virial.hpp"
#include "ljmd/reference/fluid_phase.hpp"
#include "ljmd/reference/pressure_states.hpp"
