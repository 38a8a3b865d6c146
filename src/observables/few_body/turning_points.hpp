#pragma once

#include <optional>
#include <vector>

#include "ljmd/core/types.hpp"
#include "ljmd/detail/core/archive.hpp"
#include "observables/few_body/sign_changes.hpp"
#include "observables/statistics/interval_mean.hpp"

namespace ljmd {

enum class Apsis { pericentre, apocentre };

/// Passage of a distance through an extreme.
struct Passage {
    Apsis kind;
    double time;
    double distance;
    double angle;         ///< continuous, see TurningPoints; NaN if the motion began on a line
    double path_in_step;  ///< speed times length of the step, as in Approach

    void archive(Archive& a) { a(kind, time, distance, angle, path_in_step); }
};

/// Apsides of an orbit (turning points of a radial motion) from samples of relative position r and velocity v.
///
/// An apsis is where r . v changes sign. Within a step r is the cubic Hermite polynomial through both samples, and the
/// apsis is the zero of r . dr/dt of that polynomial. For exact samples, distances are exact to O(h^4), times and
/// angles to O(h^3). A sample with |r . v| <= 1e-12 |r||v| is itself an apsis, so decks that begin at an apsis have it
/// as their first passage. A circle has no apsides. Steps must resolve the orbit: two apsides within a step are not
/// seen.
///
/// Angles lie in the plane perpendicular to the first sample's angular momentum r x v. They are counted from the first
/// position in the direction of motion, and continuously over several turns; a step may not turn by pi. An orbit that
/// leaves the plane is projected on it.
class TurningPoints {
  public:
    /// Add the next sample of an orbit. @throws ContractViolation unless time increases
    void add(double time, const Vec3& r, const Vec3& v);

    /// Add the next sample of a radial motion: distance rho > 0 and its rate. The caller provides a continuous angle
    /// and its rate, which are interpolated in the same way. The two kinds of samples cannot be mixed.
    /// @throws ContractViolation unless time increases
    void add_radial(double time, double rho, double rho_rate, double angle, double angle_rate);

    /// All passages so far, in order of time. A passage exactly at a sample is reported with the next sample.
    [[nodiscard]] const std::vector<Passage>& passages() const { return passages_; }

    /// Mean time between successive passages of one kind, pericentres or apocentres: the kind whose mean is better
    /// known (better_known(); apocentres if both are equal, as the motion is slowest there). Empty if neither kind has
    /// two passages.
    [[nodiscard]] std::optional<IntervalMean> period() const;

    /// Mean angle between successive passages of one kind, minus 2 pi [rad/orbit], for the kind that is better known.
    /// Positive if the apsides turn in the direction of motion. Empty as for period(), and if no angle is swept.
    [[nodiscard]] std::optional<IntervalMean> precession() const;

    /// @param now  time from which sampling continues  @throws CheckpointError for samples of later times
    void archive(Archive& a, double now);

  private:
    struct Sample {
        double time;
        Vec3 r;
        Vec3 v;
        double angle;
        std::optional<double> angle_rate;  // for radial motion

        void archive(Archive& a) { a(time, r, v, angle, angle_rate); }
    };

    void add(const Sample& now);
    void set_plane(const Vec3& r, const Vec3& v);
    [[nodiscard]] double angle_of(const Vec3& r, double nearby) const;
    [[nodiscard]] Passage passage_within_step(Apsis kind, const Sample& now) const;
    [[nodiscard]] std::optional<IntervalMean> mean_over_kinds(double Passage::*mark) const;

    std::optional<Sample> last_;
    SignChanges changes_;
    Vec3 axis_ = Vec3::Zero();     // unit vector along the first position
    Vec3 forward_ = Vec3::Zero();  // unit vector perpendicular to it, in the direction of motion
    std::vector<Passage> passages_;
};

}  // namespace ljmd
