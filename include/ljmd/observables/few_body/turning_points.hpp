#pragma once

#include <optional>
#include <vector>

#include "ljmd/core/archive.hpp"
#include "ljmd/core/types.hpp"
#include "ljmd/observables/few_body/sign_changes.hpp"
#include "ljmd/observables/statistics/interval_mean.hpp"

namespace ljmd {

enum class Apsis { pericentre, apocentre };

/// One passage of a distance through an extreme.
struct Passage {
    Apsis kind;
    double time;
    double distance;
    double angle;  ///< unwrapped, see TurningPoints; NaN when the motion began on a line

    void archive(Archive& a) { a(kind, time, distance, angle); }
};

/// Apsides of an orbit (turning points of a radial motion) from samples of a relative position r and velocity v.
///
/// An apsis is where r . v changes sign. Within the step r is the cubic Hermite polynomial through both samples, and
/// the apsis is where r . dr/dt of that polynomial is zero: distances are exact to O(h^4), times and angles to O(h^3),
/// for exact samples. A sample with |r . v| <= 1e-12 |r||v| is at an apsis itself; so decks that begin at an apsis have
/// it as their first passage. A circle has no apsides. Steps must resolve the orbit: two apsides within a step are
/// not seen.
///
/// Angles lie in the plane of the first sample's angular momentum r x v. They are counted from the first position in
/// the direction of motion, whichever way it goes, on through the turns; a step may not turn by pi. An orbit that
/// leaves that plane is projected on it.
class TurningPoints {
  public:
    /// The next sample of an orbit. @throws ContractViolation unless time increases
    void add(double time, const Vec3& r, const Vec3& v);

    /// The next sample of a radial motion: distance rho > 0 and its rate; angle, unwrapped, and its rate are the
    /// caller's and are interpolated in the same way. A series is made of samples of one sort.
    /// @throws ContractViolation unless time increases
    void add_radial(double time, double rho, double rho_rate, double angle, double angle_rate);

    /// All passages so far, in time. One exactly at a sample is told with the next sample.
    [[nodiscard]] const std::vector<Passage>& passages() const { return passages_; }

    /// Mean time between successive like passages, of pericentres or of apocentres: of the kind whose mean is the
    /// better known (better_known(); apocentres where both are equal, as the motion is slowest there). Empty when there
    /// are fewer than two passages of either kind.
    [[nodiscard]] std::optional<IntervalMean> period() const;

    /// Mean of (angle from one passage to the next like one) - 2 pi [rad/orbit], of the kind that is the better known.
    /// Positive when the apsides turn in the direction of motion. Empty as for period(), and when no angle is swept.
    [[nodiscard]] std::optional<IntervalMean> precession() const;

    /// @param now  from which samples go on  @throws CheckpointError for samples of later times
    void archive(Archive& a, double now);

  private:
    struct Sample {
        double time;
        Vec3 r;
        Vec3 v;
        double angle;
        std::optional<double> angle_rate;  // of a radial motion

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
    Vec3 forward_ = Vec3::Zero();  // unit vector across it, in the direction of motion
    std::vector<Passage> passages_;
};

}  // namespace ljmd
