#pragma once

#include <string>

#include "contact/base/error.h"

namespace tricontact::contact {

/// Runs; what stopped a computation that only stands beside another one, in words, or nothing.
/// Failures of the program (no memory, a file that is gone, a mistake in it) are no findings and
/// pass.
template <class Run>
std::string why_it_stopped(const Run& run) {
    try {
        run();
    } catch (const InputError& error) {
        return error.what();
    } catch (const NotConverged& error) {
        return error.what();
    } catch (const ContactAtEdge& error) {
        return error.what();
    }
    return {};
}

}  // namespace tricontact::contact
