#include <algorithm>

#include "benchmarks/problems/data_files.h"
#include "benchmarks/problems/problem.h"
#include "contact/base/error.h"
#include "io/case/case_reader.h"
#include "io/keys/key_checks.h"
#include "io/keys/messages.h"

namespace tricontact::benchmarks {

namespace {

std::string with_underscores(std::string name) {
    std::ranges::replace(name, '-', '_');
    return name;
}

}  // namespace

contact::Case Problem::make_case() const {
    if (!has_case())
        throw contact::InputError(name +
                                  ": is a problem with closed forms and has no case; its numbers "
                                  "are those of tricontact benchmark show " +
                                  name);
    return io::parse_case(case_text, name + ".toml");
}

const std::vector<Problem>& catalogue() {
    static const std::vector<Problem> problems = [] {
        std::vector<Problem> all;
        for (const ProblemFile& file : problem_files())
            all.push_back(parse_problem(file.text, std::string(file.name)));
        return all;
    }();
    return problems;
}

const Problem* find_problem(const std::string& name) {
    const auto found = std::ranges::find(catalogue(), with_underscores(name), &Problem::name);
    return found == catalogue().end() ? nullptr : &*found;
}

const Problem& required_problem(const std::string& name) {
    if (const Problem* found = find_problem(name)) return *found;
    std::vector<std::string_view> names;
    for (const Problem& problem : catalogue()) names.push_back(problem.name);
    const std::string_view near = io::nearest(with_underscores(name), names);
    io::fail(io::shortened(name, 60), "", "is no problem of the catalogue",
             io::did_you_mean(near, "tricontact benchmark list names them"));
}

}  // namespace tricontact::benchmarks
