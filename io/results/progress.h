#pragma once

#include <chrono>
#include <functional>
#include <iosfwd>
#include <string>
#include <utility>

namespace tricontact::io {

/// How far a run is: a bar with the remaining time on a terminal, a line each ten per cent
/// elsewhere, nothing when silent.
class ProgressBar {
  public:
    enum class Style { bar, lines, silent };
    using Clock = std::function<std::chrono::duration<double>()>;
    /// Hears of every update, whatever the style.
    using Watch = std::function<void(int done, int total)>;

    /// What fits standard error: `bar` on a terminal, `lines` elsewhere, `silent` if `quiet`.
    static Style style_of_stderr(bool quiet);

    /// `label` leads every line, e.g. the model's name; `clock` is replaceable for tests; `noun`:
    /// what is counted.
    ProgressBar(std::ostream& out, Style style, std::string label, Clock clock = {},
                std::string noun = "step");

    void watch(Watch watch) { watch_ = std::move(watch); }
    /// `done` of at most `total` steps are done.
    void update(int done, int total);
    /// Ends the bar with the number of steps and the time taken, and `remark` if there is one.
    void finish(const std::string& remark = {});

  private:
    std::ostream& out_;
    Style style_;
    std::string label_, noun_;
    Clock clock_;
    Watch watch_;
    std::chrono::duration<double> start_, drawn_{-1};
    int done_ = 0;
    int tenths_ = 0;  // lines: tenths already reported
};

}  // namespace tricontact::io
