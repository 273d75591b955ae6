#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "experiments/records/experiment.h"
#include "experiments/records/experiment_evaluation.h"

namespace tricontact::tests {

/// A record with known truth: u_n = limit - transient q^n + increment n at the ends of periods,
/// between them a step near each turning point; a table that wobbles with the drive, a vibrometer
/// that drifts, makes noise, and rounds. Lengths in um, times in s; a drive of 1 mm/s.
struct SyntheticRecord {
    struct Stage {
        double amplitude = 1000;  ///< W
        int periods = 12;
        double limit = 100, transient = 40, ratio = 0.5, increment = 0;

        double shift(double n) const {
            return limit - transient * std::pow(ratio, n) + increment * n;
        }
        double period() const { return 4 * amplitude / 1000; }
    };

    std::vector<Stage> stages = std::vector<Stage>(1);
    double sampling = 0.05, rest_before = 30, rest_after = 10;
    double jitter = 0;    ///< of the times of samples, largest, over the sampling
    double unloaded = 0;  ///< before the load is applied; the shift then begins at `zero`
    double zero = 0;
    double noise = 0.05;
    double correlation = 0;  ///< of neighbouring samples' noise
    double drift = 0.002;    ///< um/s
    double wobble = 0.0015;  ///< dU/dW
    double resolution = 0.08;
    bool drive = true;

    static double triangle(double phase) {
        return phase < 0.25 ? 4 * phase : phase < 0.75 ? 2 - 4 * phase : 4 * phase - 4;
    }
    // Half of the way at each turning point.
    static double step(double phase) {
        const auto ramp = [](double x) { return x < 0 ? 0. : x > 1 ? 1. : x; };
        return 0.5 * ramp((phase - 0.15) / 0.2) + 0.5 * ramp((phase - 0.65) / 0.2);
    }

    experiments::Record make(std::mt19937_64& random) const {
        experiments::Record record{.name = "run.csv", .time = {}, .shift = {}, .drive = {}};
        std::normal_distribution<double> gauss;
        std::uniform_real_distribution<double> even(-jitter * sampling, jitter * sampling);
        double end = unloaded + rest_before + rest_after;
        for (const Stage& stage : stages) end += stage.periods * stage.period();
        double before = gauss(random);
        for (double regular = 0; regular < end; regular += sampling) {
            const double t = jitter > 0 ? regular + even(random) : regular;
            double u = 0, w = 0;
            truth(t, u, w);
            before =
                correlation * before + std::sqrt(1 - correlation * correlation) * gauss(random);
            u += zero + drift * t + wobble * w + noise * before;
            if (resolution > 0) u = resolution * std::round(u / resolution);
            record.time.push_back(t);
            record.shift.push_back(1e-6 * u);
            if (drive) record.drive.push_back(1e-6 * w);
        }
        return record;
    }

  private:
    void truth(double t, double& u, double& w) const {
        if (unloaded > 0 && t < unloaded) return;
        double begin = unloaded + rest_before;
        u = stages.front().shift(0);
        for (const Stage& stage : stages) {
            const double n = (t - begin) / stage.period();
            if (n < 0) return;
            if (n < stage.periods) {
                const double whole = std::floor(n);
                u = stage.shift(whole) +
                    (stage.shift(whole + 1) - stage.shift(whole)) * step(n - whole);
                w = stage.amplitude * triangle(n - whole);
                return;
            }
            u = stage.shift(stage.periods);
            begin += stage.periods * stage.period();
        }
    }
};

/// What is evaluated from one such record alone.
inline auto evaluated(const SyntheticRecord& synthetic, std::mt19937_64& random) {
    experiments::Experiment experiment;
    experiment.records = {synthetic.make(random)};
    return experiments::evaluate_experiment(experiment);
}

}  // namespace tricontact::tests
