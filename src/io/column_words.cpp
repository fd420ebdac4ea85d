// SPDX-License-Identifier: BSD-3-Clause
#include "io/column_words.hpp"

#include <algorithm>
#include <array>

namespace fstiff::inline v0_1::io::detail {

namespace {

/// Whether \p name is one of \p words, or one of them and what follows its end.
template <std::size_t N>
bool begins_with_word(std::string_view name, const std::array<std::string_view, N>& words) {
    return std::any_of(words.begin(), words.end(), [&](std::string_view word) {
        return name.starts_with(word) &&
               (name.size() == word.size() || name.substr(word.size()).find_first_of(" -_/,.;:") == 0);
    });
}

}  // namespace

bool names_index(std::string_view name) {
    static constexpr std::array<std::string_view, 34> words{
        "#",          "nr",     "no",     "n\xC2\xB0",     "n\xC2\xBA",     "n\xB0",     "n\xBA",      "num",
        "number",     "nummer", "numero", "num\xC3\xA9ro", "n\xC3\xBAmero", "index",     "indice",     "idx",
        "id",         "i",      "n",      "lfd",           "lfd. nr",       "point",     "point no",   "point number",
        "data point", "pt",     "punkt",  "punkt nr",      "punktnummer",   "messpunkt", "datenpunkt", "sample no",
        "zeile",      "row"};
    return std::find(words.begin(), words.end(), name) != words.end() ||
           (name.size() > 3 &&
            begins_with_word(name,
                             std::array<std::string_view, 5>{"index", "point", "punkt", "messpunkt", "datenpunkt"}) &&
            (name.ends_with("nr") || name.ends_with("no") || name.ends_with("number") || name.ends_with("nummer")));
}

bool names_position(std::string_view name) {
    static constexpr std::array<std::string_view, 22> words{
        "x",        "position", "pos",     "distance", "dist",    "lateral",    "length", "l\xC3\xA4nge",
        "l\xE4nge", "laenge",   "abstand", "weg",      "strecke", "horizontal", "scan",   "travel",
        "longueur", "abscissa", "xpos",    "x-achse",  "distanz", "abszisse"};
    return begins_with_word(name, words) || name.ends_with(" position");
}

bool names_neither(std::string_view name) {
    static constexpr std::array<std::string_view, 52> words{"t",
                                                            "time",
                                                            "timestamp",
                                                            "zeit",
                                                            "uhrzeit",
                                                            "temps",
                                                            "tiempo",
                                                            "tempo",
                                                            "elapsed",
                                                            "date",
                                                            "datum",
                                                            "intensity",
                                                            "intensit\xC3\xA4t",
                                                            "intensit\xE4t",
                                                            "intensite",
                                                            "int",
                                                            "quality",
                                                            "qual",
                                                            "q",
                                                            "g\xC3\xBCte",
                                                            "g\xFCte",
                                                            "snr",
                                                            "signal",
                                                            "confidence",
                                                            "valid",
                                                            "validity",
                                                            "flag",
                                                            "flags",
                                                            "status",
                                                            "state",
                                                            "code",
                                                            "mask",
                                                            "weight",
                                                            "brightness",
                                                            "temperature",
                                                            "temp",
                                                            "force",
                                                            "load",
                                                            "speed",
                                                            "velocity",
                                                            "red",
                                                            "green",
                                                            "blue",
                                                            "grey",
                                                            "gray",
                                                            "qualit\xC3\xA4t",
                                                            "qualit\xE4t",
                                                            "qualitaet",
                                                            "qualit\xC3\xA9",
                                                            "qualite",
                                                            "calidad",
                                                            "qualita"};
    return begins_with_word(name, words);
}

bool names_error(std::string_view name) {
    static constexpr std::array<std::string_view, 12> words{
        "dz", "error", "err", "std", "stdev", "sd", "noise", "fehler", "uncertainty", "unsicherheit", "sigma z", "u z"};
    return begins_with_word(name, words);
}

bool names_height(std::string_view name) {
    static constexpr std::array<std::string_view, 27> words{"z",
                                                            "height",
                                                            "h\xC3\xB6he",
                                                            "h\xF6he",
                                                            "hoehe",
                                                            "vertical",
                                                            "vertikal",
                                                            "profile",
                                                            "profil",
                                                            "hauteur",
                                                            "altura",
                                                            "altezza",
                                                            "depth",
                                                            "roughness",
                                                            "rauheit",
                                                            "topography",
                                                            "topographie",
                                                            "surface",
                                                            "elevation",
                                                            "deviation",
                                                            "relief",
                                                            "profilh\xC3\xB6he",
                                                            "profilh\xF6he",
                                                            "profilhoehe",
                                                            "total profile",
                                                            "primary profile",
                                                            "roughness profile"};
    return begins_with_word(name, words) && !name.ends_with("position");
}

bool names_pixel(std::string_view name) {
    static constexpr std::array<std::string_view, 17> words{"col",     "column",  "row",     "line", "pixel", "pixels",
                                                            "px",      "ix",      "iy",      "i",    "j",     "pixel x",
                                                            "pixel y", "x pixel", "y pixel", "x px", "y px"};
    return std::find(words.begin(), words.end(), name) != words.end();
}

}  // namespace fstiff::inline v0_1::io::detail
