#pragma once

#include <ostream>
#include <streambuf>
#include <string>

namespace tricontact::app {

/// What a stream prints as long as this object lives goes through contact::plain_text: titles,
/// names and texts of inputs must not act on the terminal. Line ends, tabs and what a progress bar
/// needs pass.
class PlainOutput : public std::streambuf {
  public:
    explicit PlainOutput(std::ostream& stream);
    ~PlainOutput() override;
    PlainOutput(const PlainOutput&) = delete;
    PlainOutput& operator=(const PlainOutput&) = delete;

  protected:
    int_type overflow(int_type c) override;
    std::streamsize xsputn(const char* text, std::streamsize n) override;
    int sync() override;

  private:
    bool pass_on();

    std::ostream& stream_;
    std::streambuf* target_;
    std::string waiting_;
};

}  // namespace tricontact::app
