#pragma once

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/time.h>

#include <chrono>
#include <string>

#include "fem/distributed/layer.h"
#include "fem/distributed/session.h"

namespace tricontact::fem::distributed {

/// Seconds of this process, and its largest size so far.
struct Cost {
    double wall =
        std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
    double user = 0, gigabytes = 0;

    Cost() {
        rusage usage{};
        getrusage(RUSAGE_SELF, &usage);
        user = static_cast<double>(usage.ru_utime.tv_sec) +
               1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
        gigabytes = 1024e-9 * static_cast<double>(usage.ru_maxrss);
    }
};

/// Tells what each stage cost, all ranks together.
class Stages {
  public:
    Stages(const Session& session, const Say& say) : session_(session), say_(say) {}

    void finished(const std::string& what) {
        const Cost now;
        const double user = session_.sum(now.user - last_.user);
        const double gigabytes = session_.largest(now.gigabytes);
        if (session_.is_root())
            say_(fmt::format("{}: {:.1f} s, {:.1f} s of processors, at most {:.2f} GB per rank",
                             what, now.wall - last_.wall, user, gigabytes));
        last_ = now;
    }

  private:
    const Session& session_;
    const Say& say_;
    Cost last_;
};

}  // namespace tricontact::fem::distributed
