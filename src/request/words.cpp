// SPDX-License-Identifier: BSD-3-Clause
#include "request/words.hpp"

#include "document/file.hpp"
#include "io/lines.hpp"
#include "io/number.hpp"

#include <fstiff/asperity/named_materials.hpp>
#include <fstiff/core/names.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace fstiff::request {
namespace {

/// Words with commas between them, and what they mean.
struct Row {
    std::string_view meaning, words;
};

/// Keys and their synonyms in the field; of one letter or two, capitals count.
constexpr Row synonyms[] = {
    {"rms_height", "sigma,rms,rms_roughness,roughness_rms,height,standard_deviation,stdev,Rms_surface_height"},
    {"Ra",
     "CLA,AA,roughness,mean_roughness,average_roughness,arithmetic_mean,arithmetic_average,mean_height,Rauheit,"
     "Mittenrauwert,Ra_um"},
    {"rms_gradient", "slope,rms_slope,slope_rms,gradient,gradient_rms,mean_slope,rms_surface_gradient,Rq_slope"},
    {"RSm", "Sm,mean_spacing,profile_spacing,mean_width"},
    {"alpha", "bandwidth,Nayak,Nayak_parameter"},
    {"hurst", "H,hurst_exponent,roughness_exponent"},
    {"fractal_dimension", "D,Df,dimension"},
    {"fractal_roughness", "G"},
    {"peak_radius", "R,beta,radius,summit_radius,asperity_radius"},
    {"peak_density", "Dp,D_p,Spd,Sds,summit_density,asperity_density,density_of_peaks"},
    {"max_peak_height", "Sp,Rp,highest_peak"},
    {"skewness", "skew"},
    {"kurtosis", "kurt"},
    {"bearing_curve", "abbott,abbott_curve,bearing,material_ratio,material_ratio_curve"},
    {"process",
     "finish,finishing,surface_finish,machining,manufacturing,manufacturing_process,method,Verfahren,"
     "Bearbeitung"},
    {"from", "file,path,filename,trace,profile,map,measured"},
    {"errors", "error,standard_errors,uncertainty"},
    {"nominal_area", "A,A0,area,contact_area,apparent_area,Flaeche"},
    {"pressures", "p,nominal_pressure,contact_pressure,mean_pressure,normal_pressure,Druck"},
    {"force", "F,load,loads,normal_force,normal_load,forces,Kraft"},
    {"separations", "d,gaps,distances"},
    {"ball_radius", "ball,ball_diameter,sphere,sphere_radius,sphere_diameter,radius,diameter"},
    {"washer", "ring,annulus"},
    {"laws", "model,models"},
    {"youngs_modulus", "E,young,youngs,modulus,elastic_modulus,young_modulus,youngsmodulus,E_modulus,Emodul"},
    {"poisson_ratio", "nu,v,poisson,poissons_ratio,Querkontraktionszahl"},
    {"yield_strength", "Rp0,Rp02,Rp0_2,Re,ReH,yield,yield_stress,yield_point,proof_stress,sigma_y,Streckgrenze"},
    {"hardness", "H,HV,HB,HBW,HRC,Vickers,Brinell,Rockwell,Haerte"},
    {"thermal_conductivity", "k,lambda,conductivity"},
    {"electrical_conductivity", "electric_conductivity"},
    {"name", "material,grade,alloy"},
    {"upper", "top,first,body1,body,body_1,material_1"},
    {"lower", "bottom,second,body2,body_2,material_2,counterface,counterbody"},
    {"frequency", "f,freq"},
    {"impedance", "Z,acoustic_impedance"},
    {"velocity", "c,speed,speed_of_sound,sound_speed,sound_velocity"},
    {"density", "rho"},
    {"coefficient", "mu,friction,friction_coefficient,coefficient_of_friction"},
    {"amplitude", "slip,displacement"},
    {"surface", "face,roughness"},
    {"material", "bodies"},
    {"contact", "load,loading"},
};

/// What the model has not, or has elsewhere; a part of a key between "_" counts too.
constexpr Row outside[] = {
    {"the model has no temperature; give youngs_modulus and hardness at the working temperature (docs/trust.md)",
     "temperature,temp,Temperatur"},
    {"a film of liquid adds its stiffness B/d to K of the solids, which fstiff computes (docs/worn-and-lubricated.md)",
     "lubricant,lubrication,lubricated,lubricating,oil,grease,viscosity,liquid,fluid,film,Schmierung,Schmierstoff"},
    {"the model has no layers; give the numbers of the layer as those of the body where it is much thicker than the "
     "contacts are wide, else those of what is below it (docs/trust.md)",
     "coating,coatings,coated,layer,layers,plating,paint,oxide,Beschichtung"},
    {"a bolt enters by its preload: give contact.force, with contact.bolt, contact.washer or contact.nominal_area "
     "(docs/bolted-joint.md)",
     "bolt,bolts,screw,torque,preload,pretension,clamping,tightening,Schraube,Vorspannkraft,Drehmoment"},
    {"a cylinder is outside of the model, which has flat faces and a ball; export gives the law of the face to a "
     "finite-element model of the cylinder (docs/finite_elements.md)",
     "cylinder,cylinders,cylindrical,roller,shaft,pin,line_contact,Zylinder,Welle"},
    {"damping by slip is the loss factor of the section [friction], with coefficient and amplitude (docs/friction.md)",
     "damping,damper,damp,dissipation,loss,Daempfung"},
    {"friction is a section of its own, [friction] with coefficient (docs/friction.md)", "friction,mu,Reibung"},
    {"the model has no adhesion, which soft and very smooth bodies have (docs/trust.md)",
     "adhesion,adhesive,surface_energy,JKR,DMT"},
    {"faces that are not flat have contact.flatness, or a map of the gap as contact.form; tilt is not in the model "
     "(docs/bolted-joint.md)",
     "waviness,flatness,misalignment,tilt,Welligkeit,Ebenheit"},
    {"the model has no time: neither creep nor viscosity (docs/trust.md)",
     "creep,viscoelastic,viscoelasticity,relaxation,time,rate,strain_rate"},
    {"wear is not modelled; measure the face in the state in which it works (docs/worn-and-lubricated.md)",
     "wear,worn,cycles,running_in,Verschleiss"},
    {"what fills the gap is the section [gap] (docs/heat-and-current.md)", "gas,air,vacuum,medium,thermal,electrical"},
    {"waves are the section [ultrasound], with frequency (docs/ultrasound.md)",
     "ultrasound,ultrasonic,frequency,impedance,wave,waves"},
    {"K is that of the interface, without the bodies; add the stiffness of these (docs/bolted-joint.md)",
     "thickness,plate,Dicke"},
    {"a grade of ISO 1302 or a class of VDI 3400 is written as Ra = \"N6\" or Ra = \"VDI 24\" (docs/inputs.md)",
     "vdi,N,grade,roughness_grade,iso_grade,roughness_class,Rauheitsklasse"},
};

/// Keys that some write above the first section, and the section that takes them.
constexpr Row sections[] = {
    {"surface",
     "Ra,Rq,Sa,Sq,Rz,RSm,Rdq,Sdq,rms_height,mean_height,rms_gradient,process,peak_radius,peak_density,hurst,alpha"},
    {"contact", "pressures,pressure,force,nominal_area,washer,flatness,form,ball_radius,separations,laws"},
    {"material", "upper,lower"},
    {"material.upper", "youngs_modulus,poisson_ratio,hardness,yield_strength"},
};

bool has_word(std::string_view words, std::string_view word) {
    while (!words.empty()) {
        const std::size_t end = std::min(words.find(','), words.size());
        const std::string_view known = words.substr(0, end);
        if (word == known || (word.size() > 2 && detail::is_same_name(word, known))) return true;
        words.remove_prefix(std::min(end + 1, words.size()));
    }
    return false;
}

std::string_view synonym_of(std::string_view wrong, std::span<const std::string_view> valid) {
    for (const Row& row : synonyms)
        if (std::find(valid.begin(), valid.end(), row.meaning) != valid.end() && has_word(row.words, wrong))
            return row.meaning;
    return {};
}

}  // namespace

std::string_view meant_key(std::string_view wrong, std::span<const std::string_view> valid) {
    const std::string_view synonym = synonym_of(wrong, valid);
    if (wrong.size() == 1 && !synonym.empty()) return synonym;  // R is a radius, and not r in another capital
    for (const std::string_view key : valid)
        if (detail::is_same_name(wrong, key)) return key;
    if (!synonym.empty()) return synonym;
    return outside_of_model(wrong).empty() ? document::nearest_word(wrong, valid) : std::string_view();
}

std::string_view outside_of_model(std::string_view key) {
    for (const Row& row : outside) {
        if (has_word(row.words, key)) return row.meaning;
        for (std::string_view rest = key; !rest.empty() && key.find('_') != key.npos;) {
            const std::size_t end = std::min(rest.find('_'), rest.size());
            if (end > 2 && has_word(row.words, rest.substr(0, end))) return row.meaning;
            rest.remove_prefix(std::min(end + 1, rest.size()));
        }
    }
    return {};
}

std::string unknown_key(std::string_view wrong, std::string_view path, std::span<const std::string_view> valid) {
    const std::string_view meant = meant_key(wrong, valid), outside = outside_of_model(wrong);
    for (const Row& row : sections)
        if (path.empty() && has_word(row.words, wrong) && std::count(valid.begin(), valid.end(), "surface") > 0)
            return "is a key of a section; write it below a line [" + std::string(row.meaning) + "]";
    if (meant.empty() && !outside.empty()) return "unknown key; " + std::string(outside);
    return "unknown key" + (meant.empty() ? "" : " (did you mean " + std::string(meant) + "?)") + "; valid keys" +
           (path.empty() ? "" : " of " + std::string(path)) + " are " + document::list_of(valid);
}

std::string unknown_material(std::string_view name, std::string_view other) {
    const std::vector<std::string_view> near = detail::near_materials(name);
    if (!near.empty())
        return "is not a known material; did you mean " + document::list_of(near) + "? Or give " + std::string(other);
    std::vector<std::string_view> names;
    for (const NamedMaterial& material : detail::named_materials) names.push_back(material.name);
    return "is not a known material" + document::suggestion(name, {names.begin(), names.end()}) +
           "; fstiff help materials lists those; give one of them, or " + std::string(other);
}

std::optional<double> mean_height_of_grade(std::string_view text) {
    text = io::detail::trimmed(text);
    const auto number = [](std::string_view digits) -> std::optional<double> {
        const auto read = io::detail::leading_number(digits);
        const bool is_number = !digits.empty() && read.length == digits.size() &&
                               read.status == io::detail::NumberStatus::ok && detail::is_decimal_digit(digits[0]);
        return is_number ? std::optional(read.value) : std::nullopt;
    };
    const auto after = [](std::string_view whole, std::string_view word) {
        return whole.size() > word.size() && detail::is_same_name(whole.substr(0, word.size()), word)
                   ? io::detail::trimmed(whole.substr(word.size()))
                   : std::string_view();
    };
    if (const auto grade = number(after(text, "N"))) {
        constexpr double heights[]{0.025e-6, 0.05e-6, 0.1e-6, 0.2e-6,  0.4e-6, 0.8e-6,
                                   1.6e-6,   3.2e-6,  6.3e-6, 12.5e-6, 25e-6,  50e-6};  // ISO 1302:1992
        if (*grade != std::floor(*grade) || *grade < 1 || *grade > 12) return std::nullopt;
        return heights[static_cast<std::size_t>(*grade) - 1];
    }
    std::string_view rest = after(text, "VDI");
    for (const char* word : {"3400", "class", "Ref", "Klasse"})
        if (const std::string_view next = after(rest, word); !next.empty()) rest = next;
    if (const auto vdi_class = number(rest); vdi_class && *vdi_class <= 45) return std::pow(10, *vdi_class / 20) * 1e-7;
    return std::nullopt;
}

}  // namespace fstiff::request
