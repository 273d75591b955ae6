#pragma once

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace tricontact::report {

/// A program cannot be started, or ended with an error; the text ends with the program's own
/// message.
class ProgramError : public std::runtime_error {
  public:
    ProgramError(const std::string& what, bool is_missing)
        : std::runtime_error(what), is_missing_(is_missing) {}
    bool is_missing() const { return is_missing_; }  ///< it could not be started

  private:
    bool is_missing_;
};

/// What the program `words[0]`, looked for in PATH, writes to its standard output when it reads
/// `input` from its standard input, a regular file. Runs in the C locale without gnuplot's start-up
/// files. Throws ProgramError.
std::string run_program(const std::vector<std::string>& words, std::string_view input);

/// The same for a program that writes `n` files instead: what they hold, in their order.
/// `input_for` gets their paths.
std::vector<std::string> run_program(
    const std::vector<std::string>& words, std::size_t n,
    const std::function<std::string(const std::vector<std::string>& paths)>& input_for);

}  // namespace tricontact::report
