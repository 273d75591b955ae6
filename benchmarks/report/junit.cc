#include <fmt/format.h>

#include <algorithm>

#include "benchmarks/report/comparison_output.h"
#include "benchmarks/report/comparison_words.h"
#include "files/version.h"
#include "report/format.h"

namespace tricontact::benchmarks {

namespace {

/// Of a text between quotes. What XML 1.0 has no place for is a question mark.
std::string xml_text(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '&')
            result += "&amp;";
        else if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else if (c == '"')
            result += "&quot;";
        else if (c == '\n')
            result += "&#10;";
        else
            result += static_cast<unsigned char>(c) < ' ' ? '?' : c;
    }
    return result;
}

std::string reason_of(const ComparedNumber& number) {
    std::string text = budget_sentence(number);
    if (!number.blame.empty()) text += "; largest term of U: " + number.blame;
    if (!number.remedy.empty()) text += "; " + number.remedy;
    return text;
}

std::string test_case(const Comparison& comparison, const ComparedNumber& number) {
    std::string code = code_of(comparison);
    // What stands before the last dot is a package for readers of these files.
    std::ranges::replace(code, '.', '_');
    const std::string head =
        fmt::format("    <testcase classname=\"{}.{}\" name=\"{}\" time=\"0\"",
                    xml_text(comparison.name), xml_text(code), xml_text(number.key));
    const std::string reason = xml_text(reason_of(number));
    if (number.standing == Standing::pass)
        return head +
               fmt::format(">\n      <system-out>{}</system-out>\n    </testcase>\n", reason);
    if (number.standing == Standing::fail)
        return head + fmt::format(
                          ">\n      <failure message=\"{}\" type=\"fail\"/>\n    "
                          "</testcase>\n",
                          reason);
    return head + fmt::format(">\n      <skipped message=\"not resolved: {}\"/>\n    </testcase>\n",
                              reason);
}

}  // namespace

std::string junit_xml(const Comparison& comparison) {
    const auto number_of = [&](Standing standing) {
        return std::ranges::count(comparison.numbers, standing, &ComparedNumber::standing);
    };
    const std::string counts = fmt::format(
        "tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"{}\" time=\"0\"",
        comparison.numbers.size(), number_of(Standing::fail), number_of(Standing::not_resolved));
    std::string text = fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"tricontact benchmark\" "
        "{0}>\n  <testsuite name=\"{1}\" {0}>\n    <properties>\n      <property "
        "name=\"tricontact\" value=\"{2}\"/>\n      <property name=\"verdict\" value=\"{3}\"/>\n"
        "    </properties>\n",
        counts, xml_text(comparison.name), files::version, name_of(comparison.standing));
    for (const ComparedNumber& number : comparison.numbers) text += test_case(comparison, number);
    return text + "  </testsuite>\n</testsuites>\n";
}

}  // namespace tricontact::benchmarks
