#include "tests/random/record_damages.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

namespace tricontact {
namespace {

using experiments::Record;
using tests::SyntheticRecord;

constexpr double micro = 1e-6;

std::size_t index_at(const Record& record, double t) {
    return static_cast<std::size_t>(std::ranges::lower_bound(record.time, t) - record.time.begin());
}

void cut(Record& record, double from, double to) {
    for (const auto column : {&Record::shift, &Record::drive, &Record::time}) {
        auto& values = record.*column;
        values.erase(values.begin() + std::ptrdiff_t(index_at(record, from)),
                     values.begin() + std::ptrdiff_t(index_at(record, to)));
    }
}

/// While it rolls, but for the last period.
double rolling_time(Random& random) {
    return between(random, {41, 84});
}

double sized(Random& random, const Bounds& size) {
    return between(random, size) * (between(random, {0, 1}) < .5 ? -1 : 1);
}

void add_from(Record& record, double t, double size) {
    for (std::size_t i = index_at(record, t); i < record.time.size(); ++i)
        record.shift[i] += size * micro;
}

void spike(Record& record, double t, std::size_t samples, double size) {
    const std::size_t first = index_at(record, t);
    for (std::size_t i = first; i < first + samples; ++i) record.shift[i] += size * micro;
}

Damage on_making(const char* name, std::function<void(SyntheticRecord&, Random&)> f) {
    return {.name = name, .before = std::move(f)};
}
Damage on_record(const char* name, std::function<void(Record&, Random&)> f) {
    return {.name = name,
            .values = [f = std::move(f)](RecordFile& file, Random& d) { f(file.record, d); }};
}
Damage on_statement(const char* name, std::function<void(RecordFile&, Random&)> f) {
    return {.name = name, .values = std::move(f)};
}
/// Of its lines behind the heading.
Damage on_lines(const char* name, std::function<void(std::vector<std::string>&, Random&)> f) {
    return {.name = name, .text = [f = std::move(f)](RecordFile& file, Random& d) {
                std::vector<std::string> lines;
                std::istringstream text(file.text);
                for (std::string line; std::getline(text, line);) lines.push_back(line);
                f(lines, d);
                file.text.clear();
                for (const std::string& line : lines) file.text += line + '\n';
            }};
}

Damage gap(const char* name, double length) {
    return on_record(name, [length](Record& r, Random& d) {
        const double t = rolling_time(d);
        cut(r, t, t + length);
    });
}

/// Samples whose values are wrong.
std::vector<Damage> of_samples() {
    return {
        on_record("one outlier",
                  [](Record& r, Random& d) {
                      spike(r, between(d, {12, 92}), 1, sized(d, {3, 300}));
                  }),
        on_record("spike before loading",
                  [](Record& r, Random& d) {
                      spike(r, between(d, {1, 8}), 3, sized(d, {3, 300}));
                  }),
        on_record("drop-outs to zero",
                  [](Record& r, Random& d) {
                      for (int k = 0; k < 5; ++k) {
                          const std::size_t first = index_at(r, between(d, {12, 92}));
                          std::fill_n(r.shift.begin() + std::ptrdiff_t(first), 4, 0.);
                      }
                  }),
        on_record("clipped",
                  [](Record& r, Random& d) {
                      const double most = std::ranges::max(r.shift) - between(d, {.3, 30}) * micro;
                      for (double& u : r.shift) u = std::min(u, most);
                  }),
        on_record("stuck",
                  [](Record& r, Random& d) {
                      const std::size_t first = index_at(r, rolling_time(d));
                      for (std::size_t i = first; i < r.shift.size(); ++i)
                          r.shift[i] = r.shift[first];
                  }),
        on_record("dead", [](Record& r, Random&) { std::ranges::fill(r.shift, 0.); }),
        on_statement("coarser than stated",
                     [](RecordFile& f, Random& d) {
                         const double step = between(d, {.3, 5}) * micro;
                         for (double& u : f.record.shift) u = step * std::round(u / step);
                     }),
        on_record("hum of the mains",
                  [](Record& r, Random& d) {  // 50 Hz beside 20 samples a second
                      const double size = between(d, {.5, 5}) * micro;
                      const double f = std::exp(between(d, {std::log(.05), std::log(10)}));
                      const double phase = between(d, {0, 2 * std::numbers::pi});
                      for (std::size_t i = 0; i < r.time.size(); ++i)
                          r.shift[i] +=
                              size * std::sin(2 * std::numbers::pi * f * r.time[i] + phase);
                  }),
        on_making("noise with a memory of 3 s",
                  [](SyntheticRecord& s, Random&) { s.correlation = std::exp(-.05 / 3); }),
        on_making("noise with a memory of 20 s",
                  [](SyntheticRecord& s, Random&) { s.correlation = std::exp(-.05 / 20); }),
        on_record("louder while it rolls",
                  [](Record& r, Random& d) {
                      std::normal_distribution<double> gauss;
                      for (std::size_t i = 0; i < r.time.size(); ++i)
                          if (r.time[i] > 40 && r.time[i] < 88) r.shift[i] += .6 * micro * gauss(d);
                  }),
    };
}

/// Levels that change, and scales.
std::vector<Damage> of_levels() {
    return {
        on_record("jump while it rolls",
                  [](Record& r, Random& d) {
                      add_from(r, rolling_time(d), sized(d, {2, 20}));
                  }),
        on_record("jump in the rest",
                  [](Record& r, Random& d) {
                      add_from(r, between(d, {12, 38}), sized(d, {2, 20}));
                  }),
        on_record("exponential drift",
                  [](Record& r, Random& d) {
                      const double size = sized(d, {2, 10}), memory = between(d, {10, 60});
                      for (std::size_t i = 0; i < r.time.size(); ++i)
                          r.shift[i] += size * micro * std::exp(-r.time[i] / memory);
                  }),
        on_record("drift from the rolling on",
                  [](Record& r, Random& d) {
                      const double rate = sized(d, {.02, .3}) * micro, begin = between(d, {40, 60});
                      for (std::size_t i = 0; i < r.time.size(); ++i)
                          r.shift[i] += rate * std::max(0., r.time[i] - begin);
                  }),
        on_record("another range of the amplifier",
                  [](Record& r, Random& d) {
                      const double factor = between(d, {0, 1}) < .5 ? .5 : 2;
                      for (std::size_t i = index_at(r, rolling_time(d)); i < r.shift.size(); ++i)
                          r.shift[i] *= factor;
                  }),
        on_record("sign of the shift",
                  [](Record& r, Random&) {
                      for (double& u : r.shift) u = -u;
                  }),
        on_record("shift in millimetres, called micrometres",
                  [](Record& r, Random&) {
                      for (double& u : r.shift) u /= 1e3;
                  }),
        on_record("shift in nanometres, called micrometres",
                  [](Record& r, Random&) {
                      for (double& u : r.shift) u *= 1e3;
                  }),
    };
}

/// Times and the drive.
std::vector<Damage> of_times() {
    return {
        gap("gap of 0.6 s", .6),
        gap("gap of 1 s", 1),
        gap("gap of 3 s", 3),
        on_record("ends early",
                  [](Record& r, Random& d) {
                      cut(r, between(d, {62, 88}), r.time.back() + 1);
                  }),
        on_record("samples lost unseen",
                  [](Record& r, Random& d) {
                      const double t = rolling_time(d), length = between(d, {.3, 2});
                      cut(r, t, t + length);
                      for (std::size_t i = index_at(r, t); i < r.time.size(); ++i)
                          r.time[i] -= length;
                  }),
        on_record(
            "a buffer written twice",
            [](Record& r, Random& d) {
                const double t = rolling_time(d), length = between(d, {.3, 2});
                const auto from = std::ptrdiff_t(index_at(r, t)),
                           to = std::ptrdiff_t(index_at(r, t + length));
                for (const auto column : {&Record::shift, &Record::drive, &Record::time}) {
                    auto& values = r.*column;
                    const std::vector<double> again(values.begin() + from, values.begin() + to);
                    values.insert(values.begin() + to, again.begin(), again.end());
                }
                const double by = r.time[std::size_t(to) - 1] - r.time[std::size_t(from)] + .05;
                for (auto i = std::size_t(to); i < r.time.size(); ++i) r.time[i] += by;
            }),
        on_record("delayed drive",
                  [](Record& r, Random& d) {
                      const auto late = std::size_t(between(d, {2, 12}));
                      for (std::size_t i = r.drive.size(); i-- > 0;)
                          r.drive[i] = i >= late ? r.drive[i - late] : 0;
                  }),
        on_record("drive not centred",
                  [](Record& r, Random& d) {
                      const double by = sized(d, {30, 300}) * micro;
                      for (double& w : r.drive) w += by;
                  }),
        on_record("clipped drive",
                  [](Record& r, Random& d) {
                      const double most = between(d, {300, 950}) * micro;
                      for (double& w : r.drive) w = std::min(w, most);
                  }),
        on_record("stuck drive",
                  [](Record& r, Random& d) {
                      const std::size_t first = index_at(r, rolling_time(d));
                      for (std::size_t i = first; i < r.drive.size(); ++i)
                          r.drive[i] = r.drive[first];
                  }),
        on_record("dead drive", [](Record& r, Random&) { std::ranges::fill(r.drive, 0.); }),
        on_record("shift and drive swapped",
                  [](Record& r, Random&) { std::swap(r.shift, r.drive); }),
        on_statement("loaded before the stated time",
                     [](RecordFile& f, Random& d) {
                         *f.stated.loading += between(d, {.1, 3});
                     }),
        on_statement("loaded after the stated time",
                     [](RecordFile& f, Random& d) {
                         *f.stated.loading -= between(d, {.1, 3});
                     }),
        {.name = "never loaded",
         .before = [](SyntheticRecord& s, Random&) { s.unloaded = 0; },
         .values =
             [](RecordFile& f, Random&) {
                 for (double& t : f.record.time) t += 3;
             }},
    };
}

/// What stands in the file.
std::vector<Damage> of_text() {
    const auto line_at = [](const std::vector<std::string>& lines, Random& d) {
        return std::uniform_int_distribution<std::size_t>(2, lines.size() - 2)(d);
    };
    const auto in_cell = [line_at](const char* name, const char* value) {
        return on_lines(name, [line_at, value](auto& lines, Random& d) {
            std::string& line = lines[line_at(lines, d)];
            const auto from = line.find(", ") + 2, to = line.find(", ", from);
            line = line.substr(0, from) + value + line.substr(to);
        });
    };
    return {
        on_lines("a line twice",
                 [line_at](auto& lines, Random& d) {
                     const std::size_t i = line_at(lines, d);
                     lines.insert(lines.begin() + std::ptrdiff_t(i), lines[i]);
                 }),
        on_lines("time running back",
                 [line_at](auto& lines, Random& d) {
                     const std::size_t i = line_at(lines, d);
                     std::swap(lines[i], lines[i + 1]);
                 }),
        in_cell("a missing value", ""),
        in_cell("NaN", "NaN"),
        in_cell("a decimal comma", "\"1,5\""),
        on_lines("cut in the middle of a line",
                 [line_at](auto& lines, Random& d) {
                     lines.resize(line_at(lines, d));
                     lines.back().resize(lines.back().find(','));
                 }),
        {.name = "no units",
         .text = [](RecordFile& f, Random&) { f.heading = "time, shift, drive"; }},
    };
}

}  // namespace

std::vector<Damage> record_damages() {
    std::vector<Damage> all{{.name = "in order"}};
    for (const auto& some : {of_samples(), of_levels(), of_times(), of_text()})
        all.insert(all.end(), some.begin(), some.end());
    return all;
}

}  // namespace tricontact
