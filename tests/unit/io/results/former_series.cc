#include "io/results/former_series.h"

#include <gtest/gtest.h>

#include <set>

#include "io/results/atomic_file.h"
#include "tests/unit/io/temporary_folder.h"

namespace tricontact::io::former_series_test {
namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

class FormerSeries : public TemporaryFolder {
  protected:
    void write(const Names& names) const {
        for (const std::string& name : names) std::ofstream(root_ / name) << "content";
    }
    Names names() const {
        Names found;
        for (const auto& entry : fs::directory_iterator(root_))
            found.insert(entry.path().filename().string());
        return found;
    }
    // By no name of a state of the series "surface".
    const Names others_{"surface_000000.csv",    "surface_00000.vti",   "surface_00000a.vti",
                        "surface000000.vti",     "surface_000000.vti~", "surface_cut_000000.vti",
                        "my_surface_000000.vti", "surface_.vti",        "indenter_000000.vtp",
                        "indenter.pvd",          "surface.vti"};
};

TEST_F(FormerSeries, GoesByItsOwnNamesAlone) {
    write({"surface.pvd", "surface_000000.vti", "surface_000017.vtu", "surface_000002.vtp",
           "surface_1000000.vtr"});
    write(others_);
    // A link of such a name is not what a run wrote.
    fs::create_symlink(root_ / "surface.vti", root_ / "surface_000003.vti");
    remove_former_series(root_.string(), "surface");
    Names due = others_;
    due.insert("surface_000003.vti");
    EXPECT_EQ(names(), due);
    EXPECT_NO_THROW(remove_former_series((root_ / "missing").string(), "surface"));
}

TEST_F(FormerSeries, GoesWithTheResultsOfAnEarlierCall) {
    write({"surface.ex2", "surface.pvd", "surface_000000.vti", "history.csv", "kept.csv"});
    remove_old_results(root_.string(), {"surface.ex2", "history.csv"});
    EXPECT_EQ(names(), Names{"kept.csv"});
}

}  // namespace
}  // namespace tricontact::io::former_series_test
