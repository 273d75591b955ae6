#include "io/results/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ostream>
#include <string_view>

namespace tricontact::io {

namespace {

constexpr double redraw_interval = 0.1;  // s; faster is only flicker
constexpr int bar_width = 30;

// "0:07", "12:34", "3:05:00"
std::string clock_text(double seconds) {
    const auto total = static_cast<long>(std::min(std::ceil(seconds), 1e9));
    if (total < 3600) return fmt::format("{}:{:02}", total / 60, total % 60);
    return fmt::format("{}:{:02}:{:02}", total / 3600, total / 60 % 60, total % 60);
}

// The steps still to come take as long as those done.
std::string remaining(double fraction, double elapsed) {
    if (!(fraction > 0)) return {};
    return ", " + clock_text(elapsed * (1 - fraction) / fraction) + " left";
}

}  // namespace

ProgressBar::Style ProgressBar::style_of_stderr(bool quiet) {
    if (quiet) return Style::silent;
    const char* terminal = std::getenv("TERM");
    const bool dumb = !terminal || std::string_view(terminal) == "dumb";
    return ::isatty(STDERR_FILENO) && !dumb ? Style::bar : Style::lines;
}

ProgressBar::ProgressBar(std::ostream& out, Style style, std::string label, Clock clock,
                         std::string noun)
    : out_(out),
      style_(style),
      label_(std::move(label)),
      noun_(std::move(noun)),
      clock_(clock ? std::move(clock)
                   : Clock([] { return std::chrono::steady_clock::now().time_since_epoch(); })),
      start_(clock_()) {}

void ProgressBar::update(int done, int total) {
    done_ = done;
    if (watch_) watch_(done, total);
    if (style_ == Style::silent || total <= 0) return;
    const auto now = clock_();
    const double fraction = std::clamp(static_cast<double>(done) / total, 0., 1.);
    const double elapsed = (now - start_).count();
    if (style_ == Style::lines) {
        const int tenths = static_cast<int>(10 * fraction);
        if (tenths <= tenths_) return;
        tenths_ = tenths;
        out_ << fmt::format("{}: {} %, {} {} of at most {}{}", label_, 10 * tenths, noun_, done_,
                            total, remaining(fraction, elapsed))
             << std::endl;
    } else if (drawn_.count() < 0 || (now - drawn_).count() >= redraw_interval || done >= total) {
        drawn_ = now;
        const auto filled = static_cast<std::size_t>(bar_width * fraction);
        // Carriage return: same line again; ESC [K erases what an older, longer line left.
        out_ << fmt::format("\r{} [{:.<{}}] {} % {} {}/{}{}\x1b[K", label_,
                            std::string(filled, '#'), bar_width, static_cast<int>(100 * fraction),
                            noun_, done_, total, remaining(fraction, elapsed))
             << std::flush;
    }
}

void ProgressBar::finish(const std::string& remark) {
    if (style_ == Style::silent) return;
    if (style_ == Style::bar) out_ << "\r\x1b[K";
    out_ << fmt::format("{}: {} {}s in {:.2f} s{}{}", label_, done_, noun_,
                        (clock_() - start_).count(), remark.empty() ? "" : ", ", remark)
         << std::endl;
}

}  // namespace tricontact::io
