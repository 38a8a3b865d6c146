#pragma once

namespace ljmd {

/// Threads of a step wait for each other a few times in some ten microseconds. Left alone, the OpenMP runtime soon puts
/// a waiting thread to sleep, and waking it takes as long as a step of a thousand atoms; told to wait actively it does
/// not. It takes this from its environment, which it reads once, before main(): so the program starts itself again with
/// OMP_WAIT_POLICY=active, unless the user has said what to do.
///
/// Returns when there is nothing to do or it cannot be done: threads then work all the same.
/// @param argv  as main() got it
void wait_actively(int threads, char** argv);

}  // namespace ljmd
