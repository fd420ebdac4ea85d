// SPDX-License-Identifier: BSD-3-Clause
// Lines, and refusals with their place: the sentences are written out.
#include "io/lines.hpp"

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <sstream>
#include <streambuf>
#include <string>
#include <tuple>
#include <utility>

namespace lines_test {

using namespace fstiff;
using namespace fstiff::io::detail;

TEST_CASE("lines are trimmed, counted and left out when blank", "[lines]") {
    std::size_t count = 0;
    const auto lines = lines_of("a\r\n\r\n  b\t\n \nc", "file", count);
    CHECK(count == 5);
    REQUIRE(lines.size() == 3);
    CHECK(lines[0].text == "a");
    CHECK(lines[1].text == "b\t");  // a tab may end an empty cell
    CHECK(lines[1].number == 3);
    CHECK(lines[2].number == 5);
    CHECK(lines_of("a\rb", "file", count).size() == 2);
    CHECK(test::refusal([&] { (void)lines_of("1\n" + std::string((1u << 20) + 1, '1'), "file", count); }) ==
          "file, line 2: is longer than 2^20 characters; must be shorter");
}

namespace {

/// Endless input: a text, again and again.
class Endless : public std::streambuf {
public:
    explicit Endless(std::string text) : text_(std::move(text)) {}
    std::size_t read = 0;  ///< bytes

protected:
    int_type underflow() override {
        setg(text_.data(), text_.data(), text_.data() + text_.size());
        return traits_type::to_int_type(text_.front());
    }
    std::streamsize xsgetn(char* to, std::streamsize count) override {
        for (std::streamsize i = 0; i < count; ++i) to[i] = text_[read++ % text_.size()];
        return count;
    }

private:
    std::string text_;
};

}  // namespace

TEST_CASE("Endless text that holds no surface is refused after its first mebibytes", "[lines]") {
    for (const auto& [text, sentence, most] :
         {std::tuple("y", "endless, line 1: is longer than 2^20 characters; must be shorter", std::size_t(2) << 20),
          std::tuple("1,", "endless, line 1: is longer than 2^20 characters; must be shorter", std::size_t(2) << 20),
          std::tuple("y\n", "endless: has no digit in its first 4 MiB; must hold numbers", std::size_t(5) << 20)}) {
        Endless buffer(text);
        std::istream input(&buffer);
        std::string bytes;
        CHECK(test::refusal([&] { append_bytes(input, "endless", bytes); }) == sentence);
        CHECK(buffer.read < most);
    }
    std::istringstream later("1\n2\n" + std::string((1u << 20) + (1u << 17), '3') + "\n4\n");
    std::string bytes;
    CHECK(test::refusal([&] { append_bytes(later, "later", bytes); }) ==
          "later, line 3: is longer than 2^20 characters; must be shorter");
    std::istringstream json("{" + std::string(3u << 20, ' ') + "}");  // of which one line may be the whole
    bytes.clear();
    append_bytes(json, "json", bytes);
    CHECK(bytes.size() == (3u << 20) + 2);
}

TEST_CASE("a file is refused with its place as a field", "[lines]") {
    try {
        refuse_line("a.txt", 7, {"holds ", 3, " points of ", 0.5, " m; must be ", std::string("more")});
    } catch (const domain_error& error) {
        CHECK(std::string(error.what()) == "a.txt, line 7: holds 3 points of 0.5 m; must be more");
        CHECK(error.place().file == "a.txt");
        CHECK(error.place().line == 7);
        CHECK(error.reason() == "holds 3 points of 0.5 m; must be more");
    }
    try {
        refuse_field("a.sdf", "DataType", "9", "between 0 and 7");
    } catch (const domain_error& error) {
        CHECK(std::string(error.what()) == "a.sdf: DataType = 9: must be between 0 and 7");
        CHECK(error.parameter() == "DataType");
        CHECK(error.place().file == "a.sdf");
    }
    CHECK_THROWS_AS(refuse_file("a", {"b"}), domain_error);
    CHECK_THROWS_AS(refuse_field("a", "b", "c", "d"), domain_error);
}

TEST_CASE("a stream that breaks off is a file that cannot be read", "[lines]") {
    std::istringstream good("12");
    CHECK(read_bytes(good, "file").bytes == "12");
    struct Broken : std::streambuf {
        int_type underflow() override { throw 1; }
    } buffer;
    std::istream broken(&buffer);
    CHECK_THROWS_AS(read_bytes(broken, "file"), file_error);
    CHECK_THROWS_AS(read_bytes(std::filesystem::path("no/such/file"), "anything"), file_error);
    CHECK_THROWS_AS(read_bytes(std::filesystem::temp_directory_path(), "anything"), file_error);
}

TEST_CASE("a text is no text when it holds NUL or nothing, and loses its byte order mark", "[lines]") {
    CHECK(text_of("\xEF\xBB\xBF"
                  "1",
                  "file", "rows") == "1");
    CHECK(test::refusal([] { (void)text_of("", "file", "rows"); }) ==
          "file: is empty; must be delimited text with rows");
    CHECK_FALSE(test::refusal([] { (void)text_of(std::string("1\0", 2), "file", "rows"); }).empty());
}

}  // namespace lines_test
