// Reads a file by VTK and writes its meshes to standard output: started by the program for each
// such file, with limits of time and memory. Whatever a broken file makes VTK do ends here.

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>

#include <algorithm>
#include <csignal>
#include <exception>
#include <new>
#include <string>
#include <string_view>

#include "benchmarks/vtk_reader/vtk_files.h"

namespace {

constexpr rlim_t most_memory = 4'000'000'000, most_output = 2'000'000'000;  // [bytes]
constexpr unsigned most_seconds = 30;

void limit(int resource, rlim_t most) {
    rlimit old{};
    ::getrlimit(static_cast<__rlimit_resource>(resource), &old);
    const rlim_t now = old.rlim_max == RLIM_INFINITY || most < old.rlim_max ? most : old.rlim_max;
    const rlimit limits{now, now};
    ::setrlimit(static_cast<__rlimit_resource>(resource), &limits);
}

/// Keeps the first error of VTK, and nothing reaches the terminal.
class FirstError : public vtkOutputWindow {
  public:
    static FirstError* New();
    vtkTypeMacro(FirstError, vtkOutputWindow) void DisplayText(const char*) override {}
    void DisplayErrorText(const char* text) override {
        if (error.empty() && text) error = text;
    }
    void DisplayWarningText(const char* text) override { keep_warning(text); }
    void DisplayGenericWarningText(const char* text) override { keep_warning(text); }
    void DisplayDebugText(const char*) override {}

    std::string error, warning;

  private:
    void keep_warning(const char* text) {
        if (warning.empty() && text) warning = text;
    }
};
vtkStandardNewMacro(FirstError);

/// "ERROR: In vtkXMLReader.cxx, line 404\nvtkX (0x...): text\n\n" as its text.
std::string plain(std::string text) {
    const auto colon = text.find("): ");
    const auto line = text.find(", line ");
    if (colon != text.npos)
        text = text.substr(colon + 3);
    else if (line != text.npos)
        text = text.substr(std::min(text.find_first_not_of("0123456789", line + 7), text.size()));
    for (char& c : text)
        if (c == '\n' || c == '\r' || c == '\t') c = ' ';
    text = text.substr(std::min(text.find_first_not_of(' '), text.size())).substr(0, 200);
    return text.substr(0, text.find_last_not_of(' ') + 1);
}

bool write_out(int descriptor, const std::string& bytes) {
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t n = ::write(descriptor, bytes.data() + done, bytes.size() - done);
        if (n <= 0) return false;
        done += static_cast<std::size_t>(n);
    }
    return true;
}

}  // namespace

int main(int n_arguments, char** arguments) {
    using namespace tricontact::benchmarks;
    if (n_arguments != 2) return 2;
    const int out = ::dup(STDOUT_FILENO), nowhere = ::open("/dev/null", O_WRONLY);
    if (out < 0 || nowhere < 0) return 1;
    ::dup2(nowhere, STDOUT_FILENO);  // libraries below VTK print there
    limit(RLIMIT_AS, most_memory);
    limit(RLIMIT_FSIZE, most_output);
    limit(RLIMIT_CPU, most_seconds);
    limit(RLIMIT_CORE, 0);
    // A file may name others, and among them a pipe that nobody writes to.
    std::signal(SIGALRM, SIG_DFL);
    ::alarm(2 * most_seconds);
    const vtkNew<FirstError> errors;
    vtkOutputWindow::SetInstance(errors);
    MeshAnswer answer;
    try {
        answer = read_by_vtk(arguments[1]);
    } catch (const std::bad_alloc&) {
        answer.error = "needs more memory than a mesh of its size";
    } catch (const std::exception& error) {
        answer.error = error.what();
    }
    // What was read in spite of an error may be half of the file.
    const bool is_legacy = std::string_view(arguments[1]).ends_with(".vtk");
    if (is_legacy && errors->error.empty()) errors->error = errors->warning;
    if (!errors->error.empty()) answer.error = plain(errors->error);
    if (!answer.error.empty()) {
        answer.meshes.clear();
        answer.notes.clear();
    }
    const bool is_written = write_out(out, written(answer));
    ::_exit(is_written ? 0 : 1);  // destructors of VTK have nothing to save
}
