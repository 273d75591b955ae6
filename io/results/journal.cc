#include "io/results/journal.h"

#include <cstring>
#include <system_error>
#include <utility>

#include "contact/base/state_bytes.h"

namespace tricontact::io {

namespace {

using contact::LoadStep;
using contact::StepRecord;

constexpr std::string_view advance_call = "advance ";
constexpr std::string_view release_call = "release ";
constexpr std::string_view limit_call = "limit   ";

// An entry is the bytes of the call, then those of the answer. Of a step, between whose members
// there may be room, one by one: a member that is added to it does not compile until it is named
// here.
std::string bytes_of(const LoadStep& step) {
    contact::StateWriter write;
    const auto write_control = [&](const auto& control) {
        const auto& [kind, value] = control;
        write(kind, value);
    };
    const auto& [phase, offset, normal, tangential, duration, friction, rotation, centre, bulk,
                 recurs, in_proportion] = step;
    write(phase, offset);
    write_control(normal);
    for (const auto& control : tangential) write_control(control);
    write(duration, friction, rotation, centre.frame, centre.place, recurs, in_proportion,
          bulk.stress, bulk.strain);
    return std::string(advance_call) + write.take();
}

}  // namespace

JournalledModel::JournalledModel(std::unique_ptr<contact::Model> model, const std::string& path,
                                 std::string_view key, Warning warn)
    : model_(std::move(model)), path_(path), warn_(std::move(warn)) {
    try {
        file_ = std::make_unique<JournalFile>(path, key);
        for (std::size_t i = 0; i < file_->size(); ++i)
            n_found_ += file_->read_front(i, advance_call.size()) == advance_call;
    } catch (const std::system_error& error) {
        const bool used = error.code() == std::errc::resource_unavailable_try_again;
        give_up("the journal cannot be opened",
                used ? "another run has it open" : error.code().message().c_str());
    }
}

StepRecord JournalledModel::advance(const LoadStep& step) {
    const std::string call = bytes_of(step);
    if (const auto answer = replayed(call)) {
        StepRecord record;
        std::memcpy(&record, answer->data(), sizeof record);
        model_->read_state(std::string_view(*answer).substr(sizeof record));
        return record;
    }
    const StepRecord record = model_->advance(step);
    if (!file_ || !writes_) return record;
    const std::string state = model_->write_state();
    contact::StateWriter answer;
    answer(record);
    if (state.empty())
        finish();
    else
        remember(call + answer.take() + state);
    return record;
}

void JournalledModel::release() {
    model_->release();
    note(release_call);
}

void JournalledModel::start_limit() {
    model_->start_limit();
    note(limit_call);
}

// A call without an answer: it is carried out in any case, here it finds its place in the order.
void JournalledModel::note(std::string_view call) {
    if (!replayed(call) && file_ && writes_) remember(call);
}

// The recorded answer to this call; none where the journal ends or another call was recorded.
std::optional<std::string> JournalledModel::replayed(std::string_view call) {
    if (!file_ || next_ >= file_->size()) return {};
    try {
        const std::string entry = file_->read(next_);
        if (entry.compare(0, call.size(), call) == 0) {
            ++next_;
            return entry.substr(call.size());
        }
        file_->cut(next_);
    } catch (const std::system_error& error) {
        give_up("the journal cannot be read", error.code().message().c_str());
    }
    return {};
}

void JournalledModel::remember(std::string_view entry) {
    if (file_->bytes() + entry.size() > most_bytes_) {
        writes_ = false;
        warn_(path_ + ": the journal has reached its largest size; later steps are not kept");
        return;
    }
    try {
        file_->append(entry);
        next_ = file_->size();
    } catch (const std::system_error& error) {
        writes_ = false;  // what it holds still serves
        warn_(path_ + ": the journal cannot be written (" + error.code().message() +
              "); a run that is killed later goes on from here");
    }
}

bool JournalledModel::show(const Look& look) const {
    const auto* const shows = dynamic_cast<const contact::ShowsSurface*>(model_.get());
    return shows != nullptr && shows->show(look);
}

void JournalledModel::give_up(const std::string& what, const char* reason) {
    file_.reset();
    warn_(path_ + ": " + what + " (" + reason + "); a run that is killed starts again");
}

void JournalledModel::finish() {
    if (!file_) return;
    try {
        file_->remove();
    } catch (const std::system_error& error) {
        warn_(path_ + ": the journal cannot be removed (" + error.code().message() + ")");
    }
    file_.reset();
}

}  // namespace tricontact::io
