#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/commands/command.h"
#include "bem/contact_program_influence.h"
#include "bem/grid_compliance.h"
#include "bem/model.h"
#include "contact_program/import.h"
#include "contact_program/written_case.h"
#include "io/keys/input_file.h"

namespace tricontact::app {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using contact_program::Import;
using contact_program::ImportedCase;

constexpr std::size_t largest_input_mb = 100;

/// Writes the cases of one input file of CONTACT into a folder.
class CaseImport {
  public:
    CaseImport(const CommandOptions& options, const Import& found)
        : options_(options), found_(found), stem_(fs::path(options.file).stem().string()) {
        for (const ImportedCase& one : found.cases) last_ = std::max(last_, one.last);
        for (const auto& one : found.left_out) last_ = std::max(last_, one.last);
    }

    io::OutputNames names() const {
        io::OutputNames names;
        for (const ImportedCase& one : found_.cases) {
            names.results.push_back(name(one) + ".toml");
            if (!one.heights.empty())
                names.results.push_back(name(one) + contact_program::heights_ending);
            if (!one.influence_file.empty())
                names.results.push_back(name(one) + contact_program::influence_ending);
        }
        return names;
    }

    void write() {
        for (const ImportedCase& one : found_.cases) {
            try {
                write(one);
            } catch (const contact::InputError& why) {
                for (const char* ending :
                     {".toml", contact_program::heights_ending, contact_program::influence_ending})
                    fs::remove(options_.output + "/" + name(one) + ending);
                left_out_.push_back({one.first, one.last, why.what()});
                continue;
            }
            tell(one);
        }
        if (written_.empty()) options_.refuse(left_out_.front().reason);
        left_out_.insert(left_out_.end(), found_.left_out.begin(), found_.left_out.end());
        tell_left_out();
    }

    Answer answer() const {
        return Answer(
            [this] {
                return Json{{"version", files::version},
                            {"folder", options_.output},
                            {"cases", written_},
                            {"left_out", left_out_json_}}
                    .dump(2);
            },
            told_ + fmt::format("written              {} of {} in {}\n", written_.size(),
                                found_.cases.size() + found_.left_out.size(), options_.output));
    }

  private:
    /// Cases that are left out for the same reason are one line, with the place of the first.
    void tell_left_out() {
        struct Reason {
            std::size_t first = 0, last = 0, n = 0;
            std::string text;
        };
        std::vector<Reason> reasons;
        for (const auto& one : left_out_) {
            const auto same = std::ranges::find_if(reasons, [&](const Reason& other) {
                return without_place(other.text) == without_place(one.reason);
            });
            Reason& reason = same != reasons.end() ? *same : reasons.emplace_back();
            if (reason.n == 0) {
                reason.first = one.first;
                reason.text = one.reason;
            }
            reason.last = one.last;
            reason.n += one.last - one.first + 1;
        }
        for (const Reason& one : reasons) {
            left_out_json_.push_back(
                {{"first", one.first}, {"last", one.last}, {"cases", one.n}, {"reason", one.text}});
            const std::size_t within = one.last - one.first + 1;
            told_ +=
                fmt::format("{:<21}{}left out: {}\n", cases(one.first, one.last),
                            one.n == within ? "" : fmt::format("{} of these ", one.n), one.text);
        }
    }

    /// What follows the file's name, line and column.
    std::string without_place(const std::string& reason) const {
        if (!reason.starts_with(options_.file)) return reason;
        const std::size_t rule = reason.find(": ", options_.file.size());
        return rule == std::string::npos ? reason : reason.substr(rule);
    }

    /// The file's own name; of several the number of the first case of CONTACT follows.
    std::string name(const ImportedCase& one) const {
        const bool alone = found_.cases.size() + found_.left_out.size() == 1;
        const auto width = std::to_string(last_).size();
        return alone ? stem_ : fmt::format("{}_{:0{}}", stem_, one.first, width);
    }

    static std::string cases(std::size_t first, std::size_t last) {
        return first == last ? fmt::format("case {}", first)
                             : fmt::format("cases {} to {}", first, last);
    }

    void write(const ImportedCase& one) {
        if (!one.influence_file.empty()) {
            const auto path = fs::path(options_.file).parent_path() / one.influence_file;
            options_.write(name(one) + contact_program::influence_ending,
                           bem::influence_text(bem::read_contact_program_influence(
                               path.string(), one.shear_modulus)));
        }
        if (!one.heights.empty())
            options_.write(name(one) + contact_program::heights_ending, one.heights);
        options_.write(name(one) + ".toml", one.text_beside(name(one)));
        io::read_case(options_.output + "/" + name(one) + ".toml");  // a case that runs
    }

    void tell(const ImportedCase& one) {
        written_.push_back({{"first", one.first},
                            {"last", one.last},
                            {"file", options_.output + '/' + name(one) + ".toml"},
                            {"remarks", one.remarks}});
        told_ += fmt::format("{:<21}{}/{}.toml, for tricontact run\n", cases(one.first, one.last),
                             options_.output, name(one));
        for (const std::string& remark : one.remarks)
            told_ += fmt::format("{:<21}{}\n", "", remark);
    }

    const CommandOptions& options_;
    const Import& found_;
    std::string stem_;
    std::size_t last_ = 0;  // case of the file
    Json written_ = Json::array(), left_out_json_ = Json::array();
    std::vector<contact_program::LeftOutCases> left_out_;
    std::string told_;
};

/// What contact export wrote comes back as the case that it was written of.
bool import_written(const CommandOptions& options, const std::string& input) {
    const auto text = contact_program::written_case(input);
    if (!text) return false;
    const std::string name = fs::path(options.file).stem().string() + ".toml";
    options.fill({{name}}, [&] {
        options.write(name, *text);
        io::read_case(options.output + "/" + name);
    });
    options.answer(Answer(
        [&] {
            const Json one{{"file", options.output + '/' + name}, {"remarks", Json::array()}};
            return Json{{"version", files::version},
                        {"folder", options.output},
                        {"cases", Json::array({one})},
                        {"left_out", Json::array()}}
                .dump(2);
        },
        fmt::format("all cases            the case that they were written of\n"
                    "written              {}/{}\n",
                    options.output, name)));
    return true;
}

/// On the case's own cells: coarse ones are pressed deeper than Hertz says.
double pressed_depth(const Case& c) {
    return bem::make_model(c, 1, bem::Body::half_space)
        ->advance(contact::press_step(c))
        .indentation;
}

/// Writes the cases of an input file of CONTACT (docs/how-to/contact-program.md).
void import_from_contact_program(CommandOptions options) {
    io::refuse_toml(options.file);
    const std::string input =
        io::read_input_file(options.file, "input file of CONTACT", largest_input_mb);
    options.choose_folder("_cases");
    if (import_written(options, input)) return;
    const Import found =
        contact_program::import_cases(input, options.file, bem::is_coupled, pressed_depth);
    CaseImport work(options, found);
    options.fill(work.names(), [&] { work.write(); });
    options.answer(work.answer());
}

}  // namespace

Command contact_import_command() {
    return Declared<CommandOptions>(Group::exchange, "contact import",
                                    "Write the cases of an input file of CONTACT",
                                    import_from_contact_program)
        .on_file("input", "Input file of CONTACT, module 3", "FILE.inp")
        .output("Folder (results/<file>_cases)")
        .json();
}

}  // namespace tricontact::app
