#pragma once

#include <stdexcept>
#include <string>

namespace tricontact::report {

/// gnuplot is missing or refused a script; the text ends with gnuplot's own message.
class GnuplotError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

enum class ImageFormat { svg, png };

/// A picture before it is drawn: what stands in the script between terminal and end.
struct Picture {
    int width = 640, height = 420;  ///< [CSS pixels]; PNG files have twice as many
    std::string script;             ///< gnuplot commands with inline data, no `set terminal`
};

/// What `program` writes to its standard output when it reads `script` from its standard input.
/// Runs in the C locale without gnuplot's start-up files: same script, same bytes.
/// Throws GnuplotError.
std::string run_gnuplot(const std::string& script, const std::string& program = "gnuplot");

/// Draws the picture on a terminal, "svg size 640,420". Throws GnuplotError.
std::string draw_on(const std::string& terminal, const Picture& picture);
/// The same for a page.
std::string draw(const Picture& picture, ImageFormat format);

}  // namespace tricontact::report
