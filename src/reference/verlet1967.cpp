#include "reference/verlet1967.hpp"

namespace ljmd {

const std::vector<VerletRow>& verlet1967_table() {
    using enum Soundness;
    using enum Provenance;
    static const std::vector<VerletRow> table{
        {0.88, 1.095, Printed{3.48, suspect, one_reprint}, Printed{-5.66, suspect, two_reprints},
         "U as printed is 0.2 too high: other simulations and all equations of state agree on -5.86"},
        {0.88, 0.94, Printed{2.72, suspect, two_reprints}, Printed{-5.84, suspect, one_reprint},
         "U as printed is 0.2 too high: other simulations and all equations of state agree on -6.03"},
        {0.88, 0.591, Printed{-0.18, metastable, one_reprint}, Printed{-6.53, metastable, one_reprint},
         "below freezing: metastable, in part crystalline"},
        {0.85, 2.889, Printed{4.36, sound, one_reprint}, Printed{-4.25, sound, recalled},
         "one reprint has this row under 0.88, one pairs this temperature with the Z of 2.202: slips, as equations of "
         "state show"},
        {0.85, 2.202, Printed{4.2, sound, one_reprint}, Printed{-4.76, sound, one_reprint}, ""},
        {0.85, 1.214, Printed{3.06, sound, one_reprint}, Printed{-5.6, sound, recalled}, ""},
        {0.85, 1.128, Printed{2.78, sound, recalled}, Printed{-5.69, sound, recalled}, ""},
        {0.85, 0.88, Printed{1.64, sound, recalled}, Printed{-5.94, sound, recalled}, ""},
        {0.85, 0.782, Printed{0.98, sound, recalled}, Printed{-6.04, sound, recalled}, ""},
        {0.85, 0.786, Printed{0.99, sound, recalled}, Printed{-6.05, sound, recalled}, ""},
        {0.85, 0.76, Printed{0.78, sound, one_reprint}, Printed{-6.07, sound, recalled}, ""},
        {0.85, 0.719, Printed{0.36, sound, one_reprint}, Printed{-6.12, sound, recalled}, ""},
        {0.85, 0.658, Printed{-0.2, metastable, one_reprint}, Printed{-6.19, metastable, recalled},
         "below freezing: metastable"},
        {0.85, 0.591, Printed{-1.2, metastable, one_reprint}, Printed{-6.26, metastable, recalled},
         "below freezing: metastable"},
        {0.75, 2.849, Printed{3.1, sound, two_reprints}, Printed{-4.07, sound, recalled}, ""},
        {0.75, 1.304, Printed{1.61, sound, one_reprint}, Printed{-5.02, sound, recalled}, ""},
        {0.75, 1.069, Printed{0.9, sound, recalled}, Printed{-5.17, sound, recalled}, ""},
        {0.75, 1.071, Printed{0.89, sound, one_reprint}, Printed{-5.17, sound, recalled}, ""},
        {0.75, 0.881, Printed{-0.12, metastable, recalled}, Printed{-5.31, metastable, one_reprint},
         "negative pressure: metastable liquid"},
        {0.75, 0.827, Printed{-0.54, metastable, one_reprint}, Printed{-5.38, metastable, recalled},
         "negative pressure: metastable liquid"},
        {0.65, 2.557, Printed{2.14, sound, one_reprint}, Printed{-3.78, sound, recalled}, ""},
        {0.65, 1.585, Printed{1.25, sound, one_reprint}, Printed{-4.23, sound, recalled}, ""},
        {0.65, 1.036, Printed{-0.11, metastable, recalled}, Printed{-4.52, metastable, recalled},
         "between liquid and vapour: metastable"},
        {0.65, 0.9, Printed{-0.74, metastable, one_reprint}, Printed{-4.61, metastable, one_reprint},
         "between liquid and vapour: metastable"},
        {0.55, 2.645, Printed{1.63, sound, one_reprint}, {}, "known from one reprint, which has no U"},
        {0.5426, 3.26, Printed{1.86, suspect, recalled}, Printed{-3.0, sound, recalled},
         "Z is 0.07 too high, as in all rows of this density"},
        {0.5426, 1.404, Printed{0.57, suspect, recalled}, Printed{-3.63, sound, one_reprint},
         "Z is 0.08 too high, as in all rows of this density"},
        {0.5426, 1.326, Printed{0.42, suspect, one_reprint}, Printed{-3.66, sound, recalled},
         "Z is 0.07 too high, as in all rows of this density"},
        {0.5, 1.36, Printed{0.3, sound, recalled}, Printed{-3.38, sound, one_reprint}, ""},
        {0.45, 4.625, Printed{1.68, sound, one_reprint}, {}, "U is not known for certain"},
        {0.45, 2.935, Printed{1.38, sound, recalled}, Printed{-2.6, sound, recalled}, ""},
        {0.45, 1.744, Printed{0.74, sound, recalled}, Printed{-2.9, sound, one_reprint}, ""},
        {0.45, 1.71, Printed{0.74, sound, recalled}, Printed{-2.89, sound, recalled},
         "may be the row at 1.744 once more"},
        {0.45, 1.552, Printed{0.57, sound, recalled}, Printed{-2.98, sound, one_reprint},
         "one reprint has Z = 0.75: digits exchanged"},
        {0.4, 1.492, {}, Printed{-2.7, sound, recalled}, "Z is not known for certain"},
        {0.4, 1.462, Printed{0.41, sound, two_reprints}, Printed{-2.72, sound, one_reprint}, ""},
        {0.4, 1.424, Printed{0.38, sound, one_reprint}, Printed{-2.73, sound, recalled}, ""},
        {0.35, 1.62, Printed{0.58, sound, one_reprint}, Printed{-2.3, sound, recalled}, "U is not known for certain"},
        {0.35, 1.418, Printed{0.4, sound, one_reprint}, Printed{-2.21, suspect, one_reprint},
         "U is 0.22 too high, beyond any error: a misprint, or U without its tail"},
    };
    return table;
}

}  // namespace ljmd
