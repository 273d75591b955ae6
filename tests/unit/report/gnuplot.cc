#include "report/gnuplot.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace tricontact::report::gnuplot_test {
namespace {

/// The message of the error that `script` causes.
std::string message_of(const std::string& script, const std::string& program = "gnuplot") {
    try {
        run_gnuplot(script, program);
    } catch (const GnuplotError& error) {
        return error.what();
    }
    return "no error";
}

TEST(Gnuplot, WritesWhatTheScriptPrints) {
    EXPECT_EQ(run_gnuplot("set print '-'\nprint 6*7\n"), "42\n");
}

TEST(Gnuplot, StopsAtTheFirstErrorAndSaysIt) {
    const std::string message = message_of("plot nonsense(x)\nset print '-'\nprint 1\n");
    EXPECT_NE(message.find("undefined function: nonsense"), std::string::npos) << message;
    EXPECT_NE(message.find("line 1"), std::string::npos) << message;
}

TEST(Gnuplot, MissingProgramNamesThePackage) {
    const std::string message = message_of("", "/nonexistent/gnuplot");
    EXPECT_NE(message.find("cannot start '/nonexistent/gnuplot'"), std::string::npos) << message;
    EXPECT_NE(message.find("gnuplot-nox"), std::string::npos) << message;
}

TEST(Gnuplot, AProgramThatReadsNothingIsAnErrorNotASignal) {
    // More than any pipe holds: writing to a dead reader must not end this program.
    const std::string message = message_of(std::string(1 << 21, '#'), "/bin/false");
    EXPECT_NE(message.find("/bin/false failed"), std::string::npos) << message;
}

TEST(Gnuplot, LongDataPassBothWays) {
    // 300 kB out while 600 kB still come in: with plain pipes both sides would wait for ever.
    std::string script = "set print '-'\n";
    for (int i = 0; i < 50000; ++i) script += "print 12345\n";
    EXPECT_EQ(run_gnuplot(script).size(), 50000u * 6);
}

TEST(Gnuplot, EnvironmentDoesNotChangeTheNumbers) {
    const std::string script = "set print '-'\nprint sprintf('%.2f %s', 0.5, GPVAL_TERM)\n";
    setenv("GNUTERM", "dumb", 1);
    setenv("LC_NUMERIC", "de_DE.UTF-8", 1);
    const std::string text = run_gnuplot(script);
    unsetenv("GNUTERM");
    unsetenv("LC_NUMERIC");
    EXPECT_TRUE(text.starts_with("0.50 ")) << text;
    EXPECT_EQ(text.find("dumb"), std::string::npos) << text;
}

std::string drawn(const Picture& picture, ImageFormat format) {
    return draw({sheet_for_pages(picture, format)}).front();
}

TEST(Gnuplot, DrawsBothFormats) {
    const Picture picture{320, 200, "plot x notitle"};
    const std::string svg = drawn(picture, ImageFormat::svg);
    EXPECT_TRUE(svg.starts_with("<?xml"));
    EXPECT_NE(svg.find("width=\"320\" height=\"200\""), std::string::npos);
    const std::string png = drawn(picture, ImageFormat::png);
    EXPECT_TRUE(png.starts_with("\x89PNG\r\n\x1a\n"));
    // IHDR: big-endian width and height, 1.5 times the CSS pixels.
    EXPECT_EQ(png.substr(16, 8), std::string("\0\0\x01\xe0\0\0\x01\x2c", 8));
}

TEST(Gnuplot, AScriptThatDrawsNothingIsAnError) {
    EXPECT_THROW(drawn({320, 200, "a = 1"}, ImageFormat::png), GnuplotError);
}

// One gnuplot draws several: what a picture sets, defines or switches to must not show in the next.
TEST(Gnuplot, SamePictureSameBytesWhateverWasDrawnBefore) {
    const Picture picture{320, 200, "plot sin(x) with linespoints"};
    const Picture other{400, 300,
                        "set multiplot\nset logscale x\nset title 'T'\nset key left\nf(x) = x\n"
                        "$d << EOD\n1 2\n3 4\nEOD\nset style data lines\nplot $d, f(x)\n"
                        "unset multiplot"};
    for (const ImageFormat format : {ImageFormat::svg, ImageFormat::png}) {
        std::vector<Sheet> sheets(9, sheet_for_pages(other, format));
        for (std::size_t k : {0, 3, 7, 8}) sheets[k] = sheet_for_pages(picture, format);
        const auto images = draw(sheets);
        for (std::size_t k : {0, 3, 7, 8}) EXPECT_EQ(images[k], drawn(picture, format)) << k;
        for (std::size_t k : {1, 2, 4, 5, 6}) EXPECT_EQ(images[k], drawn(other, format)) << k;
    }
}

TEST(Gnuplot, NothingToDrawIsNoError) {
    EXPECT_TRUE(draw({}).empty());
}

}  // namespace
}  // namespace tricontact::report::gnuplot_test
