// SPDX-License-Identifier: BSD-3-Clause
#include "commands/commands.hpp"

namespace fstiff::cli {

namespace {

constexpr CommandRow rows[] = {
    {"run", "Compute", "Stiffness, separation and real area of a scene against pressure",
     R"(A scene describes the contact; run --example > joint.toml writes one to edit. Exit code 4: a real area above
the nominal one, no convergence, a point that a law does not reach, or a measured parameter that is not
known to a factor of two.)",
     R"(  fstiff run --example > joint.toml
  fstiff run joint.toml
  fstiff generate profile --points 8192 --spacing "0.5 um" --hurst 0.8 --rms "1 um" | fstiff run --surface -)",
     add_run},
    {"sweep", "Compute", "Many scenes: ranges, lists and distributions in one scene file",
     R"(A swept quantity is { from, to, count, spacing }, a list, { values = [...] }, or a distribution such as
{ normal = ["5 um", "0.2 um"] }. Exit code 4: some scenes cannot be computed; their lines give the reason.)",
     "  fstiff sweep --example > grid.toml; fstiff sweep grid.toml -o results.jsonl", add_sweep},
    {"export", "Compute", "The law of a scene as the contact law of a finite-element program", "",
     "  fstiff export --to calculix --units mm,N,MPa --tolerance 1%", add_export},
    {"ultrasound", "Compute", "Ultrasonic reflection from the stiffness of an interface, or back",
     R"(A file names its columns and their units: pressure [MPa], frequency [MHz], reflection, reflection_error,
phase [deg]; pressure or frequency alone will do. Of several frequencies K is that of all of them, and must not
depend on them. For shear waves give --wave shear, or their impedances; the stiffness is then the tangential
one. Exit code 4: some rows have an R that belongs to no stiffness, K depends on the frequency or scatters by
more than its errors, or the phase contradicts it.)",
     R"(  fstiff ultrasound --stiffness "1.764 GPa/um" --frequency "7 MHz" --material steel
  printf 'f [MHz],R,error\n2,0.7,0.005\n5,0.92,0.005\n10,0.98,0.005\n' |
      fstiff ultrasound --reflection - --material steel)",
     add_ultrasound},
    {"measure", "Surfaces", "Every parameter of a scene's surface from a measured profile or map, with errors",
     R"(All waves except the form count for a contact, so lambda_c is none unless it is given. The form is what a
drawing calls form. The table and the JSON also have the roughness parameters of drawings, with the
cut-offs of their standard: ISO 21920-2 (Ra, Rq, Rz ... of a profile) or ISO 25178-2 (Sa, Sq, Sk ... of a
map). The JSON is the input of run --surface and of [surface] from = "..." in a scene. Exit code 4: a
parameter is not known to a factor of two, or the island density of a map has no maximum. The example
makes a random walk.)",
     R"(  awk 'BEGIN { srand(1); for (i = 0; i < 4096; ++i) print z += rand() - 0.5 }' |
      fstiff measure - --spacing "0.5 um" --units um | fstiff run --surface -)",
     add_measure},
    {"generate", "Surfaces", "Profiles and maps of known D or H, as files to read back",
     "The first line of the CSV has the parameters and the seed; for SDF they go to standard error.",
     R"(  fstiff generate profile --points 8192 --spacing "0.5 um" --hurst 0.5 --rms "1 um" |
      fstiff measure --show fit -)",
     add_generate},
    {"identify", "Measured K", "Parameters of a scene from a measured stiffness or reflection against pressure",
     R"(The measured file begins with its columns and their units: pressure [MPa], stiffness [GPa/um],
stiffness_error [GPa/um]. Without --law each law in contact.laws is fitted; if there are none, plastic if
the peaks yield, else hybrid. g is the rms gradient; where it or alpha is fitted, R and Dp follow. Exit
code 4: the data cannot distinguish the parameters or determine one within a factor of 100, the fit does
not converge, no law describes the points, a point is an outlier, a parameter is 30 times its starting
value, or an elastic law is fitted to peaks that yield. K in the example is that of boundary elements.)",
     R"(  printf 'pressure [MPa],stiffness [MPa/um],error [MPa/um]\n5,100,10\n30,559,56\n100,1860,186\n' |
      fstiff identify --measured - --law plastic --fit sigma)",
     add_identify},
    {"truth", "Checks", "Stiffness of a measured map by boundary elements on the map itself",
     R"(The error of K is its difference from a grid half as fine. Exit code 4: it is above a fifth of K, there is
no convergence, or all points of the map are in contact at some pressures, so that there is no K.)",
     R"(  fstiff generate map --hurst 0.8 --rms "1 um" --spacing "1 um" | fstiff truth - --pressures "10 MPa")",
     add_truth},
    {"formats", "Help", "File formats: how they are recognised and which options they need", "", "  fstiff formats",
     add_formats},
    {"measure --show fit", "", "Fractal dimension D and roughness G of a measured profile or map, with errors",
     "The CSV is the structure function; the JSON holds everything. The example makes a random walk, D = 1.5.",
     R"(  awk 'BEGIN { srand(1); for (i = 0; i < 4096; ++i) print z += rand() - 0.5 }' |
      fstiff measure --show fit - --spacing "0.5 um" --units um)",
     add_fit},
    {"measure --show islands", "", "Islands of a map at every cutting level, and peak radius R and density D_p",
     R"(The CSV is the curve; the JSON holds everything. R = A_m/(2 pi h_m) of the mean island at the level with
the most islands.)",
     R"(  fstiff generate map --points 512 --spacing "0.5 um" --hurst 0.8 --rms "1 um" \
      --shortest "8 um" --longest "32 um" |
      fstiff measure --show islands -)",
     add_islands},
    {"measure --show spectrum", "", "Power spectral density or autocorrelation of a measured profile or map",
     "For a map: C(q) over all directions, and the mean of its sections along x and along y. The CSV holds every "
     "value.",
     R"(  fstiff generate map --points 256 --spacing "0.5 um" --hurst 0.8 --rms "1 um" --shortest "4 um" |
      fstiff measure --show spectrum -)",
     add_spectrum},
};

}  // namespace

std::span<const CommandRow> commands() { return rows; }

}  // namespace fstiff::cli
