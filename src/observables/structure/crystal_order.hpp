#pragma once

#include <array>
#include <vector>

#include "core/schedule.hpp"
#include "ljmd/detail/observables/analysis.hpp"
#include "ljmd/observables/statistics/blocking.hpp"
#include "observables/structure/crystal_displacements.hpp"

namespace ljmd {

/// Static structure of a crystal that fills the box: displacements u of the atoms from its sites, and Bragg peaks at
/// its reciprocal lattice vectors G = 2 pi (h/a_x, k/a_y, l/a_z).
///
///     <u^2> = (1/N) sum_i u_i^2,   lindemann_ratio = (<u^2>/d^2)^(1/2),   d = distance of nearest neighbours
///     S(G) = <|sum_i exp(-i G.r_i)|^2>/N,   N for a crystal at rest
///     exp(-2 W) = <(1/N) sum_i cos(G.u_i)>^2,   the Debye-Waller factor
///     <u^2>_DW = -(6/G^2) ln <(1/N) sum_i cos(G.u_i)>,   from the shortest G
///
/// u is Gaussian in the harmonic crystal of classical mechanics, exp(-2 W) is exp(-G^2 <u^2>/3) then, and both <u^2>
/// are the same number, for any number of atoms: the sums hold u about the mean displacement. Their difference measures
/// the anharmonicity. |sum|^2/N^2 would be exp(-2 W) only up to terms of order 1/N. Averages are over all h k l that
/// symmetry makes equal (a family).
///
/// u is measured from the nearest site, see crystal_displacements.hpp. There is no value but the Bragg peak where S(G)
/// of the shortest G is below N/10: there is no such crystal then. With an edge unlike the others, and with a
/// barostat, cells are taken from the box of each configuration, and G is the mean over a family.
///
/// Standard errors by block averaging over the sampled configurations. Table `bragg`: k (= G) [1/sigma], miller_h,
/// miller_k, miller_l, vectors (G and -G count once), S, debye_waller_factor, debye_waller_gaussian
/// (exp(-G^2 <u^2>/3)), the last three each with its _standard_error. Observables: site_displacement [sigma^2],
/// site_displacement_debye_waller [sigma^2], lindemann_ratio, bragg_peak (S(G)/N of the shortest G), vacant_sites
/// (their share). Source: Ashcroft and Mermin (1976), appendix N; Lindemann (1910), Phys. Z. 11, 609; Hansen and Verlet
/// (1969), doi:10.1103/PhysRev.184.151, section V
class CrystalOrder : public Analysis {
  public:
    /// @param families  number of families, shortest vectors first, at least 1
    CrystalOrder(const CrystalInBox& crystal, Index families, Every every);

    [[nodiscard]] bool due(Index step) const override { return every_.due(step); }
    void sample(const State& state, const Evaluation& evaluation) override;
    [[nodiscard]] Index samples() const override { return means_.samples(); }
    [[nodiscard]] std::vector<DataTable> tables() const override;
    [[nodiscard]] std::vector<ObservableAverage> observables() const override;
    void archive(Archive& a) override { a(atoms_, means_); }

    /// Memory of the averages of so many samples [bytes].
    [[nodiscard]] static double bytes(Index families, Index samples);

  private:
    /// Reciprocal lattice vectors that symmetry makes equal.
    struct Family {
        Vec3 miller;                ///< h >= k >= l
        std::vector<Vec3> members;  ///< one of each pair G and -G
    };
    [[nodiscard]] static std::vector<Family> families_of(Lattice lattice, Index count);

    CrystalInBox crystal_;
    std::vector<Family> families_;
    Every every_;
    Index atoms_ = 0;            ///< of the last sample
    BlockingAccumulator means_;  ///< u^2, u^2/d^2, share of vacant sites; for each family G, <cos(G.u)>, S(G)
};

}  // namespace ljmd
