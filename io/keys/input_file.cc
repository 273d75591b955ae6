#include "io/keys/input_file.h"

#include <cerrno>
#include <filesystem>
#include <mutex>
#include <set>
#include <system_error>

#include "files/regular_file.h"
#include "io/keys/messages.h"

namespace tricontact::io {

namespace {

constexpr std::size_t megabyte = 1'000'000;

struct InputFiles {
    std::mutex mutex;
    std::set<std::string> paths;  // canonical
};

InputFiles& inputs_of_process() {
    static InputFiles inputs;
    return inputs;
}

std::string with_article(const std::string& kind) {
    constexpr std::string_view vowels = "aeiou";
    return (vowels.find(kind.front()) == vowels.npos ? "a " : "an ") + kind;
}

[[noreturn]] void refuse(const std::string& path, const files::Unreadable& why,
                         const std::string& kind) {
    const std::string named = "name " + with_article(kind);
    const std::string_view what = why.what();
    if (why.error() == 0)
        fail(path, "", std::string(what) + (what.starts_with("is larger") ? ": no " + kind : ""),
             what == "is a directory" ? named + " inside it" : named);
    const bool missing = why.error() == ENOENT;
    fail(path, "", std::string("the file ") + why.what(),
         missing && kind == "case file" ? "check the path; `tricontact list` names the cases"
         : missing                      ? "check the path"
         : why.error() == EACCES        ? "give yourself the permission to read it"
                                        : "name a readable " + kind);
}

}  // namespace

void note_input_file(const std::string& path) {
    std::error_code ignored;
    const std::string real = std::filesystem::canonical(path, ignored).string();
    const std::scoped_lock lock(inputs_of_process().mutex);
    if (!real.empty()) inputs_of_process().paths.insert(real);
}

bool is_input_file(const std::string& path) {
    std::error_code ignored;
    const std::string real = std::filesystem::canonical(path, ignored).string();
    const std::scoped_lock lock(inputs_of_process().mutex);
    return !real.empty() && inputs_of_process().paths.contains(real);
}

std::string read_input_file(const std::string& path, std::string_view what, std::size_t most_mb) {
    const std::string kind(what);
    try {
        note_input_file(path);
        return files::RegularFile(path).content(most_mb * megabyte);
    } catch (const files::Unreadable& why) {
        refuse(path, why, kind);
    }
}

}  // namespace tricontact::io
