// The page's transforms keep the promises of FFTW's.
#include "../observables/fourier_test.cpp"  // NOLINT(bugprone-suspicious-include)
