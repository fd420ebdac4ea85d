// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The words that instruments and programs write above a map in other languages than English.
///
/// Words may be in UTF-8 or in any 8-bit code page: there, one byte of 128 and more is each letter that is not
/// ASCII, whichever page it is of. Only words that also have ASCII letters are known so, for others would fit one
/// another.
///
/// Reference   Gwyddion's export of text in the languages of its interface, as SurfaceTopography (MIT licence) lists
///             them; the height export of Keyence's VK and VR programs, as open converters list its words in English,
///             German and Korean
/// Valid       keys in lower case as far as they are ASCII

#include "io/number.hpp"

#include <array>

namespace fstiff::inline v0_1::io::detail {

// "Width: 10 um" of Gwyddion: Czech, German, Spanish, French, Italian, Japanese, Korean, Portuguese, Russian
inline constexpr std::array<std::string_view, 10> width_words{"\xC5\xA0\xC3\xAD\xC5\x99ka",
                                                              "breite",
                                                              "anchura",
                                                              "ancho",
                                                              "largeur",
                                                              "larghezza",
                                                              "\xE5\xB9\x85",
                                                              "\xED\x8F\xAD",
                                                              "largura",
                                                              "\xD0\xA8\xD0\xB8\xD1\x80\xD0\xB8\xD0\xBD\xD0\xB0"};
inline constexpr std::array<std::string_view, 9> height_words{"v\xC3\xBD\xC5\xA1ka",
                                                              "h\xC3\xB6he",
                                                              "altura",
                                                              "alto",
                                                              "hauteur",
                                                              "altezza",
                                                              "\xE9\xAB\x98\xE3\x81\x95",
                                                              "\xEB\x86\x92\xEC\x9D\xB4",
                                                              "\xD0\x92\xD1\x8B\xD1\x81\xD0\xBE\xD1\x82\xD0\xB0"};
// "Value units: m"; "einheit" is of Keyence too
inline constexpr std::array<std::string_view, 14> height_unit_words{
    "jednotky hodnot",
    "einheiten",
    "einheit",
    "wert-einheiten",
    "werteinheiten",
    "einheiten der werte",
    "unit\xC3\xA9s",
    "unit\xC3\xA9s de valeur",
    "unit\xC3\xA0 valore",
    "unidades de valor",
    "unidades do valor",
    "\xE5\x80\xA4\xE3\x81\xAE\xE5\x8D\x98\xE4\xBD\x8D",
    "\xEA\xB0\x92 \xEB\x8B\xA8\xEC\x9C\x84",
    "\xD0\x95\xD0\xB4\xD0\xB8\xD0\xBD\xD0\xB8\xD1\x86\xD1\x8B \xD0\xB8\xD0\xB7\xD0\xBC\xD0\xB5\xD1\x80\xD0\xB5\xD0\xBD"
    "\xD0\xB8\xD1\x8F"};

// Keyence: "XY Calibration","277.8","nm", "Horizontal","1024", "Vertical","768"
inline constexpr std::array<std::string_view, 4> pitch_words{
    "xy calibration", "xy-justierung", "xy-kalibrierung",
    "xy\xEC\xBA\x98\xEB\xA6\xAC\xEB\xB8\x8C\xEB\xA0\x88\xEC\x9D\xB4\xEC\x85\x98"};
inline constexpr std::array<std::string_view, 3> columns_words{"horizontal", "horizont.", "\xEA\xB0\x80\xEB\xA1\x9C"};
// of a profile: Hommel's "Punktabstand", Mitutoyo's "Pitch" and their like
inline constexpr std::array<std::string_view, 24> spacing_words{"resolution",
                                                                "spacing",
                                                                "step",
                                                                "step size",
                                                                "x step size",
                                                                "sampling interval",
                                                                "sampling step",
                                                                "sampling distance",
                                                                "sample spacing",
                                                                "point spacing",
                                                                "data interval",
                                                                "measuring pitch",
                                                                "measurement pitch",
                                                                "pitch",
                                                                "x pitch",
                                                                "pitch x",
                                                                "data pitch",
                                                                "punktabstand",
                                                                "messpunktabstand",
                                                                "abtastabstand",
                                                                "abtastschritt",
                                                                "schrittweite",
                                                                "pas",
                                                                "paso"};
// units of the axes: attocube's "x-unit: um", Nova's "Unit X = um", and their like
inline constexpr std::array<std::string_view, 24> x_unit_words{
    "x unit",        "x-unit",          "unit x",       "units x",     "x units",       "x-units",
    "xunit",         "xunits",          "x axis unit",  "x-einheit",   "einheit x",     "lateral unit",
    "lateral units", "horizontal unit", "xy unit",      "xy units",    "position unit", "xy-unit",
    "unit xy",       "units xy",        "unit lateral", "length unit", "xyunits",       "unitx"};
inline constexpr std::array<std::string_view, 12> y_unit_words{"unity",   "y unit",      "y-unit",    "unit y",
                                                               "units y", "y units",     "y-units",   "yunit",
                                                               "yunits",  "y axis unit", "y-einheit", "einheit y"};
inline constexpr std::array<std::string_view, 3> rows_words{"vertical", "vertikal", "\xEC\x84\xB8\xEB\xA1\x9C"};

/// Whether \p key is \p word, in UTF-8 or in an 8-bit code page.
bool is_word(std::string_view key, std::string_view word);

template <std::size_t N>
bool is_one_of_words(std::string_view key, const std::array<std::string_view, N>& words) {
    if (key.empty()) return false;
    const bool ascii = static_cast<unsigned char>(key.front()) < 0x80;  // most words differ in their first letter
    for (const std::string_view word : words)
        if ((!ascii || key.front() == word.front()) && is_word(key, word)) return true;
    return false;
}

}  // namespace fstiff::inline v0_1::io::detail
