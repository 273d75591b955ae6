#include "fem/distributed/session.h"

#include <deal.II/base/mpi.h>
#include <petscsys.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>

#include "contact/base/error.h"

extern "C" void openblas_set_num_threads(int n);

// One MPI session per process. Errors are agreed on by all ranks before they are thrown (`agree`),
// or end all of them (`abort_on_local_error`): a rank that left alone would let the others wait in
// a collective call.

namespace tricontact::fem::distributed {

namespace {

enum class Failure : int { none, input, not_converged, memory, other };

struct Outcome {
    Failure failure = Failure::none;
    std::string message;
};

Outcome outcome_of(const std::function<void()>& work) {
    try {
        work();
        return {};
    } catch (const contact::InputError& e) {
        return {Failure::input, e.what()};
    } catch (const contact::NotConverged& e) {
        return {Failure::not_converged, e.what()};
    } catch (const std::bad_alloc&) {
        return {Failure::memory, ""};
    } catch (const std::exception& e) {
        return {Failure::other, e.what()};
    }
}

void raise(const Outcome& outcome) {
    switch (outcome.failure) {
        case Failure::none:
            return;
        case Failure::input:
            throw contact::InputError(outcome.message);
        case Failure::not_converged:
            throw contact::NotConverged(outcome.message);
        case Failure::memory:
            throw std::bad_alloc();
        case Failure::other:
            throw std::runtime_error(outcome.message);
    }
}

std::string broadcast_text(std::string text, int from) {
    unsigned long size = text.size();
    MPI_Bcast(&size, 1, MPI_UNSIGNED_LONG, from, MPI_COMM_WORLD);
    text.resize(size);
    MPI_Bcast(text.data(), static_cast<int>(size), MPI_CHAR, from, MPI_COMM_WORLD);
    return text;
}

double reduced(double value, MPI_Op operation, MPI_Comm communicator) {
    double result = 0;
    MPI_Allreduce(&value, &result, 1, MPI_DOUBLE, operation, communicator);
    return result;
}

}  // namespace

struct Session::Libraries {
    // Of the arguments, the libraries' own options are none of ours.
    int n_arguments = 0;
    char** arguments = nullptr;
    std::optional<dealii::Utilities::MPI::MPI_InitFinalize> mpi;
    MPI_Comm machine = MPI_COMM_NULL;

    Libraries() {
        mpi.emplace(n_arguments, arguments, 1);
        PetscPushErrorHandler(PetscReturnErrorHandler, nullptr);  // errors become exceptions
        PetscPopSignalHandler();
        MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
    }
    ~Libraries() { MPI_Comm_free(&machine); }
};

Session::Session() : libraries_(std::make_unique<Libraries>()) {
    if (!std::getenv("OPENBLAS_NUM_THREADS")) openblas_set_num_threads(1);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &n_ranks_);
}
Session::~Session() = default;

// MPI's own waiting takes a processor each.
void Session::wait_for_all() const {
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Ibarrier(MPI_COMM_WORLD, &request);
    int are_here = 0;
    for (MPI_Test(&request, &are_here, MPI_STATUS_IGNORE); !are_here;
         MPI_Test(&request, &are_here, MPI_STATUS_IGNORE))
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

void Session::agree(const std::function<void()>& work) const {
    Outcome outcome = outcome_of(work);
    wait_for_all();
    const int mine = outcome.failure == Failure::none ? n_ranks_ : rank_;
    int first = n_ranks_;
    MPI_Allreduce(&mine, &first, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
    if (first == n_ranks_) return;
    MPI_Bcast(&outcome.failure, sizeof(outcome.failure), MPI_BYTE, first, MPI_COMM_WORLD);
    outcome.message = broadcast_text(outcome.message, first);
    agreed_to_fail_ = true;
    raise(outcome);
}

void Session::agree_on_first(const std::function<void()>& work) const {
    agree([&] {
        if (is_root()) work();
    });
}

void Session::add_on_first(std::vector<double>& values) const {
    constexpr std::size_t most = 1 << 27;  // MPI counts with int
    std::vector<double> other(is_root() ? std::min(most, values.size()) : 0);
    for (int from = 1; from < n_ranks_; ++from)
        for (std::size_t at = 0; at < values.size(); at += most) {
            const std::size_t n = std::min(most, values.size() - at);
            if (rank_ == from)
                MPI_Send(values.data() + at, static_cast<int>(n), MPI_DOUBLE, 0, 0, MPI_COMM_WORLD);
            if (!is_root()) continue;
            MPI_Recv(other.data(), static_cast<int>(n), MPI_DOUBLE, from, 0, MPI_COMM_WORLD,
                     MPI_STATUS_IGNORE);
            for (std::size_t i = 0; i < n; ++i) values[at + i] += other[i];
        }
}

double Session::largest(double value) const {
    return reduced(value, MPI_MAX, MPI_COMM_WORLD);
}
double Session::sum(double value) const {
    return reduced(value, MPI_SUM, MPI_COMM_WORLD);
}
double Session::sum_on_machine(double value) const {
    return reduced(value, MPI_SUM, libraries_->machine);
}

void Session::abort_on_local_error(const std::function<void()>& work) const {
    try {
        work();
    } catch (const std::exception& e) {
        if (agreed_to_fail_ || n_ranks_ == 1) throw;
        // Mostly all ranks meet the same error: the first ends the others before they print.
        if (!is_root()) std::this_thread::sleep_for(std::chrono::seconds(2));
        std::fprintf(stderr, "error: rank %d: %s\n", rank_, e.what());
        std::fflush(stderr);
        MPI_Abort(MPI_COMM_WORLD, 1);
    }
}

void Session::broadcast(void* values, std::size_t size) const {
    auto* bytes = static_cast<char*>(values);
    constexpr std::size_t most = 1 << 30;  // MPI counts with int
    for (std::size_t at = 0; at < size; at += most)
        MPI_Bcast(bytes + at, static_cast<int>(std::min(most, size - at)), MPI_BYTE, 0,
                  MPI_COMM_WORLD);
}

}  // namespace tricontact::fem::distributed
