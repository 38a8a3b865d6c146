// The main function of every test in C++. Version 3 of Catch2 has it in a library of its own (Catch2WithMain).
#if !__has_include(<catch2/catch_test_macros.hpp>)
#define CATCH_CONFIG_MAIN
#include <catch2/catch.hpp>
#endif
