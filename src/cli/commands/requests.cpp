// SPDX-License-Identifier: BSD-3-Clause
// The commands that are a request: their options, and the document that answers.
#include "actions/export.hpp"
#include "actions/fractal.hpp"
#include "actions/generate.hpp"
#include "actions/identify.hpp"
#include "actions/islands.hpp"
#include "actions/spectrum.hpp"
#include "actions/truth.hpp"
#include "commands/commands.hpp"
#include "input/output_options.hpp"
#include "input/progress.hpp"

#include <fstiff/asperity/material.hpp>
#include <fstiff/io/quantities.hpp>

#include <memory>

namespace fstiff::cli {
namespace {

/// What a command of a request is given.
template <class Request>
struct Given {
    OutputOptions output{};
    SceneOptions scene{};
    Request request{};

    [[nodiscard]] Report report(const document::Document& document) const {
        return cli::report(document, output.format);
    }
};

template <class Request>
Report answered(const Given<Request>& given) {
    return given.report(actions::document_of(given.request));
}

/// A command: \p add adds its options, and \p answer is called with what was given.
template <class Request, class Add>
Command request_command(Arguments& command, const Add& add, Report (*answer)(const Given<Request>&) = answered,
                        bool is_file = false) {
    const auto given = std::make_shared<Given<Request>>();
    if constexpr (requires { given->request.prefix; }) given->request.prefix = "--";
    add(*given);
    given->output.format = document::Format::csv;  // that of a file
    is_file ? add_output_option(command, given->output) : add_output_options(command, given->output);
    return {&given->output, [given, answer] {
                Given<Request> own = *given;
                if constexpr (requires { own.request.progress; }) own.request.progress = progress_bar();
                return answer(own);
            }};
}

constexpr const char* profile_or_map = "profile or map, as fstiff formats lists them; - is standard input";

/// What is solved, as text; the request has the numbers.
struct TruthTexts : actions::TruthRequest {
    std::string scene{}, at{}, effective_modulus{}, cut{};
};

std::vector<double> pressures_of(const std::string& list) {
    std::vector<double> pressures;
    for (const std::string& part : surface::split_at_commas(list)) {
        if (part.find_first_not_of("0123456789+-.eE ") == std::string::npos)
            throw domain_error("--pressures = \"" + list +
                               "\": every pressure needs its unit, and the point as decimal mark");
        pressures.push_back(document::parse_positive(part, io::Dimension::pressure, "--pressures"));
    }
    return pressures;
}

actions::TruthRequest numbers_of(const TruthTexts& texts) {
    const scene::Scene scene = read_scene(SceneOptions{texts.scene, ""});
    const auto positive = [](const std::string& text, const char* name) {
        return document::parse_positive(text, io::Dimension::pressure, name);
    };
    actions::TruthRequest request = texts;
    request.modulus = texts.effective_modulus.empty() ? effective_modulus(scene.joint.upper, scene.joint.lower)
                                                      : positive(texts.effective_modulus, "--modulus");
    if (texts.at.empty() && scene.at_separations)
        throw domain_error("the scene has separations; must have contact.pressures, or --pressures must be given");
    request.pressures = texts.at.empty() ? scene.points : pressures_of(texts.at);
    if (!texts.cut.empty()) {
        request.hardness = io::parse_quantity(texts.cut, io::Dimension::pressure, "--hardness");
        detail::require_positive("--hardness", request.hardness);
    }
    if (texts.effective_modulus.empty())  // else the bodies are not those of the scene
        request.known_hardness = scene.joint.hardness ? *scene.joint.hardness
                                 : scene.joint.yield_strength
                                     ? detail::hardness_over_yield_strength<double> * *scene.joint.yield_strength
                                     : 0;
    return request;
}

}  // namespace

Command add_fit(Arguments& command) {
    return request_command<actions::FractalOptions>(command, [&](auto& given) {
        command.option("profile", given.request.surface.file, {.help = profile_or_map, .required = true});
        add_surface_options(command, given.request.surface);
        for (const char* key : {"window", "tip_radius", "resolution"})
            add_surface_option(command, given.request.surface, key);
        command.fields(given.request);
    });
}

Command add_islands(Arguments& command) {
    return request_command<actions::IslandsRequest>(command, [&](auto& given) {
        command.option("map", given.request.surface.file,
                       {.help = "map, as fstiff formats lists them; - is standard input", .required = true});
        add_surface_options(command, given.request.surface, surface::SurfaceKind::map);
        command.fields(given.request);
    });
}

Command add_spectrum(Arguments& command) {
    const auto add = [&](auto& given) {
        command.option("file", given.request.surface.file, {.help = profile_or_map, .required = true});
        command.fields(given.request);
        add_surface_options(command, given.request.surface);
    };
    return request_command<actions::SpectrumRequest>(command, add);
}

Command add_generate(Arguments& command) {
    return request_command<actions::GenerateRequest>(
        command, [&](auto& given) { command.fields(given.request); }, answered, true);
}

Command add_identify(Arguments& command) {
    const auto add = [&](auto& given) {
        add_scene_options(command, given.scene,
                          "scene file (TOML) with the starting values; - is standard input; without it the fine "
                          "sand-blasted surface of the paper");
        command.fields(given.request);
    };
    const auto answer = [](const Given<actions::IdentifyRequest>& given) {
        if (given.scene.scene == "-" && given.request.measured == "-")
            throw Usage("the scene and --measured are both standard input; one of them must be a file");
        (void)actions::parameters_of(given.request);  // their errors are reported before the scene is read
        const scene::Scene scene = read_scene(given.scene);
        return given.report(actions::document_of(scene, actions::identify_scene(scene, given.request)));
    };
    return request_command<actions::IdentifyRequest>(command, add, answer);
}

Command add_export(Arguments& command) {
    const auto add = [&](auto& given) {
        add_scene_options(
            command, given.scene,
            "scene file (TOML); - is standard input; without it the fine sand-blasted surface of the paper",
            "profile, map, or JSON of fstiff measure, in place of the scene's [surface]; - is standard input");
        command.fields(given.request);
    };
    const auto answer = [](const Given<actions::ExportRequest>& given) {
        actions::check(given.request);  // its errors are reported before the scene is read
        return given.report(actions::document_of(read_scene(given.scene), given.request));
    };
    return request_command<actions::ExportRequest>(command, add, answer, true);
}

Command add_truth(Arguments& command) {
    const auto add = [&](auto& given) {
        TruthTexts& request = given.request;
        command.option("file", request.surface.file,
                       {.help = "map of any form; - is standard input", .required = true});
        add_surface_options(command, request.surface);
        command.option("--scene", request.scene,
                       {.help = "scene that gives material and pressures; the default is the built-in scene"});
        command.option("--pressures", request.at, {.help = "nominal pressures instead, such as \"1 MPa,10 MPa\""});
        command.option("--modulus", request.effective_modulus,
                       {.help = "effective modulus instead of that of the material"});
        command.option("--hardness", request.cut,
                       {.help = "hardness at which pressures are cut; the default is elastic"});
        command.fields(request);
    };
    const auto answer = [](const Given<TruthTexts>& given) {
        return given.report(actions::document_of(numbers_of(given.request)));
    };
    return request_command<TruthTexts>(command, add, answer);
}

}  // namespace fstiff::cli
