#include "contact/base/stopped.h"

#include <gtest/gtest.h>

#include <new>
#include <stdexcept>

namespace tricontact::contact::stopped_test {
namespace {

TEST(Stopped, FindingsAreWords) {
    EXPECT_EQ(why_it_stopped([] {}), "");
    EXPECT_EQ(why_it_stopped([] { throw InputError("out of range"); }), "out of range");
    EXPECT_EQ(why_it_stopped([] { throw NotConverged("no end"); }), "no end");
    EXPECT_EQ(why_it_stopped([] { throw ContactAtEdge("edge"); }), "edge");
}

TEST(Stopped, FailuresOfTheProgramPass) {
    EXPECT_THROW(why_it_stopped([] { throw std::runtime_error("a file is gone"); }),
                 std::runtime_error);
    EXPECT_THROW(why_it_stopped([] { throw std::domain_error("a mistake"); }), std::domain_error);
    EXPECT_THROW(why_it_stopped([] { throw std::bad_alloc(); }), std::bad_alloc);
}

}  // namespace
}  // namespace tricontact::contact::stopped_test
