#pragma once

#include <map>
#include <span>
#include <string>

namespace tricontact::app {

/// What `tricontact new` asks, in this order.
struct Question {
    const char* key;    ///< of the case file
    const char* text;   ///< for people
    const char* usual;  ///< the answer of those who press Enter; empty: follows from others
    bool may_be_none = false;
};
std::span<const Question> first_questions();

/// A case that is made of answers; those that are still missing are the usual ones.
class FirstCase {
  public:
    /// "40 mm", "none", of models "mdr,bem". Throws contact::InputError that says what is wrong
    /// with it, as the reader of case files does, and stays as it was.
    void answer(const Question& question, const std::string& answer);
    bool is_answered(const Question& question) const { return answers_.contains(question.key); }

    /// The usual answer, which follows from those before.
    std::string usual(const Question& question) const;
    /// The case file.
    std::string text() const;

  private:
    std::string given(const std::string& key) const;
    std::string value(const std::string& key) const;

    std::map<std::string, std::string> answers_;
};

}  // namespace tricontact::app
