#include "deck/deck_execution.hpp"
#include "deck/fluid.hpp"
#include "fuzzed_decks.hpp"
#include "resumed_run.hpp"

using namespace ljmd;

LJMD_FUZZ_TARGET(checkpoint_fluid) {
    static const fuzz::RunFolder fluid(fuzz::fluid);
    static const fuzz::RunFolder constant_pressure(fuzz::constant_pressure);
    try {
        const fuzz::CheckpointContent content(std::as_bytes(std::span(data, size)));
        const fuzz::RunFolder& folder = content.head.atoms == 8 ? constant_pressure : fluid;
        RunControl control;
        control.continuation = fuzz::found_again(folder, content);
        const CheckpointHead& head = control.continuation->head;
        FluidSystem simulation = empty_fluid(fluid_spec(folder.deck()), head.atoms, Box(head.edges),
                                             Execution(execution_options(folder.deck())));
        fuzz::Quiet listener;
        static_cast<void>(run_plan(folder.deck(), simulation, listener, control));
        ++fuzz::inputs_accepted;
    } catch (const CheckpointError&) {
    } catch (const PhysicsError&) {  // positions and velocities may be any
    }
    return 0;
}
