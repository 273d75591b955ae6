#pragma once

#include <stdexcept>

namespace tricontact::contact {

/// Bad input: the text names place, value, rule and remedy. The program exits with code 2.
class InputError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// A solver that did not reach its tolerance; the text names residual, steps and zone sizes.
/// The program exits with code 1: no number of an unconverged solution is ever returned.
class NotConverged : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// The contact reached the edge of the points that the compliance knows.
class ContactAtEdge : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace tricontact::contact
