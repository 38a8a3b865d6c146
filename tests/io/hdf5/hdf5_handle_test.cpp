#include "io/hdf5/hdf5_handle.hpp"

#include "catch.hpp"

using namespace ljmd;

namespace {

int closed = 0;

herr_t count(hid_t id) {
    ++closed;
    return id == 13 ? -1 : 0;
}

}  // namespace

TEST_CASE("an HDF5 identifier is closed once, by whoever holds it last") {
    closed = 0;
    {
        Hdf5Handle first(7, count);
        CHECK(static_cast<bool>(first));
        CHECK(first.get() == 7);
        Hdf5Handle second(std::move(first));
        CHECK(second.get() == 7);
        Hdf5Handle third;
        CHECK_FALSE(static_cast<bool>(third));
        third = std::move(second);
        CHECK(third.get() == 7);
        CHECK(closed == 0);
    }
    CHECK(closed == 1);
}

TEST_CASE("what is assigned to closes what it held") {
    closed = 0;
    {
        Hdf5Handle held(1, count);
        held = Hdf5Handle(2, count);
        CHECK(closed == 1);
        CHECK(held.get() == 2);
    }
    CHECK(closed == 2);
}

TEST_CASE("a handle that is closed early tells how that went, and is empty after it") {
    closed = 0;
    Hdf5Handle good(1, count);
    CHECK(good.close() == 0);
    CHECK(good.close() == 0);
    CHECK_FALSE(static_cast<bool>(good));
    CHECK(closed == 1);
    Hdf5Handle bad(13, count);
    CHECK(bad.close() < 0);
    CHECK_FALSE(static_cast<bool>(bad));
}

TEST_CASE("the result of a failed call is not closed, nor what was abandoned") {
    closed = 0;
    {
        const Hdf5Handle failed(-1, count);
        CHECK_FALSE(static_cast<bool>(failed));
        Hdf5Handle lost(5, count);
        lost.abandon();
        CHECK(lost.close() == 0);
    }
    CHECK(closed == 0);
}

TEST_CASE("the cause of a failure is that of the system where there is one") {
    const Hdf5Silence silence;
    REQUIRE(H5Fopen("/nowhere/at/all.h5md", H5F_ACC_RDONLY, H5P_DEFAULT) < 0);
    CHECK(hdf5_error_text() == "No such file or directory");
    REQUIRE(H5Gopen2(-1, "group", H5P_DEFAULT) < 0);
    CHECK_FALSE(hdf5_error_text().empty());
    CHECK(hdf5_error_text() != "No such file or directory");
    H5Eclear2(H5E_DEFAULT);
    CHECK(hdf5_error_text() == "unknown HDF5 error");
}
