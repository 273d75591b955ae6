// Texts that nest so deep that taking them down would end the program.

#include <gtest/gtest.h>

#include "contact/base/error.h"
#include "io/keys/toml_document.h"
#include "io/keys/toml_text.h"

namespace tricontact::io::nesting_test {
namespace {

std::string repeated(const std::string& text, int n) {
    std::string all;
    for (int i = 0; i < n; ++i) all += text;
    return all;
}

std::string message_of(const std::string& text) {
    try {
        parse_document(text, "a.toml");
    } catch (const contact::InputError& error) {
        return error.what();
    }
    return "(accepted)";
}

constexpr int n_deep = 175'000;

TEST(Nesting, RefusesWhatIsTooDeep) {
    const std::string keys = repeated("a.", n_deep) + "a";
    const std::string rule = "tables or lists are nested too deep; write";
    for (const std::string& text :
         {keys + " = 1", "[" + keys + "]", "[[" + keys + "]]", repeated("[a.", n_deep),
          "x = " + repeated("[", n_deep), "x = " + repeated("{a=", n_deep),
          "x = \"a\"\n'b'.\"c\"" + repeated(".a", n_deep) + " = 1",
          "x = [\n" + repeated("[\n", n_deep), "x = {y = {" + keys + " = 1}}",
          "x = \"\"\"\" \\\" \"\"\"\"\"\n" + keys + " = 1", "x = '''\n'\n'''\n" + keys + " = 1",
          repeated("a = 1\n", 10) + "# \"\n" + keys + " = 1", "x = 'open\n" + keys + " = 1"})
        EXPECT_NE(message_of(text).find(rule), std::string::npos)
            << text.substr(0, 40) << ": " << message_of(text);
    EXPECT_EQ(message_of("a = 1\n[" + keys + "]").substr(0, 13), "a.toml:2:35: ");
    // An override of the same kind is taken for a text.
    EXPECT_TRUE(std::holds_alternative<std::string>(parse_value("{" + keys + " = 1}")));
}

TEST(Nesting, TakesWhatIsNot) {
    for (const std::string& text :
         {std::string(), std::string("a.b.c = [[1.5, 2.5], [3.5]]\n[d.e]\nf = {g.h = 1}"),
          "x = \"" + repeated(".", 100) + "\"", "x = '" + repeated("[", 100) + "'",
          "x = \"\"\"\n" + repeated("a.b.c\n\"\"[[", 100) + "\"\"\"", "# " + repeated("a.[", 100),
          "x = [" + repeated("1.5, ", 10'000) + "]", repeated("[[a]]\nb = 1\n", 1000)})
        EXPECT_EQ(first_too_deep(text), std::string_view::npos) << text.substr(0, 60);
}

}  // namespace
}  // namespace tricontact::io::nesting_test
