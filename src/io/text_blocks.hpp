// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The tables of numbers in one text: exports one after the other, channels of one map, traces one below the other.
///
/// A block begins with lines that state a size, a unit or a channel once more; else with a line that is in the header
/// too, its digits aside, with titles, or after a blank line. These last begin a block only where
///
///     profiles    positions do not go on; heights alone need 16 rows on each side of a blank line
///     triples     x and y do not go on, as they do between the scan lines that gnuplot divides by blank lines
///     matrices    every block has two rows, and their sum is not the stated number of rows
///
/// A block that states no size has the lines of the first header that it does not state itself. Of several blocks the
/// one is read that the options name by its number or its title, else the only one whose heights are in a unit of
/// length, else the only one without a unit. Heights in another unit, such as deg or V, are read in no case.
///
/// Accuracy    none: lines (tests/io/text_blocks_test.cpp)

#include "io/header.hpp"

namespace fstiff::inline v0_1::io::detail {

/// One table of numbers with its header.
struct TextBlock {
    NumberTable table;            // opened
    std::size_t line{};           // of the file, where it begins
    std::string title{}, unit{};  // printable; of the heights, as it is written; empty where none is stated
};

/// The blocks of \p lines, one at least. \throws domain_error where no line is a row of numbers.
std::vector<TextBlock> blocks_of(std::vector<Line> lines, const std::string& name, const SurfaceOptions& options);

/// The block to read, and what a record states of it.
struct ChosenBlock {
    TextBlock block;
    std::string called, others;  // "1 "Height", by ..."; empty where there is one block
};
ChosenBlock chosen_block(std::vector<TextBlock> blocks, const std::string& name, const SurfaceOptions& options);

/// States which block was read, and which were not, where there are several.
void note_channels(Record& record, const ChosenBlock& chosen);

}  // namespace fstiff::inline v0_1::io::detail
