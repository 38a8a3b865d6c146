#include "engine/few_body_system.hpp"
#include "fuzzed_decks.hpp"
#include "resumed_run.hpp"
#include "run/run.hpp"

using namespace ljmd;

// Of two bodies in the plane, or of one by its distance alone: the head's number of bodies tells.
LJMD_FUZZ_TARGET(checkpoint_few_body) {
    static const fuzz::RunFolder orbit(fuzz::orbit);
    static const fuzz::RunFolder radial(fuzz::radial);
    try {
        const fuzz::CheckpointContent content(std::as_bytes(std::span(data, size)));
        const fuzz::RunFolder& folder = content.head.atoms == 1 ? radial : orbit;
        RunControl control;
        control.continuation = fuzz::found_again(folder, content);
        FewBodySystem system = make_few_body_system(folder.deck().few_bodies());
        fuzz::Quiet listener;
        static_cast<void>(run_plan(folder.deck(), system, listener, control));
        ++fuzz::inputs_accepted;
    } catch (const CheckpointError&) {
    } catch (const PhysicsError&) {  // positions and velocities may be any
    }
    return 0;
}
