#include "benchmarks/submissions/dat_totals.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "benchmarks/reference/reference.h"
#include "benchmarks/submissions/fixed_columns.h"
#include "io/keys/messages.h"
#include "io/keys/number_text.h"

namespace tricontact::benchmarks {

namespace {

/// Numbers of a line, all of them; empty if something else stands there.
std::vector<double> numbers_of(std::string_view line) {
    std::vector<double> numbers;
    for (const auto word : io::words_of(line)) {
        const auto value = fortran_number(word);
        if (!value) return {};
        numbers.push_back(*value);
    }
    return numbers;
}

/// "NIND" of "total force (fx,fy,fz) for set NIND and time  0.1".
std::string word_after(std::string_view heading, std::string_view before) {
    const auto at = heading.find(before);
    if (at == heading.npos) return {};
    const auto words = io::words_of(heading.substr(at + before.size()), " \t\r,");
    return words.empty() ? std::string() : std::string(words[0]);
}

/// Text behind "time".
std::optional<std::string> time_of(std::string_view heading) {
    const auto at = heading.rfind("time ");
    if (at == heading.npos) return {};
    const auto text = io::trimmed(heading.substr(at + 5));
    if (!fortran_number(text)) return {};
    return std::string(text);
}

struct Printed {
    std::string name, time, place;
    std::vector<double> values;
};

struct DatFile {
    std::vector<Printed> forces;      ///< of sets
    std::vector<Printed> statistics;  ///< of pairs: force and moment, then area, normal, shear
    std::vector<Printed> energies;    ///< of sets
    std::set<std::string> unused;
    std::string last_time;
};

void replace(std::vector<Printed>& list, Printed one) {
    const auto same = std::ranges::find_if(list, [&](const Printed& other) {
        return other.name == one.name && other.time == one.time;
    });
    if (same == list.end()) {
        // Only the last time counts.
        std::erase_if(list, [&](const Printed& other) { return other.time != one.time; });
        list.push_back(std::move(one));
    }
}

class DatParser {
  public:
    DatParser(std::string_view text, const std::string& name) : lines_(text), name_(name) {}

    DatFile parse() {
        while (lines_.next()) {
            const std::string_view line = io::trimmed(lines_.line());
            if (line.empty() || line.size() > 400) continue;
            const char first = line.front();
            const bool is_text = (first >= 'a' && first <= 'z') || (first >= 'A' && first <= 'Z');
            if (is_text) read_heading(line);
        }
        return std::move(file_);
    }

  private:
    std::vector<double> next_numbers(std::size_t n) {
        while (lines_.next()) {
            const std::string_view line = io::trimmed(lines_.line());
            if (line.empty()) continue;
            std::vector<double> numbers = numbers_of(line);
            const bool finite =
                std::ranges::all_of(numbers, [](double value) { return std::isfinite(value); });
            if (numbers.size() < n || !finite)
                io::fail(name_ + ':' + std::to_string(lines_.number()), "",
                         std::to_string(n) + " finite numbers are due below the heading",
                         "repeat the run");
            return numbers;
        }
        io::fail(name_, "", "ends below a heading", "repeat the run");
    }

    Printed printed(std::string name, const std::string& time, std::size_t n) {
        const std::string place =
            name_ + ':' + std::to_string(lines_.number()) + (name.empty() ? "" : ", set " + name);
        return {std::move(name), time, place, next_numbers(n)};
    }

    void read_heading(std::string_view line) {
        if (const auto time = time_of(line)) {
            time_ = file_.last_time = *time;
            pair_.clear();
            if (line.starts_with("total force")) {
                replace(file_.forces, printed(word_after(line, "for set "), time_, 3));
            } else if (line.starts_with("statistics for slave set")) {
                pair_ = word_after(line, "slave set ");
            } else if (line.starts_with("total internal energy")) {
                replace(file_.energies, printed(word_after(line, "for set "), time_, 1));
            } else {
                const auto end = std::min(line.find(" ("), line.find(" for "));
                if (file_.unused.size() < 20)
                    file_.unused.emplace(io::shortened(line.substr(0, end), 60));
            }
        } else if (!pair_.empty() && line.starts_with("total surface force")) {
            replace(file_.statistics, printed(pair_, time_, 6));
        } else if (!pair_.empty() && line.starts_with("area,")) {
            replace(areas_of_pairs(), printed(pair_, time_, 3));
        }
    }

    std::vector<Printed>& areas_of_pairs() { return areas_; }

    LineReader lines_;
    std::string name_, time_, pair_;
    DatFile file_;

  public:
    std::vector<Printed> areas_;
};

/// Component along a letter of the axes.
double along(const Printed& force, const std::string& axes, char letter) {
    return force.values[axes.find(letter)];
}

/// Letters of the axes where z is that of the largest component of all.
std::string axes_of_largest(const std::vector<Printed>& forces) {
    double largest = 0;
    std::size_t axis = 2;
    for (const Printed& force : forces)
        for (std::size_t k = 0; k < 3; ++k)
            if (std::abs(force.values[k]) > largest) {
                largest = std::abs(force.values[k]);
                axis = k;
            }
    return axis == 2 ? "xyz" : axis == 1 ? "xzy" : "zyx";
}

void add_forces(const std::vector<Printed>& forces, const std::string& given_axes,
                std::map<std::string, Total>& totals, std::vector<std::string>& notes) {
    const std::string axes = given_axes.empty() ? axes_of_largest(forces) : given_axes;
    const auto normal = [&](const Printed& force) { return along(force, axes, 'z'); };
    const auto largest =
        std::ranges::max_element(forces, {}, [&](const Printed& f) { return std::abs(normal(f)); });
    if (largest == forces.end()) return;
    totals[quantity_keys::normal_force] = {normal(*largest), {}, largest->place};
    totals[quantity_keys::tangential_force] = {along(*largest, axes, 'x'), {}, largest->place};
    const Printed* balance = nullptr;
    for (const Printed& force : forces)
        if (normal(force) * normal(*largest) < 0 &&
            (!balance || std::abs(normal(force)) > std::abs(normal(*balance))))
            balance = &force;
    if (balance) totals[balancing_force] = {normal(*balance), {}, balance->place};
    for (const Printed& force : forces)
        if (&force != &*largest && &force != balance)
            notes.push_back("total force of set " + force.name + " is not used");
}

}  // namespace

bool is_calculix_print(std::string_view text) {
    const std::string_view begin = text.substr(0, 4000);
    for (const char* heading :
         {"total force (fx,fy,fz)", "forces (fx,fy,fz)", "contact stress (slave", "statistics for",
          "displacements (vx,vy,vz)", "total internal energy", "relative contact displacement",
          "stresses (elem"})
        if (begin.find(heading) != begin.npos) return true;
    return false;
}

std::map<std::string, Total> parse_dat(std::string_view text, const std::string& name,
                                       const std::string& axes, std::vector<std::string>& notes) {
    DatParser parser(text, name);
    DatFile file = parser.parse();
    for (auto* list : {&file.forces, &file.statistics, &file.energies, &parser.areas_})
        std::erase_if(*list, [&](const Printed& one) { return one.time != file.last_time; });
    std::map<std::string, Total> totals;
    add_forces(file.forces.empty() ? file.statistics : file.forces, axes, totals, notes);
    if (parser.areas_.size() == 1)
        totals[quantity_keys::contact_area] = {
            parser.areas_[0].values[0], {}, parser.areas_[0].place};
    else if (parser.areas_.size() > 1)
        notes.emplace_back("contact areas are not used: there are several contact pairs");
    if (file.energies.size() == 1)
        totals[quantity_keys::stored_energy] = {
            file.energies[0].values[0], {}, file.energies[0].place};
    else if (file.energies.size() > 1)
        notes.emplace_back("internal energies are not used: there are several sets");
    if (!file.unused.empty()) notes.push_back("prints not used: " + io::joined(file.unused));
    if (totals.empty())
        io::fail(name, "", "holds neither a total force nor the statistics of a contact pair",
                 "print them by *NODE PRINT, NSET=..., TOTALS=ONLY with RF, or by *CONTACT PRINT "
                 "with CF");
    return totals;
}

}  // namespace tricontact::benchmarks
