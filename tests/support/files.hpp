// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Files of a test, the lines and parts of a text, and texts that several tests share.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <numbers>
#include <random>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace test {

/// A folder of its own for every test case, gone at its end.
class Folder {
public:
    Folder()
        : path_(std::filesystem::temp_directory_path() / ("fstiff-test-" + std::to_string(std::random_device{}()) +
                                                          "-" + std::to_string(std::random_device{}()))) {
        std::filesystem::create_directory(path_);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    std::string operator/(const std::string& name) const { return (path_ / name).string(); }
    std::string write(const std::string& name, const std::string& bytes) const {
        std::ofstream(*this / name, std::ios::binary) << bytes;
        return *this / name;
    }
    std::size_t files() const {
        return static_cast<std::size_t>(
            std::distance(std::filesystem::directory_iterator(path_), std::filesystem::directory_iterator()));
    }

private:
    std::filesystem::path path_;
};

inline std::string read(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw std::runtime_error("no file " + file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

inline std::vector<std::string> lines(const std::string& text) {
    std::vector<std::string> result;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) result.push_back(line);
    return result;
}

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const auto found = text.find(from);
    if (found == std::string::npos) throw std::runtime_error("the text holds no " + from);
    return text.replace(found, from.size(), to);
}

/// \p all in one text, a line each.
inline std::string joined(const std::vector<std::string>& all) {
    std::string text;
    for (const std::string& line : all) text += line + "\n";
    return text;
}

/// A scene of the data folder with other lines in its [contact] section.
inline std::string scene_with(const std::string& name, const std::map<std::string, std::string>& lines) {
    std::string text = read(FSTIFF_SCENES "/" + name + ".toml");
    for (const auto& [key, line] : lines) {
        const std::string changed = std::regex_replace(text, std::regex("(^|\n)" + key + " *=[^\n]*"), "$1" + line);
        if (changed == text) throw std::runtime_error("the scene has no line for " + key);
        text = changed;
    }
    return text;
}

/// Two round hills as the text of a map: two islands from the highest level down to the saddle, and never more.
inline std::string two_hills() {
    std::string text;
    for (int j = 0; j < 32; ++j)
        for (int i = 0; i < 64; ++i)
            text += std::to_string(1e3 * (1 - std::cos(4 * std::numbers::pi * (i + 0.5) / 64)) *
                                       (1 - std::cos(2 * std::numbers::pi * (j + 0.5) / 32)) +
                                   1e-3 * i * j) +
                    (i == 63 ? "\n" : " ");
    return text;
}

}  // namespace test
