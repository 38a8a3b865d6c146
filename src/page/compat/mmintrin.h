// Eigen includes this with the vectors of SSE2, of which Emscripten has all but MMX, and uses nothing of it.
#pragma once
