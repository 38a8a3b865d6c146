#include "options/words_elsewhere.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace ljmd {

namespace {

struct Meaning {
    std::string_view words;  ///< normalized, with blanks around each
    std::string_view hint;
};

// A hint says what to write, or that there is nothing.
constexpr std::array meanings{
    // Ensembles
    Meaning{" nve microcanonical ", "constant energy: a stage without thermostat"},
    Meaning{" nvt canonical ", "constant temperature: thermostat = { type = \"stochastic-rescaling\" } in the stage"},
    Meaning{" npt nph isobaric isothermalisobaric ",
            "constant pressure: a thermostat, and barostat = { type = \"stochastic-cell-rescaling\", pressure = P, "
            "time = 2 } in the stage"},
    Meaning{" muvt grandcanonical ", "the number of atoms is constant in ljmd"},
    Meaning{" ensemble ",
            "it follows from 'thermostat' and 'barostat' of a stage; without them the energy is constant"},
    // Thermostats and barostats
    Meaning{" csvr bussi vrescale bussidonadioparrinello stochasticvelocityrescaling tempcsvr ",
            "it is called 'stochastic-rescaling' here"},
    Meaning{" berendsen ",
            "it samples no ensemble and is not in ljmd: 'stochastic-rescaling' is as gentle, and canonical; for "
            "pressure 'stochastic-cell-rescaling'"},
    Meaning{" nosehoover nose nhc ", "the thermostat is called 'nose-hoover-chain' here"},
    Meaning{" mttk mtk martynatobiasklein ",
            "the thermostat is called 'nose-hoover-chain' here; for pressure 'stochastic-cell-rescaling'"},
    Meaning{" crescale scr bernettibussi ", "it is called 'stochastic-cell-rescaling' here"},
    Meaning{" parrinellorahman montecarlobarostat andersenbarostat ",
            "not in ljmd; 'stochastic-cell-rescaling' samples the same ensemble"},
    Meaning{" baoab brownian ", "'langevin' is BAOAB"},
    Meaning{" tau taut taup tdamp pdamp damp tcoupl relaxationtime couplingtime ",
            "a relaxation time is called 'time' here, where there is one"},
    Meaning{" velocityrescale velocityrescaling temprescale ", "it is called 'rescale' here"},
    // Potentials
    Meaning{" mie lj96 buckingham yukawa ",
            "not in ljmd; a pair potential of one's own is a function, see docs/own-parts.md"},
    Meaning{" wca weekschandlerandersen ",
            "it is type = \"lennard-jones\", truncation = \"shifted\", cutoff = 1.122462048309373 (ljmd init wca)"},
    Meaning{" epsilon sigma ", "it is the unit; [argon] gives it in kelvin and angstrom"},
    Meaning{" lj ljcut lennardjones ", "it is called 'lennard-jones' here"},
    Meaning{" rcut rc rcutoff cutoffradius cutoffdistance ", "it is called 'cutoff' here"},
    Meaning{" shift shiftedpotential ", "it is called 'shifted' here"},
    Meaning{" shiftedforce ljsmoothlinear forceshift ", "it is called 'force-shifted' here"},
    Meaning{" switch switching xplor ", "it is called 'switched' here, with 'switch_start'"},
    // The start
    Meaning{" bcc hcp diamond ", "not in ljmd; such a start comes from a file: file = \"start.xyz\" in [system]"},
    Meaning{" sc cubic primitivecubic ", "it is called 'simple-cubic' here"},
    Meaning{" dimensions dimension dim ndim ", "there are three dimensions"},
    Meaning{" species types ntypes mixture components ", "there is one kind of atom in ljmd"},
    Meaning{" natoms nparticles particles numberofatoms npart ",
            "lattice = { type = \"fcc\", cells = C } has 4 C^3 atoms; { type = \"random\", atoms = N } any number"},
    Meaning{" box boxlength boxsize edge edges volume ", "the box follows from the atoms and 'density'"},
    Meaning{" mass ", "the unit of mass is the atom's; [argon] gives it in kg or u"},
    // Time
    Meaning{" dt timestep deltat ", "it is called 'time_step' here, in a stage"},
    Meaning{" nsteps nstep numsteps run ", "it is called 'steps' here, in a stage"},
    Meaning{" threads nthreads ", "an option of the command: ljmd run DECK --threads N"},
    // Analyses
    Meaning{" gr g(r) radialdistributionfunction radialdistribution paircorrelation ", "it is called 'rdf' here"},
    Meaning{" sk s(k) sq ", "it is called 'structure_factor' here"},
    Meaning{" meansquaredisplacement diffusion d ", "it is 'msd' (Einstein) and 'vacf' (Green and Kubo) here"},
    Meaning{" velocityautocorrelation velocityautocorrelationfunction vdos ", "it is called 'vacf' here"},
    Meaning{" intermediatescattering intermediatescatteringfunction isf fkt f(k,t) fskt selfintermediatescattering "
            "dynamicstructurefactor skw sqw currents ",
            "it is in 'scattering'"},
    Meaning{" nongaussian nongaussianparameter alpha2 ngp selfvanhove gs ", "it is in 'van_hove'"},
    Meaning{" steinhardt q6 bondorder bondorientationalorder voronoi commonneighbour cna ",
            "not in ljmd: freud and OVITO read its trajectories"},
    Meaning{" shearviscosity greenkubo stress ",
            "it is called 'viscosity' here; see also 'bulk_viscosity' and "
            "'thermal_conductivity'"},
    Meaning{" widom chemicalpotential mu ", "it is called 'chemical_potential' here"},
    Meaning{" heatcapacity cv isochoricheatcapacity ", "c_v is measured without being asked for"},
    Meaning{" response fluctuations compressibility thermalexpansion soundvelocity speedofsound ",
            "it is in 'response_functions'"},
    Meaning{" surfacetension densityprofile profile profiles pressureprofile ", "it is in 'film'"},
};

std::string normalized(const std::string& word) {
    std::string plain;
    for (const char c : word) {
        if (c != '-' && c != '_' && c != ' ' && c != '/') {
            plain.push_back(static_cast<char>(std::tolower(static_cast<unsigned char>(c))));
        }
    }
    return plain;
}

}  // namespace

std::string word_elsewhere(const std::string& word) {
    const std::string sought = " " + normalized(word) + " ";
    const auto found = std::ranges::find_if(
        meanings, [&](const Meaning& each) { return each.words.find(sought) != std::string_view::npos; });
    return sought == "  " || found == meanings.end() ? "" : std::string(found->hint);
}

}  // namespace ljmd
