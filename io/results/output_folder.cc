#include "io/results/output_folder.h"

#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>

#include "contact/base/error.h"
#include "io/keys/messages.h"
#include "io/results/atomic_file.h"
#include "io/results/journal_file.h"
#include "io/results/result_store.h"

namespace tricontact::io {

namespace {

namespace fs = std::filesystem;

constexpr const char* list_name = ".tricontact";
constexpr std::string_view heading =
    "# Files and folders here that tricontact wrote and may replace; it leaves others alone.\n";
constexpr const char* remedy = "remove it, or choose another output folder";

using Names = std::set<std::string>;

bool is_folder_name(const std::string& name) {
    return name.ends_with('/');
}

// Of the place itself: links are not followed.
fs::file_type type_of(const std::string& path) {
    std::error_code ignored;
    return fs::symlink_status(path, ignored).type();
}

bool is_vacant(const std::string& path) {
    return type_of(path) == fs::file_type::not_found;
}

Names read_list(const std::string& path) {
    Names names;
    if (is_vacant(path)) return names;
    check_replaceable(path);
    std::ifstream file(path, std::ios::binary);
    std::string line;
    if (!std::getline(file, line) || line + '\n' != heading)
        fail(path, "", "is no list of output files, for which its name is kept", remedy);
    while (std::getline(file, line)) names.insert(line);
    return names;
}

void write_list(const std::string& path, const Names& names) {
    std::string text(heading);
    for (const std::string& name : names) text += name + '\n';
    write_file(path, text);
}

// A store of results, or SQLite's journal beside one.
bool belongs_to_store(const std::string& path) {
    constexpr std::string_view journal = "-journal";
    return is_result_store(path) || (path.ends_with(journal) &&
                                     is_result_store(path.substr(0, path.size() - journal.size())));
}

bool holds_files(const std::string& folder) {
    std::error_code ignored;
    for (const auto& entry : fs::recursive_directory_iterator(folder, ignored))
        if (entry.symlink_status(ignored).type() != fs::file_type::directory) return true;
    return false;
}

// Innermost first.
std::vector<std::string> missing_folders(const std::string& path) {
    std::vector<std::string> missing;
    std::error_code ignored;
    fs::path folder = fs::absolute(path).lexically_normal();
    if (folder.filename().empty()) folder = folder.parent_path();
    for (; !fs::exists(folder, ignored) && folder.has_relative_path();
         folder = folder.parent_path())
        missing.push_back(folder.string());
    return missing;
}

}  // namespace

OutputFolder::OutputFolder(std::string path, OutputNames names)
    : path_(std::move(path)), names_(std::move(names)) {
    for (const auto* part : {&names_.results, &names_.kept})
        for (const std::string& name : *part) {
            const auto slash = name.find('/');
            claims_.insert(slash == name.npos ? name : name.substr(0, slash + 1));
        }
    check();
}

std::string OutputFolder::at(const std::string& name) const {
    const std::string inside = is_folder_name(name) ? name.substr(0, name.size() - 1) : name;
    return (fs::path(path_) / inside).string();
}

void OutputFolder::check() const {
    check_output_place(path_);
    for (const std::string& claim : claims_)
        is_folder_name(claim) ? check_folder(claim) : check_file(claim);
    for (const std::string& name : names_.results)
        if (name.find('/') < name.size() - 1) check_replaceable(at(name));
}

void OutputFolder::check_file(const std::string& name) const {
    const std::string path = at(name);
    if (is_vacant(path)) return;
    check_replaceable(path);
    if (read_list(at(list_name)).contains(one_line(name)) || belongs_to_store(path)) return;
    fail(path, "", "is there already, and tricontact did not write it", remedy);
}

void OutputFolder::check_folder(const std::string& name) const {
    const std::string path = at(name);
    if (is_vacant(path)) return;
    std::error_code error;
    if (type_of(path) != fs::file_type::directory) {
        check_replaceable(path);
        fail(path, "", "is a file where a folder is to be made", remedy);
    }
    if (!read_list(at(list_name)).contains(name) && holds_files(path))
        fail(path, "", "is there already, and tricontact did not make it", remedy);
    // An entry knows its type, but not its status.
    for (const auto& entry : fs::recursive_directory_iterator(path, error))
        if (entry.is_symlink(error) ||
            (!entry.is_directory(error) && !entry.is_regular_file(error)))
            check_replaceable(entry.path().string());
        else if (entry.path().filename() == journal_name)
            JournalFile::refuse_other_file(entry.path().string());
}

void OutputFolder::begin(files::FolderLock& lock) {
    check();
    made_ = missing_folders(path_);
    make_output_folder(path_);
    if (!lock.take(path_))
        fail(path_, "", "is being filled by another run",
             "wait until that has ended, or choose another output folder");
    check();  // of what that may have left
    listed_before_ = read_list(at(list_name));
    for (const std::string& claim : claims_)
        if (is_vacant(at(claim))) fresh_.insert(claim);
    has_begun_ = true;
    Names listed = listed_before_;
    for (const std::string& claim : claims_) listed.insert(one_line(claim));
    if (listed != listed_before_) write_list(at(list_name), listed);
    remove_old_results(path_, names_.results);
}

void OutputFolder::fill(const std::function<void()>& work) {
    files::FolderLock lock;
    try {
        begin(lock);
        work();
    } catch (const contact::InputError&) {
        withdraw();
        throw;
    }
}

void OutputFolder::withdraw() const {
    if (!has_begun_) return;
    std::error_code ignored;
    for (const std::string& name : fresh_)
        if (is_folder_name(name) && holds_files(at(name))) return;  // results, to be kept
    for (const std::string& name : names_.kept)
        if (!is_folder_name(name) && fresh_.contains(name) && !is_vacant(at(name))) return;
    // Folders that hold no files, and files that were written ahead of any result.
    for (const std::string& name : fresh_)
        if (!is_vacant(at(name))) fs::remove_all(at(name), ignored);
    if (listed_before_.empty())
        fs::remove(at(list_name), ignored);
    else
        write_list(at(list_name), listed_before_);
    for (const std::string& folder : made_) fs::remove(folder, ignored);  // unless it holds others'
}

}  // namespace tricontact::io
