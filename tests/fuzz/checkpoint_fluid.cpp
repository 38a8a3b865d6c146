#include "fuzzed_decks.hpp"
#include "ljmd/app/simulation.hpp"
#include "resumed_run.hpp"

using namespace ljmd;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fuzz::RunFolder folder(fuzz::fluid);
    try {
        RunControl control;
        control.resumed = fuzz::found_again(folder, fuzz::CheckpointContent(std::as_bytes(std::span(data, size))));
        const CheckpointHead& head = control.resumed->point.head;
        Simulation simulation = empty_simulation(folder.deck(), head.atoms, Box(head.edges));
        fuzz::Quiet listener;
        static_cast<void>(run_deck(folder.deck(), simulation, listener, control));
        ++fuzz::inputs_accepted;
    } catch (const CheckpointError&) {
    } catch (const PhysicsError&) {  // positions and velocities may be any
    }
    return 0;
}
