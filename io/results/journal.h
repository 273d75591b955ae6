#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "contact/mirrored_surface.h"
#include "contact/model.h"
#include "io/results/journal_file.h"

namespace tricontact::io {

/// A model that keeps a journal of its steps, so that a run that was killed goes on where it ended:
/// over a journal with the same key the first calls of `advance`, `release` and `start_limit` are
/// answered from it as long as they are the same calls in the same order, everything after that is
/// computed and appended. Entries
/// hold step, record and the model's state (`write_state`), so that whatever is asked of the model
/// in between has its answer. A model that does not write its state has no journal.
///
/// A journal that cannot be read or written never fails a run: it is said once, and the run goes on
/// without.
class JournalledModel final : public contact::Model, public contact::ShowsSurface {
  public:
    using Warning = std::function<void(const std::string&)>;

    /// `path` [file]; its folder must exist. `key`: everything that the steps depend on, such as
    /// the resolved case, the program's version and the model's name. Throws contact::InputError
    /// where something other than a journal stands there.
    JournalledModel(std::unique_ptr<contact::Model> model, const std::string& path,
                    std::string_view key, Warning warn);

    /// Steps that the journal holds from an earlier run, at the start.
    int n_found() const { return n_found_; }
    /// Removes the journal: the results are written.
    void finish();
    /// Bytes after which a journal does not grow any more.
    void limit_size(std::uint64_t bytes) { most_bytes_ = bytes; }

    contact::StepRecord advance(const contact::LoadStep& step) override;
    void release() override;
    void start_limit() override;
    void start_period() override { model_->start_period(); }  // its sums are part of the state

    std::string name() const override { return model_->name(); }
    bool is_coupled() const override { return model_->is_coupled(); }
    double step_accuracy() const override { return model_->step_accuracy(); }
    contact::Scales scales() const override { return model_->scales(); }
    contact::Surface surface() const override { return model_->surface(); }
    bool show(const Look& look) const override;
    std::vector<contact::ContactState> contact_states() const override {
        return model_->contact_states();
    }
    double limit_tangential_ratio() const override { return model_->limit_tangential_ratio(); }
    std::optional<contact::PullOff> pull_off() const override { return model_->pull_off(); }
    std::unique_ptr<const contact::Interior> interior() override { return model_->interior(); }
    /// Of the model alone: what it does is in no journal.
    std::unique_ptr<contact::Model> sibling(const contact::Case::Contact& options) const override {
        return model_->sibling(options);
    }
    std::string write_state() const override { return model_->write_state(); }
    void read_state(std::string_view bytes) override { model_->read_state(bytes); }
    const contact::Audit& audit() const override { return model_->audit(); }

  private:
    std::optional<std::string> replayed(std::string_view call);
    void note(std::string_view call);
    void remember(std::string_view entry);
    void give_up(const std::string& what, const char* reason);

    std::unique_ptr<contact::Model> model_;
    std::string path_;
    Warning warn_;
    std::unique_ptr<JournalFile> file_;  // null: none
    std::size_t next_ = 0;               // entry that the next call is compared with
    bool writes_ = true;
    std::uint64_t most_bytes_ = std::uint64_t{4} << 30;
    int n_found_ = 0;
};

}  // namespace tricontact::io
