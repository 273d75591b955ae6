#include "io/results/progress.h"

#include <gtest/gtest.h>

#include <sstream>

namespace tricontact::io::progress_test {
namespace {

using Style = ProgressBar::Style;
using Seconds = std::chrono::duration<double>;

class Progress : public testing::Test {
  protected:
    ProgressBar make(Style style) {
        return {out_, style, "mdr", [this] { return Seconds(time_); }};
    }

    std::ostringstream out_;
    double time_ = 0;
};

TEST_F(Progress, LinesComeEachTenPercentWithTheRemainingTime) {
    ProgressBar progress = make(Style::lines);
    for (int step = 1; step <= 40; ++step) {
        time_ = step;  // one second per step
        progress.update(step, 40);
    }
    progress.finish("shakedown");
    const std::string text = out_.str();
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 11);
    EXPECT_EQ(text.rfind("mdr: 10 %, step 4 of at most 40, 0:36 left\n", 0), 0U) << text;
    EXPECT_NE(text.find("mdr: 50 %, step 20 of at most 40, 0:20 left\n"), std::string::npos)
        << text;
    EXPECT_NE(text.find("mdr: 40 steps in 40.00 s, shakedown\n"), std::string::npos) << text;
    EXPECT_EQ(text.find('\r'), std::string::npos);
    EXPECT_EQ(text.find('\x1b'), std::string::npos);
}

TEST_F(Progress, ALongRunShowsHours) {
    ProgressBar progress = make(Style::lines);
    time_ = 3600;
    progress.update(1, 10);
    EXPECT_EQ(out_.str(), "mdr: 10 %, step 1 of at most 10, 9:00:00 left\n");
}

TEST_F(Progress, TheBarStaysOnItsLineAndIsNotRedrawnTooOften) {
    ProgressBar progress = make(Style::bar);
    for (int step = 1; step <= 1000; ++step) {
        time_ = 0.001 * step;  // one second altogether: at most 10 redraws and the first and last
        progress.update(step, 1000);
    }
    const std::string drawn = out_.str();
    EXPECT_LE(std::count(drawn.begin(), drawn.end(), '\r'), 12);
    EXPECT_GE(std::count(drawn.begin(), drawn.end(), '\r'), 9);
    EXPECT_EQ(drawn.find('\n'), std::string::npos);
    EXPECT_NE(drawn.find("mdr [##############################] 100 % step 1000/1000, 0:00 left"),
              std::string::npos)
        << drawn;
    progress.finish();
    EXPECT_TRUE(out_.str().ends_with("\r\x1b[Kmdr: 1000 steps in 1.00 s\n")) << out_.str();
}

TEST_F(Progress, SilentSaysNothing) {
    ProgressBar progress = make(Style::silent);
    progress.update(5, 10);
    progress.finish("shakedown");
    EXPECT_EQ(out_.str(), "");
    EXPECT_EQ(ProgressBar::style_of_stderr(true), Style::silent);
}

TEST_F(Progress, OddCountsDoNoHarm) {
    for (const Style style : {Style::bar, Style::lines}) {
        ProgressBar progress = make(style);
        progress.update(0, 0);
        progress.update(0, 10);
        progress.update(20, 10);
    }
    EXPECT_EQ(out_.str().find("nan"), std::string::npos);
    EXPECT_EQ(out_.str().find("200 %"), std::string::npos);
}

}  // namespace
}  // namespace tricontact::io::progress_test
