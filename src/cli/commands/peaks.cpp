// SPDX-License-Identifier: BSD-3-Clause
// fstiff measure --show peaks: the density of peak heights and curvatures, its moments and its height marginal.
#include "commands/commands.hpp"
#include "document/document.hpp"
#include "document/shown_unit.hpp"
#include "input/surface_options.hpp"
#include "surface/peak_density.hpp"

#include <fstiff/core/version.hpp>

#include <memory>

namespace fstiff::cli {
namespace peaks_command {
namespace {

struct Options {
    OutputOptions output;
    PeakDensityRequest request;
};

std::string table(const PeakDensityRequest& request, const PeakDensity& source) {
    const auto& p = source.density;
    std::string text = "fstiff " FSTIFF_VERSION_TEXT ": peak density (4.4) from " + source.from;
    if (source.input) {
        text += " " + shown_name(request.surface.file) + "\n" + source_lines(*source.input, "  file              ");
        text += "  form removed      " + form_name(*source.levelled) + "; Rq " +
                shown_length(source.levelled->rms_as_read) + " before, " + shown_length(source.levelled->rms) +
                " after";
        if (source.levelled->cut_offs.any()) text += "; " + sentence_of(source.levelled->cut_offs);
    }
    text += "\n  r, theta          " + rounded(p.r(), 6) + ", " + rounded(p.theta(), 6) + " rad\n";
    text += "  peaks/ordinates   " + rounded(p.peak_ratio(), 6) + " (4.3)";
    if (const auto& s = source.statistics) text += ", counted " + rounded(s->counted_peak_ratio, 6);
    text += "\n  peak height       mean " + rounded(p.mean_height()) + ", variance " + rounded(p.height_variance()) +
            ", skewness " + rounded(p.height_skewness()) + ", kurtosis " + rounded(p.height_kurtosis(), 6) +
            " (in rms heights)\n";
    text += "  peak curvature    E t^n, n = 1 to 4: ";
    for (int n = 1; n <= 4; ++n) text += (n > 1 ? ", " : "") + rounded(p.curvature_moment(n), 6);
    text += " (in rms curvatures)\n";
    if (const auto& s = source.statistics) {
        text += "  ordinates         rms height " + shown_length(s->rms_height) + ", rms slope " +
                rounded(s->rms_slope) + ", rms curvature " + rounded(s->rms_curvature * 1e-6) + " /µm, rho1 " +
                rounded(s->rho1, 6) + ", rho2 " + rounded(s->rho2, 6) + "\n";
    }
    if (!source.heights.empty()) text += "\n" + rows_of(source).text();
    return text;
}

Report execute(const Options& options) {
    const PeakDensityRequest& request = options.request;
    const PeakDensity found = peak_density_of(request);
    return report(
        answer_of(request, found), [&] { return table(request, found); },
        [&] { return found.heights.empty() ? csv(moments_of(found)) : rows_of(found).csv(); }, options.output.format);
}

}  // namespace
}  // namespace peaks_command

Command add_peaks(Arguments& command) {
    using namespace peaks_command;
    auto options = std::make_shared<Options>();
    PeakDensityRequest& request = options->request;
    request.profile = "--profile";
    command.fields(request);
    command.option("profile,--profile", request.surface.file,
                   {"measured profile, as fstiff formats lists them; - is standard input"});
    add_surface_options(command, request.surface, SurfaceKind::profile);
    add_output_options(command, options->output);
    return {&options->output, [options] { return execute(*options); }};
}

}  // namespace fstiff::cli
