#include "io/files/checkpoint_file.hpp"
#include "fuzz_target.hpp"

using namespace ljmd;

// The file as it lies on the disk: nothing is thrown, whatever it holds.
LJMD_FUZZ_TARGET(checkpoint_file) {
    static const test::WrittenFile file("", "checkpoint.1");
    file.rewrite(fuzz::text_of(data, size));
    const FoundCheckpoints found = find_checkpoints(file.directory());
    fuzz::require(found.whole.size() + found.damaged.size() == 1, "a file is neither whole nor damaged, or both");
    fuzz::inputs_accepted += found.damaged.empty() ? 1 : 0;
    return 0;
}
