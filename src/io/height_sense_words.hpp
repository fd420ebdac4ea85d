// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Words of titles and headers on the sense and the factor of heights, in the languages of io/header_words.hpp.
///
/// Valid       words in lower case, letters of other code pages as is_word() compares them

#include <array>
#include <string_view>

namespace fstiff::inline v0_1::io::detail {

inline constexpr std::array<std::string_view, 22> depth_words{
    "depth",
    "depths",
    "tiefe",
    "tiefen",
    "profondeur",
    "profondeurs",
    "profundidad",
    "profundidade",
    "profundidades",
    "profondit\xC3\xA0",
    "profondita",
    "diepte",
    "djup",
    "dybde",
    "syvyys",
    "hloubka",
    "g\xC5\x82\xC4\x99\x62oko\xC5\x9B\xC4\x87",
    "derinlik",
    "\xD0\xB3\xD0\xBB\xD1\x83\xD0\xB1\xD0\xB8\xD0\xBD\xD0\xB0",
    "\xE6\xB7\xB1\xE5\xBA\xA6",
    "\xE6\xB7\xB1\xE3\x81\x95",
    "\xEA\xB9\x8A\xEC\x9D\xB4"};
inline constexpr std::array<std::string_view, 18> inversion_words{
    "inverted",     "invert",    "inverts",        "inversion",          "negated",         "invertiert", "invertierte",
    "invertierung", "umgekehrt", "invers\xC3\xA9", "invers\xC3\xA9\x65", "invers\xC3\xA9s", "invertido",  "invertida",
    "invertidos",   "invertito", "invertita",      "invertite"};
/// Where they are next to a word of the heights: a map may be flipped along x.
inline constexpr std::array<std::string_view, 12> turn_words{"down",           "downward",   "downwards", "unten",
                                                             "abw\xC3\xA4rts", "bas",        "abajo",     "baixo",
                                                             "basso",          "gi\xC3\xB9", "flipped",   "flip"};
inline constexpr std::array<std::string_view, 12> upward_words{"height", "heights", "h\xC3\xB6he", "h\xC3\xB6hen",
                                                               "hoehe",  "hoehen",  "hauteur",     "hauteurs",
                                                               "altura", "alturas", "altezza",     "altezze"};
inline constexpr std::array<std::string_view, 13> value_words{"z",      "sign",  "polarity", "vorzeichen", "data",
                                                              "values", "value", "werte",    "daten",      "valeurs",
                                                              "signe",  "signo", "segno"};
inline constexpr std::array<std::string_view, 44> filler_words{
    "v",        "vertical", "vertically", "vertikal", "vertikale", "verticale", "axis",  "direction", "orientation",
    "positive", "surface",  "map",        "profile",  "profil",    "measured",  "point", "points",    "all",
    "the",      "of",       "is",         "are",      "in",        "by",        "with",  "were",      "was",
    "a",        "to",       "achse",      "richtung", "axe",       "eje",       "asse",  "de",        "des",
    "du",       "der",      "die",        "sind",     "la",        "le",        "el",    "di"};
inline constexpr std::array<std::string_view, 12> content_words{
    "channel", "kanal", "canal", "quantity", "content", "signal", "type", "kind", "title", "name", "titel", "image"};
inline constexpr std::array<std::string_view, 8> unit_words{"unit",   "units",    "einheit",      "einheiten",
                                                            "unidad", "unidades", "unit\xC3\xA9", "unit\xC3\xA0"};
inline constexpr std::array<std::string_view, 44> factor_words{"factor",
                                                               "faktor",
                                                               "facteur",
                                                               "fattore",
                                                               "fator",
                                                               "multiplier",
                                                               "multiplied",
                                                               "multiplikator",
                                                               "multiplication",
                                                               "scale",
                                                               "scaled",
                                                               "scaling",
                                                               "skala",
                                                               "skalierung",
                                                               "skaliert",
                                                               "ma\xC3\x9Fstab",
                                                               "massstab",
                                                               "\xC3\xA9\x63helle",
                                                               "echelle",
                                                               "escala",
                                                               "scala",
                                                               "gain",
                                                               "verst\xC3\xA4rkung",
                                                               "verstaerkung",
                                                               "ganancia",
                                                               "guadagno",
                                                               "ganho",
                                                               "magnification",
                                                               "magnified",
                                                               "mag",
                                                               "vergr\xC3\xB6\xC3\x9F\x65rung",
                                                               "vergroesserung",
                                                               "grossissement",
                                                               "agrandissement",
                                                               "aumento",
                                                               "ingrandimento",
                                                               "exaggeration",
                                                               "exaggerated",
                                                               "\xC3\xBC\x62\x65rh\xC3\xB6hung",
                                                               "ueberhoehung",
                                                               "\xC3\xBC\x62\x65rh\xC3\xB6ht",
                                                               "amplification",
                                                               "amplified",
                                                               "divided"};
/// Words that make one word with those of a factor: ZFactor, Skalierungsfaktor.
inline constexpr std::array<std::string_view, 19> factor_prefixes{"z",
                                                                  "height",
                                                                  "heights",
                                                                  "data",
                                                                  "scale",
                                                                  "scaling",
                                                                  "value",
                                                                  "vertical",
                                                                  "v",
                                                                  "h\xC3\xB6hen",
                                                                  "hoehen",
                                                                  "skalierungs",
                                                                  "verst\xC3\xA4rkungs",
                                                                  "\xC3\xBC\x62\x65rh\xC3\xB6hungs",
                                                                  "umrechnungs",
                                                                  "skalen",
                                                                  "ma\xC3\x9Fstabs",
                                                                  "vergr\xC3\xB6\xC3\x9F\x65rungs",
                                                                  "multiplikations"};
/// Between, or after, the numbers of a factor.
inline constexpr std::array<std::string_view, 12> times_words{"times", "fold",  "fach",  "mal", "durch", "fois",
                                                              "veces", "volte", "vezes", "per", "par",   "por"};

}  // namespace fstiff::inline v0_1::io::detail
