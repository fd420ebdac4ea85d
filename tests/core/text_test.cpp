// SPDX-License-Identifier: BSD-3-Clause
// Numbers to text and back: bit for bit, correctly rounded, the same in every locale. Built twice: with what the
// standard library has, and with the substitutes of core/text.hpp (test_text_substitutes).
#include <fstiff/core/text.hpp>

#include "support/skip.hpp"

#include <bit>
#include <clocale>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace text_test {

namespace {

template <class T>
struct Read {
    T value = T(-7);  // what it stays when nothing is read
    std::size_t length = 0;
    std::errc error{};
};

template <class T>
Read<T> decimal(std::string_view text) {
    Read<T> read;
    const auto [end, error] = fstiff::detail::read_decimal(text.data(), text.data() + text.size(), read.value);
    read.length = static_cast<std::size_t>(end - text.data());
    read.error = error;
    return read;
}

template <class T>
Read<T> hexadecimal(std::string_view text) {
    Read<T> read;
    const auto [end, error] = fstiff::detail::read_hexadecimal(text.data(), text.data() + text.size(), read.value);
    read.length = static_cast<std::size_t>(end - text.data());
    read.error = error;
    return read;
}

template <class T>
using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;

template <class T>
bool is_whole(const Read<T>& read, T value, const std::string& text) {
    return read.error == std::errc() && read.length == text.size() &&
           std::bit_cast<Bits<T>>(read.value) == std::bit_cast<Bits<T>>(value);
}

/// The ends of the range, and finite numbers with random bits.
template <class T>
std::vector<T> numbers() {
    using Limits = std::numeric_limits<T>;
    std::vector<T> all{T(0),
                       -T(0),
                       T(1),
                       T(0.1),
                       T(-2.5),
                       T(100000),
                       T(123456789),
                       Limits::min(),
                       Limits::lowest(),
                       Limits::max(),
                       Limits::denorm_min(),
                       Limits::min() - Limits::denorm_min()};
    std::mt19937_64 random(1);
    while (all.size() < 2000)
        if (const T x = std::bit_cast<T>(static_cast<Bits<T>>(random())); std::isfinite(x)) all.push_back(x);
    return all;
}

}  // namespace

TEMPLATE_TEST_CASE("numbers come back from text bit for bit", "[text]", float, double) {
    using T = TestType;
    int wrong = 0;
    for (const T x : numbers<T>()) {
        const std::string shortest = fstiff::detail::shortest_text(x), hex = fstiff::detail::hexadecimal_text(x);
        const std::string digits = fstiff::detail::rounded_text(x, std::numeric_limits<T>::max_digits10);
        wrong += !is_whole(decimal<T>(shortest), x, shortest) || !is_whole(decimal<T>(digits), x, digits) ||
                 !is_whole(hexadecimal<T>(hex), x, hex);
    }
    CHECK(wrong == 0);
}

TEST_CASE("text has the digits that were asked for", "[text]") {
    CHECK(fstiff::detail::shortest_text(0.1) == "0.1");
    CHECK(fstiff::detail::shortest_text(0.1f) == "0.1");
    CHECK(fstiff::detail::shortest_text(0.30000000000000004) == "0.30000000000000004");
    CHECK(fstiff::detail::shortest_text(-1.5e-300) == "-1.5e-300");
    CHECK(fstiff::detail::shortest_text(3.0) == "3");
    CHECK(fstiff::detail::rounded_text(2.0 / 3, 4) == "0.6667");
    CHECK(fstiff::detail::rounded_text(0.1, 17) == "0.10000000000000001");
    CHECK(fstiff::detail::rounded_text(1234567.5, 15) == "1234567.5");
    CHECK(fstiff::detail::rounded_text(1e-7, 10) == "1e-07");
    CHECK(fstiff::detail::rounded_text(0.1f, 6) == "0.1");
    CHECK(fstiff::detail::rounded_text(0.1f, 7) == "0.1");
    CHECK(fstiff::detail::fixed_text(2.0 / 3, 1) == "0.7");
    CHECK(fstiff::detail::fixed_text(-0.04, 1) == "-0.0");
    CHECK(fstiff::detail::fixed_text(0.1f, 3) == "0.100");
    CHECK(fstiff::detail::fixed_text(1e300, 2).size() == 304);
    CHECK(fstiff::detail::hexadecimal_text(0.375) == "1.8p-2");
    CHECK(fstiff::detail::hexadecimal_text(-3.0f) == "-1.8p+1");
    CHECK(fstiff::detail::shortest_text(std::numeric_limits<double>::infinity()) == "inf");
    CHECK(fstiff::detail::rounded_text(-std::numeric_limits<double>::infinity(), 4) == "-inf");
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double of : {nan, std::copysign(nan, -1.0)}) {  // whose sign nobody gave
        CHECK(fstiff::detail::rounded_text(of, 4) == "nan");
        CHECK(fstiff::detail::shortest_text(of) == "nan");
        CHECK(fstiff::detail::fixed_text(of, 2) == "nan");
        CHECK(fstiff::detail::rounded_text(static_cast<float>(of), 4) == "nan");
    }
}

TEST_CASE("reading is rounded once and takes no more than the number", "[text]") {
    CHECK(decimal<double>("9007199254740993").value == 9007199254740992.0);  // 2^53 + 1: half way, to even
    CHECK(decimal<double>("9007199254740993.0000000000000000000000000000000001").value == 9007199254740994.0);
    CHECK(decimal<float>("1.00000017881393432617187499").value == 1.00000011920928955078125f);  // not by way of double
    CHECK(decimal<float>("1.00000017881393432617187501").value == 1.0000002384185791015625f);
    struct Case {
        std::string text;
        double value;
        std::size_t length;
    };
    for (const auto& [text, value, length] : {Case{"1.5 um", 1.5, 3},
                                              {"1e5x", 1e5, 3},
                                              {"1e+5", 1e5, 4},
                                              {"2em", 2, 1},
                                              {"2e+", 2, 1},
                                              {"1.", 1, 2},
                                              {".5", .5, 2},
                                              {"-.5e-1,", -.05, 6},
                                              {"0x10", 0, 1},
                                              {"1,5", 1, 1},
                                              {"007", 7, 3},
                                              {"1.2.3", 1.2, 3}}) {
        INFO(text);
        const auto read = decimal<double>(text);
        CHECK((read.error == std::errc() && read.value == value && read.length == length));
    }
    CHECK(hexadecimal<double>("1.8p-2 1").value == 0.375);
    CHECK(hexadecimal<double>("ap1").value == 20);
}

TEST_CASE("text without a number is not read", "[text]") {
    for (const std::string text : {"", " 1", "+1", "-", ".", "-.", "e5", "inf", "nan", "-inf", "INF", ",5", "um"}) {
        INFO(text);
        const auto read = decimal<double>(text);
        CHECK((read.error == std::errc::invalid_argument && read.value == -7 && read.length == 0));
    }
    CHECK(hexadecimal<double>("inf").error == std::errc::invalid_argument);
    CHECK(hexadecimal<double>("p1").error == std::errc::invalid_argument);
}

TEST_CASE("a number beyond the range of its type is reported", "[text]") {
    for (const std::string text : {"1e400", "-1e400", "1e-400", "0.0001e-400", "1e99999999999999999999"}) {
        INFO(text);
        const auto read = decimal<double>(text);
        CHECK((read.error == std::errc::result_out_of_range && read.value == -7 && read.length == text.size()));
    }
    CHECK(decimal<float>("1e39").error == std::errc::result_out_of_range);
    CHECK(decimal<float>("1e-50").error == std::errc::result_out_of_range);
    CHECK(hexadecimal<double>("1p1024").error == std::errc::result_out_of_range);
    CHECK(decimal<double>("0e-999").value == 0);
    CHECK(decimal<double>("5e-324").value == std::numeric_limits<double>::denorm_min());
}

TEST_CASE("a decimal comma in the locale of C changes nothing", "[text]") {
    const std::string before = std::setlocale(LC_ALL, nullptr);
    bool set = false;
    for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "de_DE", "fr_FR.UTF-8", "ps_AF"})
        set = set || std::setlocale(LC_ALL, name) != nullptr;
    if (!set) SKIP_CASE("no locale with a decimal comma is installed");
    const std::string shortest = fstiff::detail::shortest_text(-1234.5),
                      rounded = fstiff::detail::rounded_text(1234567.5, 15);
    const std::string fixed = fstiff::detail::fixed_text(1234567.5f, 1), hex = fstiff::detail::hexadecimal_text(0.375);
    const auto point = decimal<double>("1.5"), comma = decimal<double>("1,5");
    const double back = hexadecimal<double>(hex).value;
    std::setlocale(LC_ALL, before.c_str());
    CHECK(shortest == "-1234.5");
    CHECK(rounded == "1234567.5");
    CHECK(fixed == "1234567.5");
    CHECK(hex == "1.8p-2");
    CHECK((point.value == 1.5 && comma.value == 1 && comma.length == 1 && back == 0.375));
}

}  // namespace text_test
