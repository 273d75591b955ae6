#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace tricontact::report {

/// gnuplot is missing or refused a script; the text ends with gnuplot's own message.
class GnuplotError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};
/// It cannot be started; the text names the package.
class GnuplotMissing : public GnuplotError {
  public:
    using GnuplotError::GnuplotError;
};

enum class ImageFormat { svg, png };

/// A picture before it is drawn: what stands in the script between terminal and end.
struct Picture {
    int width = 640, height = 420;  ///< [CSS pixels]; PNG files have 1.5 times as many
    std::string script;             ///< gnuplot commands with inline data, no `set terminal`
};

/// What `program` writes to its standard output when it reads `script` from its standard input.
/// Runs in the C locale without gnuplot's start-up files: same script, same bytes.
/// Throws GnuplotError.
std::string run_gnuplot(const std::string& script, const std::string& program = "gnuplot");

/// Throws GnuplotMissing if it is not there, before anything that needs pictures is computed.
void require_gnuplot();

/// A picture and the terminal that draws it, "svg size 640,420".
struct Sheet {
    std::string terminal;
    Picture picture;
};

/// The same for a page.
Sheet sheet_for_pages(Picture picture, ImageFormat format);

/// Draws all of them, side by side, in the order given; none of them shows in another.
/// Throws GnuplotError.
std::vector<std::string> draw(const std::vector<Sheet>& sheets);

}  // namespace tricontact::report
