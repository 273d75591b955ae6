// A model without mechanics that remembers all its steps.

#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <string>

#include "contact/base/error.h"
#include "contact/model.h"

namespace tricontact::io {

// Its state mixes all steps so far, in an order that matters; every member of a step and of a
// record takes part.
class FakeModel final : public contact::Model {
  public:
    struct Count {
        int solved = 0, released = 0;
    };
    explicit FakeModel(Count& count, bool with_state = true)
        : count_(count), with_state_(with_state) {}

    std::string name() const override { return "fake"; }
    contact::StepRecord advance(const contact::LoadStep& step) override {
        if (step.phase > 1e6) throw contact::NotConverged("too far");
        ++count_.solved;
        double sum = step.phase + 2 * step.offset[0] + 3 * step.offset[1] + step.normal.value;
        sum += step.normal.kind == contact::NormalControl::Kind::force ? 1 : 5;
        for (const auto& control : step.tangential)
            sum += 7 * control.value +
                   (control.kind == contact::TangentialControl::Kind::force ? 1 : 6);
        state_ = 0.9 * state_ + (step.friction ? sum : sum / 3);
        least_ = std::min(least_, state_);
        path_ += state_;
        return record(step);
    }
    bool is_coupled() const override { return true; }
    void release() override {
        ++count_.released;
        state_ = 0;
    }
    contact::Scales scales() const override { return {state_, 1, 2, 3, 4}; }
    contact::Surface surface() const override {
        contact::Surface s;
        s.gap = {state_};
        return s;
    }
    double limit_tangential_ratio() const override { return least_; }
    void start_limit() override { least_ = state_; }
    void start_period() override { path_ = 0; }
    std::unique_ptr<const contact::Interior> interior() override {
        auto in = std::make_unique<contact::Interior>();
        in->strain_energy = state_;
        return in;
    }
    std::string write_state() const override {
        if (!with_state_) return {};
        std::string bytes(24, '\0');
        std::memcpy(bytes.data(), &state_, 8);
        std::memcpy(bytes.data() + 8, &least_, 8);
        std::memcpy(bytes.data() + 16, &path_, 8);
        return bytes;
    }
    void read_state(std::string_view bytes) override {
        ASSERT_EQ(bytes.size(), 24U);
        std::memcpy(&state_, bytes.data(), 8);
        std::memcpy(&least_, bytes.data() + 8, 8);
        std::memcpy(&path_, bytes.data() + 16, 8);
    }
    const contact::Audit& audit() const override { return audit_; }

  private:
    contact::StepRecord record(const contact::LoadStep& step) const {
        contact::StepRecord r;
        double k = 1;
        for (double* value : {&r.normal_force, &r.tangential_force[0], &r.tangential_force[1],
                              &r.indentation, &r.shift[0], &r.shift[1], &r.dissipation,
                              &r.contact_area, &r.stick_area, &r.slip_area, &r.open_area,
                              &r.normal_residual, &r.tangential_residual, &r.force_residual})
            *value = state_ / k++;
        r.phase = step.phase;
        r.offset = step.offset;
        r.normal_iterations = static_cast<int>(state_ * 1000);
        r.tangential_iterations = -r.normal_iterations;
        return r;
    }

    Count& count_;
    bool with_state_;
    double state_ = 0, least_ = 1e300, path_ = 0;
    contact::Audit audit_;
};

}  // namespace tricontact::io
